#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "kernel/perturb/delaunay_candidates.hpp"
#include "kernel/perturb/grid_ball.hpp"
#include "support/progress.hpp"

namespace delcert {

/// What a run of the algorithm did.
struct PerturbationStatistics {
  std::uint64_t placements = 0;  ///< points placed, those placed anew included
  std::uint64_t tries = 0;
  std::uint32_t most_tries = 0;
  std::uint64_t candidates = 0;
  std::uint64_t most_candidates = 0;
  std::uint64_t visited = 0;  ///< simplices looked at to find the candidates

  PerturbationStatistics& operator+=(const PerturbationStatistics& other);
};

/// The points of a perturbation on the way.
template <int m>
struct PlacedPoints {
  /// Nothing is placed.
  PlacedPoints(const Atlas<m>& atlas, const PerturbationParameters& parameters);

  PointSet<m> points;  ///< placed ones where they were placed, others where they were originally
  PlacedLabels placed;
  std::vector<std::uint32_t> attempts;  ///< positions drawn for each label so far
  long grid_exponent;                   ///< perturbed points have coordinates that are multiples of 2^this
  /// Where the atlas is a part of a whole: a label that is placed is the label of the whole that is greater by this. It
  /// counts random numbers, and messages name it.
  std::uint32_t names_begin = 0;
};

/// Places one label after another.
///
/// To place i is to read what `PlacedPoints` has of i and of the labels that i sights within `reach` sampling radii,
/// and to write what it has of i, nothing else. So several threads may place different labels in the same points, each
/// by a placement of its own, if none of these labels sights another within that reach; then it does not matter which
/// of them comes first (docs/decisions/placing-by-colours.md).
template <int m>
class Placement {
 public:
  /// References are kept.
  Placement(const Atlas<m>& atlas, const PerturbationParameters& parameters, PlacedPoints<m>& state);

  [[nodiscard]] static Rational reach(const PerturbationParameters& parameters);

  /// Draws positions uniformly on the grid in B(p_i, ρ₀ε_i) until one is good, and of these possibly chooses one.
  /// Throws Rejection naming the label if there is none in `most_tries`. Precondition: i is not placed.
  void place(Label i);

  /// Of what this placement did.
  [[nodiscard]] const PerturbationStatistics& statistics() const { return statistics_; }
  /// The same, which begin anew.
  [[nodiscard]] PerturbationStatistics take_statistics() { return std::exchange(statistics_, {}); }

 private:
  /// The first perturbation that is good.
  [[nodiscard]] std::optional<Vector<Rational, m>> first_good(Label i, GridBall<m>& ball, std::uint32_t& tries);
  /// By the second tolerance.
  [[nodiscard]] std::optional<Vector<Rational, m>> best_good(Label i, GridBall<m>& ball, std::uint32_t& tries);
  /// The position of an attempt: the same whenever it is asked for.
  void draw(Label i, std::uint32_t attempt, GridBall<m>& ball) const;

  const Atlas<m>& atlas_;
  const PerturbationParameters& parameters_;
  PlacedPoints<m>& state_;
  MetricOn<Filter, m> metric_;
  CandidateTest<m> test_;
  DelaunayCandidates<m> delaunay_;
  Rational unit_{0};  // the sampling radius of the last label
  Rational radius_;   // in which perturbations of it were
  std::optional<GridBall<m>> ball_;
  PerturbationStatistics statistics_;
};

/// Places these labels, none of which sights another one within `Placement::reach`, in parallel, as if one after the
/// other. Throws as `Placement::place`, of the first label. Precondition: rounding to nearest.
template <int m>
[[nodiscard]] PerturbationStatistics place_in_parallel(const Atlas<m>& atlas, const PerturbationParameters& parameters,
                                                       PlacedPoints<m>& state, const std::vector<Label>& labels,
                                                       std::string_view stage, const Progress& progress);

}  // namespace delcert
