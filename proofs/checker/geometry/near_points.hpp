#pragma once

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "proofs/checker/arithmetic/matrix.hpp"

namespace delcert::checker {

/// Finds points of R^N, known by enclosures, near a place: a tree that halves them along its axes in turn.
class NearPoints {
 public:
  NearPoints() = default;
  explicit NearPoints(const std::vector<Matrix<Interval>>& points)
      : axes_(points.empty() ? 1 : points[0].size()), order_(points.size()) {
    for (const Matrix<Interval>& point : points) {
      for (std::size_t k = 0; k < axes_; ++k) {
        places_.push_back(middle(point[k]));
        if (!(std::fabs(point[k].lower()) < 0x1p500 && std::fabs(point[k].upper()) < 0x1p500))
          throw Undecided("a point is not known, or too far away");
        slack_ = std::max({slack_, point[k].upper() - places_.back(), places_.back() - point[k].lower(),
                           0x1p-40 * std::fabs(places_.back())});
      }
    }
    std::iota(order_.begin(), order_.end(), 0U);
    if (!order_.empty()) halve(0, order_.size(), 0);
  }

  /// About the middle; 0 if there is none.
  static double middle(const Interval& x) {
    const double result = x.lower() + (x.upper() - x.lower()) / 2;
    return std::isfinite(result) ? result : 0;
  }

  /// Calls f(index) for all points at distance <= radius of a point of the box, and for some others.
  template <class F>
  void visit(const Matrix<Interval>& box, double radius, const F& f) const {
    search(box, radius * (1 + 0x1p-40) + 4 * slack_, 0, order_.size(), 0, f);
  }

 private:
  static constexpr std::size_t few = 8;

  double place(std::uint32_t point, std::size_t axis) const { return places_[point * axes_ + axis]; }
  /// Points before the one in the middle are not above it along the axis, those after it not below.
  void halve(std::size_t begin, std::size_t end, std::size_t axis) {
    if (end - begin <= few) return;
    const std::size_t half = begin + (end - begin) / 2;
    const auto at = [this](std::size_t k) { return order_.begin() + static_cast<std::ptrdiff_t>(k); };
    std::nth_element(at(begin), at(half), at(end),
                     [&](std::uint32_t a, std::uint32_t b) { return place(a, axis) < place(b, axis); });
    halve(begin, half, (axis + 1) % axes_);
    halve(half + 1, end, (axis + 1) % axes_);
  }
  template <class F>
  void search(const Matrix<Interval>& box, double radius, std::size_t begin, std::size_t end, std::size_t axis,
              const F& f) const {
    const bool is_leaf = end - begin <= few;
    const std::size_t half = begin + (end - begin) / 2;
    Budget::spend(1 + (is_leaf ? end - begin : 0));
    for (std::size_t k = is_leaf ? begin : half; k < (is_leaf ? end : half + 1); ++k) {
      Interval squared(0);
      for (std::size_t a = 0; a < axes_; ++a) {
        const double x = place(order_[k], a);
        squared = squared + square(Interval::between(x, x) - box[a]);
      }
      if (squared.lower() <= radius * radius) f(order_[k]);
    }
    if (is_leaf) return;
    const double split = place(order_[half], axis);
    if (!(box[axis].lower() - radius > split)) search(box, radius, begin, half, (axis + 1) % axes_, f);
    if (!(box[axis].upper() + radius < split)) search(box, radius, half + 1, end, (axis + 1) % axes_, f);
  }

  std::size_t axes_ = 1;
  std::vector<std::uint32_t> order_;
  std::vector<double> places_;
  double slack_ = 0;  // above what the places are away from the points, along an axis
};

}  // namespace delcert::checker
