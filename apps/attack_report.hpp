#pragma once

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

/// The table claim × shape of a campaign, in Markdown; if `is_short`, with one row for all shapes of the same k.
[[nodiscard]] std::string attack_table(const std::vector<Target>& targets, const std::vector<Tally>& tallies,
                                       bool is_short = false);

/// The same as JSON, one object for each target.
[[nodiscard]] nlohmann::ordered_json attack_json(const std::vector<Target>& targets, const std::vector<Tally>& tallies);

/// "0.99731" or "[0.97, 1.02]": as many digits as both bounds share.
[[nodiscard]] std::string ratio_text(const std::optional<DoubleBounds>& ratio);

}  // namespace delcert
