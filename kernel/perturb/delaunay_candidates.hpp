#pragma once

#include <limits>
#include <vector>

#include "kernel/perturb/candidates.hpp"

namespace delcert {

/// How many sampling radii away original points may have a say in the choice of these candidates.
[[nodiscard]] inline Rational reach_of_delaunay_candidates(const PerturbationParameters& parameters) {
  return Rational(2) * parameters.circumradius_bound + Rational(2) * parameters.perturbation;
}

/// The spheres that decide about the protection of the outcome: of the m-simplices among the candidates of a label
/// whose ball, made smaller by the clearance, holds no placed point, and made smaller by how far points move too, no
/// original point that is not placed yet. Only such simplices can become Delaunay. A heuristic in doubles to choose by:
/// nothing rests on it, but it is the same everywhere.
template <int m>
class DelaunayCandidates {
 public:
  explicit DelaunayCandidates(const PerturbationParameters& parameters) : parameters_(parameters) {}

  /// Chooses among the candidates of a test that has been prepared for a label with this sampling radius, having been
  /// told to look around as far as `reach_of_delaunay_candidates`; it is kept. Precondition: a `FilterGuard` is alive.
  // Not inlined, here and below: see `CandidateTest::prepare`.
  [[gnu::noinline]] void prepare(const Rational& sampling_radius, const CandidateTest<m>& test);

  /// The least distance of x, in the chart of the label, from these spheres; infinite if there are none. x is in this
  /// enclosure. Precondition: a `FilterGuard` is alive.
  [[nodiscard]] [[gnu::noinline]] double clearance(const Vector<Filter, m>& x) const;

  [[nodiscard]] std::size_t size() const { return spheres_.size(); }

 private:
  // In the coordinates of `CandidateTest::frame`.
  struct Sphere {
    Vector<double, m> centre;
    double radius;
  };
  PerturbationParameters parameters_;
  const RoundedFrame<m>* frame_ = nullptr;
  std::vector<PointAround<m>> others_;
  std::vector<Sphere> spheres_;
};

}  // namespace delcert
