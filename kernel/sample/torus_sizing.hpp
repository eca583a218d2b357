#pragma once

#include "kernel/manifold/flat_atlas.hpp"
#include "kernel/sample/sizing.hpp"

namespace delcert {

/// How densely a flat torus is to be sampled, place by place: e(x) = min{e_max, min over cones of a + ν·d(x, s)}, d the
/// distance on the torus. In doubles: no claim rests on it.
template <int m>
class TorusSizing {
 public:
  /// e_max everywhere. Precondition: the space is a torus.
  TorusSizing(const FlatSpace<m>& space, double greatest);

  /// The apex is in frame coordinates. Throws InputError for a basis so skewed that the lifts of a cone that matter are
  /// more than a million. Preconditions: a radius above 0, a slope of at least 0.
  void add(const Sizing::Cone& cone);
  /// x is in frame coordinates.
  [[nodiscard]] double at(const Vector<double, m>& x) const;
  [[nodiscard]] double greatest() const { return cones_.greatest(); }
  /// Of e, a lower bound.
  [[nodiscard]] double least() const { return cones_.least(); }

 private:
  FrameMetric<m> metric_;
  Vector<double, m> stretch_{};  // √(G⁻¹)_aa
  double farthest_ = 0;          // no point of the torus is farther from another
  Sizing cones_;                 // in Cartesian coordinates: all lifts that matter in the unit cell
};

/// From a file of cones in frame coordinates. Throws InputError: with the line, for the curvature, which is 0, and for
/// a ball.
template <int m>
[[nodiscard]] TorusSizing<m> torus_sizing(const SizingRequest& request, const FlatSpace<m>& space, double greatest);

}  // namespace delcert
