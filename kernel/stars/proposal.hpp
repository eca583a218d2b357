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

/// Simplices in canonical form, of several lists, in increasing order. `points`: how many there are. In parallel.
template <int m>
[[nodiscard]] std::vector<LiftedSimplex<m>> in_order(const std::vector<std::vector<LiftedSimplex<m>>>& lists,
                                                     std::size_t points);

/// The Delaunay simplices of the lifts of these points (approximate frame coordinates), each once mod the lattice, in
/// increasing order. A proposal: nothing is certified. On a torus copies of the points around boxes of the unit cell
/// stand in for the lifts; their number grows, from what the usual circumradius (> 0) asks for, until they hold every
/// proposed circumball. In parallel, with the same result for any number of threads.
/// Throws Rejection when the points are too few for that, or span no m-simplex, InputError for coordinates of 2³⁰ or
/// more, and for a lattice basis so skewed that copies do not reach; the message has a reduced one.
/// Precondition: rounding to nearest; not within parallel work.
template <int m>
[[nodiscard]] std::vector<LiftedSimplex<m>> propose_delaunay(const FlatSpace<m>& space,
                                                             const std::vector<Vector<double, m>>& points,
                                                             double usual_circumradius);

/// The same for points that become more, so that not all of the work is done anew.
template <int m>
class GrowingProposal {
 public:
  /// A reference is kept.
  GrowingProposal(const FlatSpace<m>& space, double usual_circumradius);
  ~GrowingProposal();
  GrowingProposal(const GrowingProposal&) = delete;
  GrowingProposal& operator=(const GrowingProposal&) = delete;

  /// What `propose_delaunay` returns and throws. Precondition: the points begin with those of the last call.
  [[nodiscard]] std::vector<LiftedSimplex<m>> simplices(const std::vector<Vector<double, m>>& points);

 private:
  /// A box of the unit cell and the lifts in it and around it, triangulated; of a ball all points.
  struct Box;
  struct Found {
    std::vector<LiftedSimplex<m>> simplices;
    double largest = 0;  ///< of their circumradii
    double volume = 0;   ///< of all together, times m!, in unit cells
  };
  /// Into boxes for so many points.
  void divide(std::size_t points);
  /// From now on boxes have the lifts of all of these in the box widened by `margin`, a length that does not become
  /// less; of a ball just the points.
  void add_copies(const std::vector<Vector<double, m>>& points, double margin);
  void add_copies(const std::vector<Vector<double, m>>& points, double margin, Box& box) const;
  /// The simplices with their circumcentre in a box.
  [[nodiscard]] Found found(const std::vector<Vector<double, m>>& points) const;
  [[nodiscard]] Found found_in(const std::vector<Vector<double, m>>& points, const Box& box) const;

  const FlatSpace<m>& space_;
  double usual_circumradius_;
  std::size_t known_ = 0;  // of how many points there are copies
  double margin_ = 0;
  Shift<m> division_;  // how many boxes there are along each axis
  std::vector<std::unique_ptr<Box>> boxes_;
};

}  // namespace delcert
