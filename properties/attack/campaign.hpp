#pragma once

#include <chrono>
#include <map>
#include <optional>
#include <vector>

#include "properties/attack/campaign_log.hpp"
#include "properties/attack/campaign_plan.hpp"
#include "support/progress.hpp"

namespace delcert {

/// What came of a campaign, or of its part.
struct CampaignOutcome {
  std::vector<Tally> tallies;            ///< of the targets, in their order
  std::map<Block, BlockRecord> records;  ///< of the blocks that are finished
  CampaignPlan plan;                     ///< with the sizes of blocks of its log
  std::uint64_t finished = 0;            ///< blocks of the part
  std::uint64_t blocks = 0;              ///< as many as it has
  [[nodiscard]] bool is_finished() const { return finished == blocks; }
};

/// Attacks what the plan's part has and its log does not. The tallies are the same for any number of threads, and
/// whether or not it was interrupted and resumed, or extended. No block is begun after `limit`. `progress` is called
/// from the calling thread and may throw to end the campaign: blocks that are finished stay in the log. Throws
/// InputError for a log that cannot go on so (see CampaignLog), and, naming claim and shape, where a claim cannot be
/// asked of its instances (vertex 7 of a triangle).
[[nodiscard]] CampaignOutcome run_campaign(const CampaignPlan& plan, const Progress& progress,
                                           std::optional<std::chrono::seconds> limit = std::nullopt);

/// Does one block anew: its tally, its violations, and how long that took. Throws InputError as run_campaign does.
[[nodiscard]] BlockRecord attacked_block(const CampaignPlan& plan, const Block& block);

/// The tallies of the targets from those of blocks.
[[nodiscard]] std::vector<Tally> tallies_of(const CampaignPlan& plan, const std::map<Block, BlockRecord>& finished);

}  // namespace delcert
