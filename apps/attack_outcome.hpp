#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "apps/exit_status.hpp"
#include "properties/attack/campaign_plan.hpp"
#include "properties/attack/tally.hpp"
#include "support/progress.hpp"

namespace delcert {

/// How what came of a campaign is printed, and what of it is kept.
struct OutcomeOptions {
  std::uint64_t seed = 0;
  std::uint64_t least = 0;  ///< what fewer instances have not refuted counts as hardly attacked
  std::string witnesses;    ///< folder for witnesses of what is refuted; empty: none
  bool is_short = false;
  bool json = false;
  bool latex = false;
};

/// Prints what came of a campaign on standard output, and makes the witnesses of what is refuted simpler; the status
/// says whether something is refuted, undecided or hardly attacked. It depends on its arguments only, so that a
/// campaign that was cut into parts prints what a single run does.
[[nodiscard]] ExitStatus report_outcome(const std::vector<Target>& targets, const std::vector<Tally>& tallies,
                                        const OutcomeOptions& options, const Progress& progress);

/// Writes a file of the folder, which is made where it is not there; its path. Throws InputError where it cannot be.
std::string write_witness(const std::string& folder, const std::string& name, const std::string& text);

}  // namespace delcert
