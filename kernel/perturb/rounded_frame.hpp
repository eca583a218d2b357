#pragma once

#include <cmath>

#include "kernel/number/filter.hpp"
#include "kernel/number/rounding_bound.hpp"
#include "kernel/perturb/patch_view.hpp"
#include "kernel/simplex/cholesky.hpp"

namespace delcert {

/// Cartesian coordinates in doubles about some origin, in a unit of length in which all that matters is about 1.
template <int m>
class RoundedFrame {
 public:
  /// Precondition of this and of all that follows: a `FilterGuard` is alive.
  RoundedFrame(const MetricOn<Filter, m>& metric, const Matrix<Rational, m>& gram)
      : is_cartesian_(metric.is_cartesian()), factor_(upper_factor<Filter, m>(metric, gram)) {}

  /// The origin is in this enclosure of a point from now on, an end of it.
  void look_about(const Vector<Filter, m>& point) {
    for (std::size_t axis = 0; axis < m; ++axis) origin_[axis] = Filter::exactly(point[axis].lower());
  }
  /// The length given is between 1/2 and 1 from now on. Precondition: it is positive and finite.
  void measure_by(double length) {
    int exponent = 0;
    (void)std::frexp(length, &exponent);
    scale_ = std::ldexp(1.0, -exponent);
  }

  /// The unit of length is 1/scale(), a power of two.
  [[nodiscard]] double scale() const { return scale_; }

  /// Coordinates, none farther than `error` from those of any point in the enclosure.
  struct Place {
    Vector<double, m> at{};
    double error = 0;
  };
  [[nodiscard]] Place place(const Vector<Filter, m>& x) const { return vector(difference(x, origin_)); }
  /// The same coordinates without the error.
  [[nodiscard]] Vector<double, m> at(const Vector<Filter, m>& x) const {
    Vector<Filter, m> offset = difference(x, origin_);
    if (!is_cartesian_) offset = upper_applied(factor_, offset);
    Vector<double, m> result;
    for (std::size_t axis = 0; axis < m; ++axis) result[axis] = (Filter::exactly(scale_) * offset[axis]).lower();
    return result;
  }
  /// The same of a vector.
  [[nodiscard]] Place vector(Vector<Filter, m> offset) const {
    if (!is_cartesian_) offset = upper_applied(factor_, offset);
    Place result;
    for (std::size_t axis = 0; axis < m; ++axis) {
      const Filter scaled = Filter::exactly(scale_) * offset[axis];
      result.at[axis] = scaled.lower();
      const double width = (Filter::exactly(scaled.upper()) - Filter::exactly(scaled.lower())).upper();
      if (!(width <= result.error)) result.error = width;
    }
    return result;
  }

 private:
  bool is_cartesian_;
  Matrix<Filter, m> factor_;
  Vector<Filter, m> origin_{};
  double scale_ = 1;
};

/// Where a view has its points in a frame.
template <int m>
struct RoundedPlaces {
  /// Distances are compared in doubles, and bounds of errors are of use, up to this error.
  static constexpr double most_error = 0x1p-30;

  std::vector<Vector<double, m>> at;
  double size = 0;   ///< a bound of all coordinates, a multiple of 1/2
  double error = 0;  ///< of the error of all places, a power of two: so bounds that follow from both are few

  /// Precondition: a `FilterGuard` is alive.
  void fill(const RoundedFrame<m>& frame, const PatchView<m>& view) {
    at.clear();
    size = 0;
    error = 0;
    for (std::size_t position = 0; position < view.size(); ++position) {
      const auto place = frame.place(view.position(position));
      for (const double coordinate : place.at) {
        if (!(std::fabs(coordinate) <= size)) size = std::fabs(coordinate);
      }
      if (!(place.error <= error)) error = place.error;
      at.push_back(place.at);
    }
    size = std::ceil(2 * size) / 2;
    if (!(error <= most_error)) return;
    int exponent = -100;
    if (error > 0x1p-100) (void)std::frexp(error, &exponent);
    error = std::ldexp(1.0, exponent);
  }

  /// Whether points are certainly at a squared distance below this, or certainly not; for `PatchView::connect`.
  /// Precondition: the bound is at least 1/8, the error at most `most_error`, coordinates at most 2¹⁰.
  [[nodiscard]] auto is_below(const Filter& squared_bound) const {
    const double least = squared_bound.lower() * (1 - 0x1p-12);
    const double most = squared_bound.upper() * (1 + 0x1p-12);
    return [this, least, most](std::size_t a, std::size_t b) {
      const auto edge = difference(at[b], at[a]);
      const double squared = pairing(edge, edge);
      const bool is_less = squared < least;
      const bool is_more = squared > most;
      return is_less == is_more ? Verdict::undecided : verdict_of(is_less);
    };
  }
};

}  // namespace delcert
