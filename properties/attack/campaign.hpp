#pragma once

#include <filesystem>
#include <vector>

#include "properties/attack/tally.hpp"
#include "support/progress.hpp"

namespace delcert {

/// One claim in one shape, attacked with a number of samples.
struct Target {
  Claim claim;
  Shape shape;
  std::uint64_t samples = 0;
};

struct CampaignPlan {
  std::vector<Target> targets;
  std::uint64_t seed = 0;
  unsigned threads = 1;
  std::uint64_t block = 250;  ///< about how many samples of an instance of cost 1 lie between two entries of the log
  /// JSON lines, one for each finished block; what it has already is not done again. Nothing is kept if empty.
  std::filesystem::path log;
};

/// The samples of one target that are done in one go, by one thread: fewer where an instance is costly, more where the
/// log would have more than 20 000 entries for the target.
[[nodiscard]] std::uint64_t block_size(const CampaignPlan& plan, const Target& target);

/// The tallies of the targets, in their order. The same for any number of threads, and whether or not it was
/// interrupted and resumed. `progress` is called from the calling thread and may throw to end the campaign: blocks that
/// are finished stay in the log. Throws InputError for a log that belongs to another plan, and, naming claim and shape,
/// where a claim cannot be asked of its instances (vertex 7 of a triangle).
[[nodiscard]] std::vector<Tally> run_campaign(const CampaignPlan& plan, const Progress& progress);

}  // namespace delcert
