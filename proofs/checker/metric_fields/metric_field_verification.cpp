#include "proofs/checker/certificate/metric_field.hpp"
#include "proofs/checker/metric_fields/metric_field_levels.hpp"

namespace delcert::checker {
namespace {

constexpr std::size_t most_boxes_of_patch = std::size_t{1} << 14;

template <class N>
SquareMatrix<N> combination(const N& a, const SquareMatrix<N>& x, const N& b, const SquareMatrix<N>& y) {
  SquareMatrix<N> result(x.order());
  for (std::size_t i = 0; i < x.order(); ++i) {
    for (std::size_t k = 0; k < x.order(); ++k) result(i, k) = a * x(i, k) + b * y(i, k);
  }
  return result;
}

SquareMatrix<Ball> balls(const SquareMatrix<Rational>& a) {
  SquareMatrix<Ball> result(a.order());
  for (std::size_t i = 0; i < a.order(); ++i) {
    for (std::size_t k = 0; k < a.order(); ++k) result(i, k) = Ball(a(i, k));
  }
  return result;
}

/// low x < y < high x, as quadratic forms.
template <class N>
Verdict is_between(const N& low, const N& high, const SquareMatrix<N>& x, const SquareMatrix<N>& y) {
  return conjunction(is_positive_definite(combination(N(1), y, -low, x)),
                     is_positive_definite(combination(high, x, N(-1), y)));
}

/// (1 - a)^2 x < y < (1 + a)^2 x.
template <class N>
Verdict is_distorted_by_less(const N& a, const SquareMatrix<N>& x, const SquareMatrix<N>& y) {
  return is_between(square(N(1) - a), square(N(1) + a), x, y);
}

class ChartChecker {
 public:
  ChartChecker(const Certificate& c, Report& report) : c_(c), field_(*c.metric_field), report_(report) {
    for (Label i = 0; i < c.n; ++i) {
      exact_.push_back(gram_of_chart(c, i));
      filter_.push_back(enclosure(exact_.back()));
    }
  }

  void check(const FieldCharts& charts, Label i) {
    const Vector<Rational> position = c_.net.position<Rational>({i, {}});
    const std::vector<Rational> centre(position.begin(), position.begin() + c_.m);
    const auto reject = [&](const char* rule, const char* what) {
      report_.reject(rule, [&] { return "label " + std::to_string(i) + ": " + what; });
    };
    const bool rounded = decide_with_balls([&] {
      const Ball eta(field_.rounding.exact);
      return is_between(Ball(1) - eta, Ball(1) + eta, field_.at(centre), balls(exact_[i]));
    });
    if (!rounded) reject("field.chart", "the chart is not that of the metric, up to rounding");
    const Rational squared_radius = square(field_.patch_radius.exact);
    Box patch;
    const SquareMatrix<Rational>& inverse = charts.inverse(i);
    bool small = true;
    for (std::size_t k = 0; k < c_.m_size(); ++k) {
      Rational squared_stretch(0);
      for (std::size_t j = k; j < c_.m_size(); ++j) squared_stretch = squared_stretch + square(inverse(k, j));
      small = small && less(Rational(9) * squared_radius * squared_stretch, Rational(1)) == Verdict::proved;
      const double half = upper_root(enclosure(squared_radius * squared_stretch));
      patch.push_back(enclosure(centre[k]) + Interval::between(-half, half));
    }
    if (!small) reject("field.patch", "3 patch_radius, in coordinates, is not below 1");
    const bool near = holds_within(field_, patch, most_boxes_of_patch, [&](const SquareMatrix<Interval>& g) {
      return is_distorted_by_less(field_.metric_distortion.filter, filter_[i], g);
    });
    if (!near) reject("field.metric", "in its patch the metric differs from its chart by more than metric_distortion");
    if (!small) return;
    for (const Vertex& v : charts.originals_around(i, field_.patch_radius.filter.upper())) {
      if (exact_[v.label] == exact_[i]) continue;
      const bool alike = decide(
          [&]<class N>(In<N>) { return is_distorted_by_less(c_.distortion.as<N>(), gram<N>(i), gram<N>(v.label)); });
      if (alike) continue;
      report_.reject("field.distortion", [&] {
        return "charts of " + std::to_string(i) + " and " + std::to_string(v.label) +
               " are distorted by more than distortion";
      });
    }
  }

 private:
  template <class N>
  const SquareMatrix<N>& gram(Label i) const {
    if constexpr (std::is_same_v<N, Interval>) {
      return filter_[i];
    } else {
      return exact_[i];
    }
  }

  const Certificate& c_;
  const MetricField& field_;
  Report& report_;
  std::vector<SquareMatrix<Rational>> exact_;
  std::vector<SquareMatrix<Interval>> filter_;
};

}  // namespace

SquareMatrix<Rational> gram_of_chart(const Certificate& c, std::uint32_t label) {
  const SquareMatrix<Rational> a = upper_triangle(c.m_size(), c.chart_entries(label));
  return a.transposed() * a;
}

std::string check_metric_field(const FieldCharts& charts, Report& report) {
  const Certificate& c = charts.certificate();
  ChartChecker checker(c, report);
  for (Label i = 0; i < c.n; ++i) checker.check(charts, i);
  return std::to_string(c.metric_field->waves.size()) + " waves; " + std::to_string(c.n) +
         " charts, distorted by <= " + rounded_up(c.distortion.exact) +
         ", and by <= " + rounded_up(c.metric_field->metric_distortion.exact) + " from the metric";
}

}  // namespace delcert::checker
