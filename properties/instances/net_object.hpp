#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "kernel/simplex/vector.hpp"
#include "proofs/formula/vocabulary.hpp"
#include "support/error.hpp"

namespace delcert {

namespace types {
inline const Type net{"net", false};
}  // namespace types

/// Bounds of a covering radius, certified: lower ≤ the least r such that closed balls of radius r about the points of a
/// net cover the closed ball < upper.
struct CoveringBounds {
  Rational lower;
  Rational upper;
};

/// A finite set of points of ℝ² or ℝ³, its first point the one whose star is looked at (p_i of the paper), the sampling
/// radius ε that goes with it, and the radius of the closed ball about the origin for which it is meant to be ε-dense.
class NetObject : public Object {
 public:
  using Points = std::vector<std::vector<Rational>>;

  /// Throws InputError unless all points have two or all three coordinates and they are different, there are at least
  /// m + 2 of them, the sampling radius is above 0 and that of the ball not negative. The covering radius of the ball
  /// is bounded at once; with radius 0 it is not. Precondition: rounding to nearest, unless that radius is 0.
  NetObject(Points points, Rational sampling_radius, Rational ball_radius);

  [[nodiscard]] const Points& points() const { return points_; }
  [[nodiscard]] std::size_t size() const { return points_.size(); }
  [[nodiscard]] int dimension() const { return static_cast<int>(points_.front().size()); }
  [[nodiscard]] const Rational& sampling_radius() const { return sampling_radius_; }
  [[nodiscard]] const Rational& ball_radius() const { return ball_radius_; }
  /// None if the radius is 0, or the net has no certificate that it covers the ball at all.
  [[nodiscard]] const std::optional<CoveringBounds>& covering() const { return covering_; }

  /// The points as vectors. Precondition: m is the dimension.
  template <int m>
  [[nodiscard]] std::vector<Vector<Rational, m>> vectors() const {
    std::vector<Vector<Rational, m>> result(points_.size());
    for (std::size_t at = 0; at < points_.size(); ++at) {
      for (std::size_t axis = 0; axis < m; ++axis) result[at][axis] = points_[at][axis];
    }
    return result;
  }

  [[nodiscard]] nlohmann::ordered_json json() const override;
  [[nodiscard]] static ObjectPointer read(const nlohmann::ordered_json& json);

 private:
  Points points_;
  Rational sampling_radius_;
  Rational ball_radius_;
  std::optional<CoveringBounds> covering_;
};

/// Points as coordinate lists.
template <std::size_t m>
[[nodiscard]] NetObject::Points coordinate_lists(const std::vector<std::array<Rational, m>>& points) {
  NetObject::Points result;
  for (const auto& point : points) result.emplace_back(point.begin(), point.end());
  return result;
}

/// Calls `action.template operator()<m>()` for the dimension of a net, 2 or 3; throws InputError for another.
template <class Action>
decltype(auto) with_net_dimension(int dimension, const Action& action) {
  if (dimension == 2) return action.template operator()<2>();
  if (dimension == 3) return action.template operator()<3>();
  throw InputError("nets are for dimensions 2 and 3");
}

}  // namespace delcert
