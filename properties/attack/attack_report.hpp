#pragma once

#include <array>
#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "properties/attack/campaign.hpp"

namespace delcert {

/// One conclusion of one claim over all its shapes that was refuted, with the witness.
struct Refutation {
  std::string claim;
  std::string conclusion;
  Shape shape;
  std::uint64_t sample = 0;
  std::string witness;  ///< text of the witness file
  std::string file;     ///< where it was written
};

/// What fewer instances have not refuted counts as hardly attacked, unless the user says otherwise.
inline constexpr std::uint64_t usual_least_instances = 100;

/// The table claim × shape of a campaign, in Markdown; if `is_short`, with one row for all shapes of the same k.
[[nodiscard]] std::string attack_table(const std::vector<Target>& targets, const std::vector<Tally>& tallies,
                                       std::uint64_t least_instances, bool is_short = false);

/// The main columns of it as a longtable of LaTeX, at most 345 pt wide.
[[nodiscard]] std::string attack_latex(const std::vector<Target>& targets, const std::vector<Tally>& tallies,
                                       std::uint64_t least_instances, bool is_short = false);

/// The same as JSON, one object for each target.
[[nodiscard]] nlohmann::ordered_json attack_json(const std::vector<Target>& targets, const std::vector<Tally>& tallies,
                                                 std::uint64_t least_instances);

/// What an attack on one conclusion amounts to, over all shapes.
struct AttackTotal {
  std::string claim;
  std::string conclusion;
  std::size_t shapes = 0;  ///< in which there was an instance that meets the hypotheses
  ConclusionTally tally;
  std::array<std::uint64_t, 3> traits{};  ///< by `Trait`, of the instances that meet the hypotheses
};

/// In the order of the claims and of their conclusions.
[[nodiscard]] std::vector<AttackTotal> attack_totals(const std::vector<Target>& targets,
                                                     const std::vector<Tally>& tallies);

/// A line for each conclusion that nothing refuted: how many instances there were, of which kinds, and what they would
/// have found.
[[nodiscard]] std::string totals_text(const std::vector<AttackTotal>& totals, std::uint64_t least_instances);
[[nodiscard]] nlohmann::ordered_json totals_json(const std::vector<AttackTotal>& totals, std::uint64_t least_instances);

/// The greatest n such that, if at least one of n instances (drawn as these are) violated the conclusion on the
/// average, so many instances would have shown it with a probability of 95 %; 0 for fewer than 5 instances.
[[nodiscard]] std::uint64_t noticeable_share(std::uint64_t instances);

/// "0.99731" or "[0.97, 1.02]": as many digits as both bounds share.
[[nodiscard]] std::string ratio_text(const std::optional<DoubleBounds>& ratio);

}  // namespace delcert
