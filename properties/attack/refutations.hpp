#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "properties/attack/campaign.hpp"
#include "properties/attack/witness.hpp"
#include "support/progress.hpp"

namespace delcert {

/// One conclusion of one claim that was refuted, with the simplest witness that was found from the first violation.
struct FoundRefutation {
  std::size_t target = 0;      ///< the first one, in the order of the plan, where there is a violation
  std::size_t conclusion = 0;  ///< of its claim
  std::uint64_t sample = 0;    ///< the first that violates it
  Witness witness;
};

/// One for each conclusion of each claim that a campaign with this seed refuted. `progress` is called for each instance
/// that is tried in making one simpler.
[[nodiscard]] std::vector<FoundRefutation> refutations_in(const std::vector<Target>& targets,
                                                          const std::vector<Tally>& tallies, std::uint64_t seed,
                                                          const Progress& progress);

}  // namespace delcert
