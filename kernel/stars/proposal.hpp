#pragma once

#include <vector>

#include "kernel/manifold/flat_atlas.hpp"
#include "kernel/stars/approximate_delaunay.hpp"

namespace delcert {

/// An m-simplex of lifted points, up to translation: vertices in increasing order, the first with shift 0.
template <int m>
using LiftedSimplex = std::array<Lift<m>, static_cast<std::size_t>(m) + 1>;

/// The same simplex in its canonical form.
template <int m>
[[nodiscard]] LiftedSimplex<m> canonical(LiftedSimplex<m> simplex);

/// Puts simplices in canonical form in increasing order.
template <int m>
void sort_canonical(std::vector<LiftedSimplex<m>>& simplices);

/// The Delaunay simplices of the lifts of these points (approximate frame coordinates), each once mod the lattice, in
/// increasing order. A proposal: nothing is certified. On a torus copies of the points around the unit cell stand in
/// for the lifts; their number grows, from what the usual circumradius (> 0) asks for, until every proposed circumball
/// is well inside.
/// Throws Rejection when the points are too few for that, or span no m-simplex, InputError for coordinates of 2³⁰ or
/// more, and for a lattice basis so skewed that copies do not reach; the message has a reduced one.
template <int m>
[[nodiscard]] std::vector<LiftedSimplex<m>> propose_delaunay(const FlatSpace<m>& space,
                                                             const std::vector<Vector<double, m>>& points,
                                                             double usual_circumradius);

/// The same for points that become more, so that not all of the work is done anew.
template <int m>
class GrowingProposal {
 public:
  /// A reference is kept.
  GrowingProposal(const FlatSpace<m>& space, double usual_circumradius)
      : space_(space), usual_circumradius_(usual_circumradius) {}

  /// What `propose_delaunay` returns and throws. Precondition: the points begin with those of the last call.
  [[nodiscard]] std::vector<LiftedSimplex<m>> simplices(const std::vector<Vector<double, m>>& points);

 private:
  /// From now on there are the lifts of all of these in the unit cell widened by `margin`, a length that does not
  /// become less; of a ball just the points.
  void add_copies(const std::vector<Vector<double, m>>& points, double margin);
  /// The simplices with a vertex in the unit cell, and the largest of their circumradii.
  [[nodiscard]] std::pair<std::vector<LiftedSimplex<m>>, double> simplices_at_unit_cell() const;

  const FlatSpace<m>& space_;
  double usual_circumradius_;
  std::size_t known_ = 0;  // of how many points there are copies
  double margin_ = 0;
  std::vector<Lift<m>> lifts_;
  std::vector<Vector<double, m>> frame_;
  std::vector<unsigned char> is_in_unit_cell_;  // 1 also for all points of a ball
  GrowingDelaunay<m> triangulation_;
};

}  // namespace delcert
