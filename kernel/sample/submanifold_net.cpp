#include "kernel/sample/submanifold_net.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "kernel/number/exact_text.hpp"
#include "kernel/sample/disk_sampling.hpp"
#include "kernel/sample/spatial_order.hpp"
#include "support/error.hpp"

namespace delcert {

namespace {

constexpr std::size_t most_points_of_submanifold = 2000000;
constexpr int most_newton_steps = 40;

/// The points of a zero set as `DiskSampling` takes them: coordinates about a point are those of its tangent plane.
template <int m>
class SubmanifoldPoints {
 public:
  SubmanifoldPoints(const ZeroSet& zero_set, double radius)
      : zero_set_(zero_set),
        radius_(radius),
        n_(zero_set.ambient()),
        q_(zero_set.codimension()),
        f_(zero_set.map()),
        cells_(n_, 4 * radius),
        value_(q_),
        derivative_(q_ * n_) {
    // Doubles of a few digits fewer than they have, so that centres are short.
    step_ = std::ldexp(1.0, std::ilogb(radius) - 30);
    for (const auto& side : zero_set.description().box)
      box_.push_back({approximate_double(side[0]), approximate_double(side[1])});
  }

  bool throw_dart(CounterRandom& random) {
    std::vector<double> x(n_);
    for (std::size_t axis = 0; axis < n_; ++axis)
      x[axis] = box_[axis][0] + random.next_unit() * (box_[axis][1] - box_[axis][0]);
    return insert_from(x);
  }
  /// The point of M to which Newton's method goes from here, unless there is none or another is closer to it than the
  /// radius.
  bool insert_from(std::vector<double> x) {
    if (!newton(x, nullptr) || !is_in_box(x) || !is_free(x)) return false;
    return insert(x);
  }
  void insert_about(std::uint32_t label, const Vector<double, m>& place) {
    const Dense<double>& frame = frames_[label];
    std::vector<double> x(n_);
    for (std::size_t axis = 0; axis < n_; ++axis) {
      x[axis] = cells_[label][axis];
      for (std::size_t k = 0; k < m; ++k) x[axis] += frame[axis * n_ + k] * place[k];
    }
    if (!newton(x, &frame) || height(label, x) > most_slope * 2 * radius_)
      throw Rejection(zero_set_.description().name + ": the manifold is too curved for the sampling radius near " +
                      rough_text({cells_[label], cells_[label] + n_}) + ": take a smaller one");
    if (is_free_in_chart(label, x)) insert(x);
  }
  void look_about(std::uint32_t label, std::vector<Vector<double, m>>& around) const {
    constexpr double reach = DiskSampling<m, SubmanifoldPoints>::reach;
    around.clear();
    std::vector<std::uint32_t> seen;
    cells_.visit(cells_[label], most_stretch * reach * radius_, [&](std::uint32_t other, double) {
      if (other != label) seen.push_back(other);
      return false;
    });
    std::sort(seen.begin(), seen.end());
    for (const std::uint32_t other : seen) {
      const auto place = seen_from(label, cells_[other]);
      if (place && pairing(*place, *place) <= reach * radius_ * (reach * radius_)) around.push_back(*place);
    }
  }
  [[nodiscard]] std::size_t size() const { return cells_.size(); }

  [[nodiscard]] std::vector<std::vector<Rational>> ordered() const {
    std::vector<std::array<double, 4>> places(size());
    for (std::size_t label = 0; label < size(); ++label) {
      for (std::size_t axis = 0; axis < std::min<std::size_t>(n_, 4); ++axis) {
        const double width = box_[axis][1] - box_[axis][0];
        places[label][axis] = 2 * (cells_[label][axis] - box_[axis][0]) / width - 1;
      }
    }
    std::vector<std::vector<Rational>> result;
    for (const std::uint32_t label : spatial_order<4>(places)) {
      auto& centre = result.emplace_back();
      for (std::size_t axis = 0; axis < n_; ++axis) centre.push_back(Rational::exactly(cells_[label][axis]));
    }
    return result;
  }

 private:
  /// What is seen at a steeper angle than this is another sheet.
  static constexpr double most_slope = 1.5;
  static constexpr double most_stretch = 1.5;

  /// Newton's method, along the normal columns of the frame, or by least steps.
  bool newton(std::vector<double>& x, const Dense<double>* frame) {
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

  [[nodiscard]] bool is_in_box(const std::vector<double>& x) const {
    for (std::size_t axis = 0; axis < n_; ++axis) {
      if (!(x[axis] > box_[axis][0] && x[axis] < box_[axis][1])) return false;
    }
    return true;
  }

  bool insert(std::vector<double> x) {
    if (size() == most_points_of_submanifold)
      throw Rejection("a net of this radius has more than " + std::to_string(most_points_of_submanifold) +
                      " points, which is the most that is supported");
    for (double& coordinate : x) coordinate = std::nearbyint(coordinate / step_) * step_;
    if (!f_.first(x.data(), value_.data(), derivative_.data())) return false;
    auto proposed = propose_frame(derivative_, q_, n_);
    if (!proposed) return false;
    cells_.insert(x.data());
    frames_.push_back(std::move(proposed->frame));
    return true;
  }

  [[nodiscard]] double height(std::uint32_t label, const std::vector<double>& x) const {
    double squared = 0;
    for (std::size_t b = m; b < n_; ++b) squared += square_of(along(label, x.data(), b));
    return std::sqrt(squared);
  }
  static double square_of(double x) { return x * x; }
  [[nodiscard]] double along(std::uint32_t label, const double* x, std::size_t column) const {
    double result = 0;
    for (std::size_t axis = 0; axis < n_; ++axis)
      result += frames_[label][axis * n_ + column] * (x[axis] - cells_[label][axis]);
    return result;
  }
  /// In the tangent plane of this label; none if it must be on another sheet.
  [[nodiscard]] std::optional<Vector<double, m>> seen_from(std::uint32_t label, const double* x) const {
    Vector<double, m> place;
    double across = 0;
    double above = 0;
    for (std::size_t k = 0; k < n_; ++k) {
      const double coordinate = along(label, x, k);
      if (k < m) place[k] = coordinate;
      (k < m ? across : above) += square_of(coordinate);
    }
    if (above > square_of(most_slope) * across) return std::nullopt;
    return place;
  }

  /// No point is closer in its own chart.
  [[nodiscard]] bool is_free(const std::vector<double>& x) const {
    bool result = true;
    cells_.visit(x.data(), most_stretch * radius_, [&](std::uint32_t other, double squared) {
      const auto place = seen_from(other, x.data());
      result = squared > square_of(step_) && (!place || pairing(*place, *place) >= radius_ * radius_);
      return !result;
    });
    return result;
  }
  /// No point is closer in the chart of this label.
  [[nodiscard]] bool is_free_in_chart(std::uint32_t label, const std::vector<double>& x) const {
    const auto place = seen_from(label, x.data());
    if (!place || pairing(*place, *place) < radius_ * radius_) return false;
    bool result = true;
    cells_.visit(x.data(), most_stretch * radius_, [&](std::uint32_t other, double squared) {
      const auto there = seen_from(label, cells_[other]);
      if (there) {
        const auto offset = difference(*there, *place);
        result = pairing(offset, offset) >= radius_ * radius_;
      }
      if (squared <= square_of(step_)) result = false;
      return !result;
    });
    return result;
  }

  const ZeroSet& zero_set_;
  double radius_;
  std::size_t n_;
  std::size_t q_;
  FormulaEvaluation<double> f_;
  AmbientGrid cells_;
  std::vector<Dense<double>> frames_;
  std::vector<double> value_;
  Dense<double> derivative_;
  std::vector<std::array<double, 2>> box_;
  double step_;
};

[[noreturn]] void refuse_part(const ZeroSet& zero_set, const CoverReport& report) {
  const BoxPart& part = report.open.front();
  throw Undecided(zero_set.description().name + ": undecided at the part of the box from " + rough_text(part.lower) +
                  " to " + rough_text(part.upper) +
                  ": it may have zeros of the equations, and is in no patch; there may be a singular point, a "
                  "component of the manifold "
                  "that is too small for the sampling radius, or the manifold may go through the side of the box");
}

}  // namespace

template <int m>
SubmanifoldNet<m> submanifold_net(const ZeroSet& zero_set, const Rational& radius, std::uint64_t seed,
                                  const Progress& progress) {
  constexpr int most_rounds = 16;
  if (radius <= Rational(0)) throw InputError("the radius of a net is above 0");
  SubmanifoldPoints<m> points(zero_set, approximate_double(radius));
  DiskSampling<m, SubmanifoldPoints<m>> sampling(points, Curvature::zero, approximate_double(radius));
  sampling.throw_darts(seed, progress);
  for (int round = 0;; ++round) {
    sampling.fill_gaps(seed, progress);
    SubmanifoldNet<m> result;
    result.centres = points.ordered();
    if (points.size() > 0) result.charts = fit_charts(zero_set, result.centres, radius, progress);
    const CoverReport cover = check_cover(zero_set, result.charts.charts, progress);
    result.covering_radius = sampling.covering_radius();
    result.parts = cover.parts;
    if (cover.open.empty()) {
      if (points.size() == 0)
        throw Rejection(zero_set.description().name + ": no point of the box is a zero of the equations");
      return result;
    }
    bool is_longer = false;
    for (const BoxPart& part : cover.open) {
      std::vector<double> x;
      for (std::size_t axis = 0; axis < part.lower.size(); ++axis)
        x.push_back(part.lower[axis] / 2 + part.upper[axis] / 2);
      if (points.insert_from(std::move(x))) is_longer = true;
    }
    if (!is_longer || round == most_rounds) refuse_part(zero_set, cover);
  }
}
template SubmanifoldNet<2> submanifold_net<2>(const ZeroSet&, const Rational&, std::uint64_t, const Progress&);
template SubmanifoldNet<3> submanifold_net<3>(const ZeroSet&, const Rational&, std::uint64_t, const Progress&);

std::uint64_t require_cover(const ZeroSet& zero_set, const std::vector<TangentChart>& charts,
                            const Progress& progress) {
  const CoverReport report = check_cover(zero_set, charts, progress);
  if (!report.open.empty()) refuse_part(zero_set, report);
  return report.parts;
}

}  // namespace delcert
