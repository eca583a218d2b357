#pragma once

#include <string_view>
#include <utility>
#include <vector>

#include "kernel/perturb/placement.hpp"
#include "support/progress.hpp"

namespace delcert {

/// The extended algorithm: points are perturbed one after the other, uniformly on a dyadic grid in B(p_i, ρ₀ε_i), until
/// the perturbation is good.
///
/// Invariant (docs/claims/pruned-candidates.md): at any time the placed points contain no forbidden configuration,
/// where the parameters are such that the paper's lemmas apply. Taking points away keeps it, placing a point against
/// all placed points keeps it; so any set of points may be placed anew, in any order.
///
/// Labels are placed by the colours of `colours_of`, one colour after the other; labels of one colour in parallel, and
/// as if in increasing order (docs/decisions/placing-by-colours.md). The result depends on the atlas and the parameters
/// only.
template <int m>
class Perturbation {
 public:
  /// The atlas must outlive it. Precondition: rounding to nearest.
  Perturbation(const Atlas<m>& atlas, const PerturbationParameters& parameters);

  /// Places every label. Throws Rejection naming the first label for which no good perturbation was found.
  void place_all(const Progress& progress);
  /// Takes these labels away and places them anew.
  void place_anew(std::vector<Label> labels, const Progress& progress);

  /// Placed points where they were placed, others where they were originally.
  [[nodiscard]] const PointSet<m>& points() const { return state_.points; }
  /// The same, for good: nothing is placed anew afterwards.
  [[nodiscard]] PointSet<m> take_points() { return std::move(state_.points); }
  [[nodiscard]] const PerturbationStatistics& statistics() const { return statistics_; }
  /// The grid of the perturbed points has steps of 2^this in every frame coordinate.
  [[nodiscard]] long grid_exponent() const { return state_.grid_exponent; }

 private:
  /// Places these labels, sorted and none of them placed, colour by colour.
  void place(const std::vector<Label>& labels, std::string_view stage, const Progress& progress);

  const Atlas<m>& atlas_;
  PerturbationParameters parameters_;
  PlacedPoints<m> state_;
  std::vector<std::uint32_t> colours_;  // of the labels; empty until asked for
  PerturbationStatistics statistics_;
};

}  // namespace delcert
