#pragma once

#include <optional>
#include <vector>

#include "kernel/perturb/perturbation.hpp"
#include "kernel/stars/protection.hpp"
#include "kernel/stars/star_complex.hpp"

namespace delcert {

/// What is asked of a run beyond the parameters of the perturbation.
struct RunRequest {
  bool perturb = true;
  /// Simplices must be more protected than this length; simplices that are not are repaired.
  std::optional<Rational> required_protection;
  int most_repair_rounds = 20;
  /// On space forms: certify geodesic circumballs as well.
  bool certify_model = true;
  /// In charts: place points anew, too, where only a point in the ball of a star keeps the stars from being the same in
  /// all charts that show them (level 2s).
  bool repair_stability = false;
};

/// The outcome of the extended algorithm with its final step, the computation of all stars.
template <int m>
struct RunResult {
  PointSet<m> points;
  StarComplex<m> complex;
  ProtectionReport protection;
  std::vector<StarFailure> combinatorial_failures;
  PerturbationStatistics statistics;
  int repair_rounds = 0;
  std::size_t repaired_points = 0;

  /// Whether every star is certified.
  [[nodiscard]] bool is_certified() const { return protection.margins.has_value() && combinatorial_failures.empty(); }
};

/// Perturbs, computes the stars and certifies them; places the points of what fails anew, round by round, until
/// nothing fails or the rounds are used up. Without perturbation nothing is repaired.
template <int m>
[[nodiscard]] RunResult<m> run_algorithm(const FlatAtlas<m>& atlas, const PerturbationParameters& parameters,
                                         const RunRequest& request, const Progress& progress);

}  // namespace delcert
