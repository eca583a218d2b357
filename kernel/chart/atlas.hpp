#pragma once

#include <optional>
#include <vector>

#include "kernel/chart/point_grid.hpp"
#include "kernel/chart/point_set.hpp"
#include "kernel/number/big_interval.hpp"
#include "kernel/number/filter.hpp"

namespace delcert {

/// A label as it is seen in a chart: the point of the label, carried there by one transition function. On a torus that
/// is named by the lattice vector, the `shift`; on another quotient by the group's `element`.
template <int m>
using Sighting = Lift<m>;

template <int m>
[[nodiscard]] Label label_of(const Sighting<m>& sighting) {
  return Label(sighting.index);
}

/// A manifold as the algorithm sees it (sec:input of the paper): labels, neighbour sets, sampling radii, transition
/// functions. Points live in the home patch of their label; elsewhere they are carried by a transition.
template <int m>
class Atlas {
 public:
  virtual ~Atlas() = default;

  /// The number of labels.
  [[nodiscard]] virtual std::size_t size() const = 0;
  /// The inner product of every local Euclidean metric d_i, in frame coordinates.
  [[nodiscard]] virtual const FrameMetric<m>& metric() const = 0;
  /// ε_i.
  [[nodiscard]] virtual const Rational& sampling_radius(Label i) const = 0;
  /// Whether B(p_i, 8ε_i) lies in the region that the net covers: only then is star(i) claimed.
  [[nodiscard]] virtual bool is_interior(Label i) const = 0;
  /// The original points p_i, each in its home patch: the centre of its chart.
  [[nodiscard]] virtual const PointSet<m>& net() const = 0;

  /// N_i with the transitions, i among them: the labels whose original point lies in the patch U_i, and possibly a
  /// few that are farther by a relative 2⁻²⁹.
  [[nodiscard]] virtual std::vector<Sighting<m>> neighbours(Label i) const = 0;
  /// Replaces `out` by those sightings whose original point is within `distance` of p_i, sorted (a superset, as
  /// above). Precondition: distance is at most the radius of the patch.
  virtual void sightings(Label i, double distance, std::vector<Sighting<m>>& out) const = 0;

  /// φ_ij for the sighted label j (the paper's index order: from U_j to U_i): home coordinates of its patch to
  /// coordinates of the chart i that sees it. Enclosures on the first two rungs (the filter needs a `FilterGuard`). On
  /// the last exact, or none if the family has no exact transitions.
  [[nodiscard]] virtual Vector<Filter, m> carry(Label i, const Sighting<m>& seen,
                                                const Vector<Filter, m>& home) const = 0;
  [[nodiscard]] virtual Vector<BigInterval, m> carry(Label i, const Sighting<m>& seen,
                                                     const Vector<BigInterval, m>& home) const = 0;
  [[nodiscard]] virtual std::optional<Vector<Rational, m>> carry(Label i, const Sighting<m>& seen,
                                                                 const Vector<Rational, m>& home) const = 0;
  [[nodiscard]] virtual bool has_exact_transitions() const = 0;
};

}  // namespace delcert
