#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "kernel/perturb/delaunay_candidates.hpp"
#include "kernel/progress.hpp"

namespace delcert {

/// What a run of the algorithm did.
struct PerturbationStatistics {
  std::uint64_t placements = 0;  ///< points placed, those placed anew included
  std::uint64_t tries = 0;
  std::uint32_t most_tries = 0;
  std::uint64_t candidates = 0;
  std::uint64_t most_candidates = 0;
  std::uint64_t visited = 0;  ///< simplices looked at to find the candidates
};

/// The extended algorithm: points are perturbed one after the other, uniformly on a dyadic grid in B(p_i, ρ₀ε_i), until
/// the perturbation is good.
///
/// Invariant (docs/claims/pruned-candidates.md): at any time the placed points contain no forbidden configuration,
/// where the parameters are such that the paper's lemmas apply. Taking points away keeps it, placing a point against
/// all placed points keeps it; so any set of points may be placed anew, in any order.
///
/// The result depends on the atlas and the parameters only.
template <int m>
class Perturbation {
 public:
  /// The atlas must outlive it.
  Perturbation(const Atlas<m>& atlas, const PerturbationParameters& parameters);

  /// Places every label, in increasing order. Throws Rejection naming a label for which no good perturbation was found.
  void place_all(const Progress& progress);
  /// Takes these labels away and places them anew, in increasing order.
  void place_anew(std::vector<Label> labels, const Progress& progress);

  /// Placed points where they were placed, others where they were originally.
  [[nodiscard]] const PointSet<m>& points() const { return points_; }
  [[nodiscard]] const PerturbationStatistics& statistics() const { return statistics_; }
  /// The grid of the perturbed points has steps of 2^this in every frame coordinate.
  [[nodiscard]] long grid_exponent() const { return grid_exponent_; }

 private:
  void place(Label i);
  /// The first perturbation that is good; none in `most_tries`.
  [[nodiscard]] std::optional<Vector<Rational, m>> first_good(Label i, std::uint32_t& tries);
  /// By the second tolerance.
  [[nodiscard]] std::optional<Vector<Rational, m>> best_good(Label i, std::uint32_t& tries);
  [[nodiscard]] Vector<Rational, m> random_position(Label i, std::uint32_t attempt) const;

  const Atlas<m>& atlas_;
  PerturbationParameters parameters_;
  long grid_exponent_;
  PointSet<m> points_;
  std::vector<bool> placed_;
  std::vector<std::uint32_t> attempts_;
  CandidateTest<m> test_;
  DelaunayCandidates<m> delaunay_;
  PerturbationStatistics statistics_;
};

}  // namespace delcert
