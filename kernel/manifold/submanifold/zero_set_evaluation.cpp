#include <algorithm>
#include <cmath>

#include "kernel/manifold/submanifold/chart_fitting.hpp"
#include "kernel/manifold/submanifold/chord_bend.hpp"
#include "kernel/manifold/submanifold/cover_check.hpp"
#include "kernel/manifold/submanifold/fibre_zero.hpp"
#include "kernel/manifold/submanifold/singular_search.hpp"
#include "kernel/manifold/submanifold/zero_set.hpp"
#include "kernel/number/middle.hpp"

namespace delcert {

namespace {

Interval middle_of_entry(const Interval& x) { return Interval::exactly(middle_of(x)); }

class ZeroSetEvaluation final : public GraphEvaluation {
 public:
  explicit ZeroSetEvaluation(const ZeroSet& zero_set) : zero_set_(zero_set) {}

  std::optional<std::vector<Interval>> heights(const TangentChart& chart, const Interval* y) override {
    return zero_on_fibre<Interval>(in_doubles(), chart.enclosed(), y);
  }
  std::optional<std::vector<BigInterval>> heights(const TangentChart& chart, const BigInterval* y) override {
    FormulaEvaluation<BigInterval> f(zero_set_.map());
    return zero_on_fibre<BigInterval>(f, chart.on<BigInterval>(), y);
  }
  std::optional<std::vector<Rational>> heights(const TangentChart&, const Rational*) override { return std::nullopt; }

  /// Df(x̄) + D²f·(p′_v − x̄) at each vertex: on the simplex Df is a convex combination of such.
  bool enclose(const TangentChart&, std::span<const Interval* const> vertices, double displacement,
               DerivativeHull& hull) override {
    const std::size_t n = zero_set_.ambient();
    const std::size_t q = zero_set_.codimension();
    std::vector<Interval> box(n);
    std::vector<Interval> middle(n);
    std::vector<Interval> f(q);
    Dense<Interval> at_middle(q * n);
    Dense<Interval> first(q * n);
    Dense<Interval> second(q * n * n);
    const Interval around = Interval::between(-displacement, displacement);
    for (std::size_t axis = 0; axis < n; ++axis) {
      Interval side = vertices[0][axis];
      for (const Interval* x : vertices)
        side = Interval::between(std::min(side.lower(), x[axis].lower()), std::max(side.upper(), x[axis].upper()));
      middle[axis] = middle_of_entry(side);
      box[axis] = side + around;
    }
    if (!in_doubles().first(middle.data(), f.data(), at_middle.data())) return false;
    if (!in_doubles().second(box.data(), f.data(), first.data(), second.data())) return false;
    hull.matrices.clear();
    for (const Interval* x : vertices) {
      Dense<Interval>& matrix = hull.matrices.emplace_back(at_middle);
      for (std::size_t row = 0; row < q * n; ++row) {
        for (std::size_t axis = 0; axis < n; ++axis) matrix[row] += second[row * n + axis] * (x[axis] - middle[axis]);
      }
    }
    Interval squared(0);
    for (const Interval& entry : second) squared += square(entry);
    hull.spread = square_root(squared) * Interval::exactly(displacement);
    hull.height = height_between(vertices, second);
    return true;
  }

  /// D²z[e, e] = −(J·N)⁻¹·D²f[(E + N·Dz)e, (E + N·Dz)e].
  std::optional<SlopeChange> slope_change(const TangentChart& chart, const Interval* place,
                                          const Interval& slope) override {
    const EnclosedChart<Interval>& of = chart.enclosed();
    const std::size_t n = zero_set_.ambient();
    const std::size_t q = zero_set_.codimension();
    const std::size_t m = n - q;
    std::vector<Interval> box(n);
    std::vector<Interval> middle(n);
    of.position(place, box.data());
    for (std::size_t axis = 0; axis < n; ++axis) middle[axis] = middle_of_entry(box[axis]);
    std::vector<Interval> f(q);
    std::vector<Interval> first(q * n);
    std::vector<Interval> at_middle(q * n);
    std::vector<Interval> second(q * n * n);
    if (!in_doubles().first(middle.data(), f.data(), at_middle.data())) return std::nullopt;
    if (!in_doubles().second(box.data(), f.data(), first.data(), second.data())) return std::nullopt;
    std::array<Interval, 3> squares{};  // of both arguments in the plane, one of them, none
    Interval defect(0);
    for (std::size_t row = 0; row < q; ++row) {
      std::vector<Interval> bent(n * n);  // Y·D²f
      std::vector<Interval> sloped(n);    // Y·J
      for (std::size_t b = 0; b < q; ++b) {
        const Interval& weight = of.preconditioner[row * q + b];
        for (std::size_t entry = 0; entry < n * n; ++entry) bent[entry] += weight * second[b * n * n + entry];
        for (std::size_t axis = 0; axis < n; ++axis) {
          Interval j = at_middle[b * n + axis];
          for (std::size_t k = 0; k < n; ++k) j += second[(b * n + axis) * n + k] * (box[k] - middle[k]);
          sloped[axis] += weight * j;
        }
      }
      for (std::size_t one = 0; one < n; ++one) {
        std::vector<Interval> turned(n);
        for (std::size_t axis = 0; axis < n; ++axis) {
          for (std::size_t k = 0; k < n; ++k) turned[axis] += bent[axis * n + k] * of.at(k, one);
        }
        for (std::size_t other = 0; other < n; ++other) {
          Interval entry(0);
          for (std::size_t axis = 0; axis < n; ++axis) entry += turned[axis] * of.at(axis, other);
          squares.at((one < m ? 0U : 1U) + (other < m ? 0U : 1U)) += square(entry);
        }
        if (one < m) continue;
        Interval entry(one - m == row ? -1 : 0);
        for (std::size_t axis = 0; axis < n; ++axis) entry += sloped[axis] * of.at(axis, one);
        defect += square(entry);
      }
    }
    const Interval rest = Interval(1) - square_root(defect);
    if (!is_proved(less(Interval(0), rest))) return std::nullopt;
    // Mixed blocks are in `squares` twice.
    return SlopeChange{(square_root(squares[0]) + Interval(2) * slope * square_root(squares[1] / Interval(2)) +
                        square(slope) * square_root(squares[2])) /
                       rest};
  }

  std::optional<ChordBend> chord_bend(const Interval* from, const Interval* to) override {
    return bend_about_chords(zero_set_, in_doubles(), from, to);
  }

 private:
  FormulaEvaluation<Interval>& in_doubles() {
    if (!in_doubles_) in_doubles_.emplace(zero_set_.map());
    return *in_doubles_;
  }

  /// sup|f| on the simplex, at most m/(4(m + 1))·(max |Ā[e,e]| + ‖rad A‖·ℓ²) where f is 0 at the vertices, A = D²f.
  [[nodiscard]] double height_between(std::span<const Interval* const> vertices, const Dense<Interval>& second) const {
    const std::size_t n = zero_set_.ambient();
    const std::size_t q = zero_set_.codimension();
    const auto m = static_cast<int>(vertices.size()) - 1;
    Interval deviation_squared(0);
    for (const Interval& entry : second) deviation_squared += square(entry - middle_of_entry(entry));
    double bent = 0;
    double longest_squared = 0;
    for (std::size_t v = 0; v < vertices.size(); ++v) {
      for (std::size_t w = 0; w < v; ++w) {
        std::array<Interval, most_ambient_dimensions> edge;
        Interval length_squared(0);
        for (std::size_t axis = 0; axis < n; ++axis) {
          edge[axis] = vertices[v][axis] - vertices[w][axis];
          length_squared += square(edge[axis]);
        }
        longest_squared = std::max(longest_squared, length_squared.upper());
        Interval squared(0);
        for (std::size_t k = 0; k < q; ++k) {
          Interval value(0);
          for (std::size_t row = 0; row < n; ++row) {
            Interval sum(0);
            for (std::size_t axis = 0; axis < n; ++axis)
              sum += middle_of_entry(second[(k * n + row) * n + axis]) * edge[axis];
            value += edge[row] * sum;
          }
          squared += square(value);
        }
        bent = std::max(bent, square_root(squared).upper());
      }
    }
    const Interval curved =
        Interval::exactly(bent) + square_root(deviation_squared) * Interval::exactly(longest_squared);
    return (curved * Interval(m) / Interval(4 * (m + 1))).upper();
  }

  const ZeroSet& zero_set_;
  std::optional<FormulaEvaluation<Interval>> in_doubles_;
};

class ZeroSetSampler final : public ManifoldSampler {
 public:
  ZeroSetSampler(const ZeroSet& zero_set, double step)
      : n_(zero_set.ambient()),
        q_(zero_set.codimension()),
        step_(step),
        f_(zero_set.map()),
        value_(q_),
        derivative_(q_ * n_) {
    for (const auto& side : zero_set.box()) box_.push_back({approximate_double(side[0]), approximate_double(side[1])});
  }

  std::vector<double> dart(CounterRandom& random) override {
    std::vector<double> x(n_);
    for (std::size_t axis = 0; axis < n_; ++axis)
      x[axis] = box_[axis][0] + random.next_unit() * (box_[axis][1] - box_[axis][0]);
    return x;
  }

  /// Newton's method, along the normal columns of the frame, or by least steps.
  bool project(std::vector<double>& x, const Dense<double>* frame) override {
    constexpr int most_newton_steps = 40;
    const std::size_t m = n_ - q_;
    Dense<double> directions(n_ * q_);
    Dense<double> normal(q_ * q_);
    for (int step = 0; step < most_newton_steps; ++step) {
      if (!f_.first(x.data(), value_.data(), derivative_.data())) return false;
      for (std::size_t axis = 0; axis < n_; ++axis) {
        for (std::size_t b = 0; b < q_; ++b)
          directions[axis * q_ + b] = frame != nullptr ? (*frame)[axis * n_ + m + b] : derivative_[b * n_ + axis];
      }
      std::fill(normal.begin(), normal.end(), 0);
      for (std::size_t row = 0; row < q_; ++row) {
        for (std::size_t axis = 0; axis < n_; ++axis) {
          for (std::size_t b = 0; b < q_; ++b)
            normal[row * q_ + b] += derivative_[row * n_ + axis] * directions[axis * q_ + b];
        }
      }
      const auto inverse = inverse_of(normal, q_);
      if (!inverse) return false;
      double longest = 0;
      for (std::size_t axis = 0; axis < n_; ++axis) {
        double change = 0;
        for (std::size_t b = 0; b < q_; ++b) {
          double weight = 0;
          for (std::size_t row = 0; row < q_; ++row) weight += (*inverse)[b * q_ + row] * value_[row];
          change += directions[axis * q_ + b] * weight;
        }
        x[axis] -= change;
        longest = std::max(longest, std::fabs(change));
      }
      if (!(longest < 0x1p+40)) return false;
      if (longest < step_) return true;
    }
    return false;
  }

  std::optional<Dense<double>> normals(const std::vector<double>& x) override {
    if (!f_.first(x.data(), value_.data(), derivative_.data())) return std::nullopt;
    return derivative_;
  }
  std::string advice(const std::vector<double>&) override { return "take a smaller one"; }

  double curvature(const std::vector<double>& x) override {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const std::size_t m = n_ - q_;
    Dense<double> second(q_ * n_ * n_);
    if (!f_.second(x.data(), value_.data(), derivative_.data(), second.data())) return infinity;
    const auto proposed = propose_frame(derivative_, q_, n_);
    if (!proposed) return infinity;
    const auto at = [&](std::size_t axis, std::size_t column) { return proposed->frame[axis * n_ + column]; };
    Dense<double> normal(q_ * q_, 0);
    for (std::size_t row = 0; row < q_; ++row) {
      for (std::size_t b = 0; b < q_; ++b) {
        for (std::size_t axis = 0; axis < n_; ++axis)
          normal[row * q_ + b] += derivative_[row * n_ + axis] * at(axis, m + b);
      }
    }
    const auto inverse = inverse_of(std::move(normal), q_);
    if (!inverse) return infinity;
    // Of the graph over the plane, Y·D²f[E, E].
    Dense<double> bends(q_ * m * m, 0);
    for (std::size_t k = 0; k < m; ++k) {
      for (std::size_t l = 0; l < m; ++l) {
        for (std::size_t b = 0; b < q_; ++b) {
          double bent = 0;
          for (std::size_t a = 0; a < n_; ++a) {
            for (std::size_t c = 0; c < n_; ++c) bent += second[(b * n_ + a) * n_ + c] * at(a, k) * at(c, l);
          }
          for (std::size_t row = 0; row < q_; ++row) bends[(row * m + k) * m + l] += (*inverse)[row * q_ + b] * bent;
        }
      }
    }
    double trace = 0;
    double rest = 0;
    for (std::size_t row = 0; row < q_; ++row) {
      double mean = 0;
      for (std::size_t k = 0; k < m; ++k) mean += bends[(row * m + k) * m + k] / static_cast<double>(m);
      trace += mean * mean;
      for (std::size_t k = 0; k < m; ++k) {
        for (std::size_t l = 0; l < m; ++l) {
          const double entry = bends[(row * m + k) * m + l] - (k == l ? mean : 0);
          rest += entry * entry;
        }
      }
    }
    // A traceless symmetric matrix has a spectral norm of at most √((m − 1)/m) times that of Frobenius.
    return std::sqrt(trace) + std::sqrt(rest * static_cast<double>(m - 1) / static_cast<double>(m));
  }

 private:
  std::size_t n_;
  std::size_t q_;
  double step_;
  FormulaEvaluation<double> f_;
  std::vector<double> value_;
  Dense<double> derivative_;
  std::vector<std::array<double, 2>> box_;
};

}  // namespace

std::unique_ptr<GraphEvaluation> ZeroSet::evaluation() const { return std::make_unique<ZeroSetEvaluation>(*this); }

std::unique_ptr<ManifoldSampler> ZeroSet::sampler(double radius) const {
  return std::make_unique<ZeroSetSampler>(*this, net_step(radius));
}

FittedCharts ZeroSet::fit_charts(const std::vector<std::vector<Rational>>& centres, const SamplingRadii& radii,
                                 const Progress& progress) const {
  return delcert::fit_charts(*this, centres, radii, progress);
}

CoverReport ZeroSet::check_cover(const std::vector<TangentChart>& charts, const Progress& progress) const {
  return delcert::check_cover(*this, charts, progress);
}

std::optional<BoxPart> ZeroSet::singular_part() const { return find_singular_part(*this); }

}  // namespace delcert
