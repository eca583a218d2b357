#pragma once

#include <string>
#include <vector>

#include "properties/attack/campaign_log.hpp"

namespace delcert {

/// All blocks of a campaign, each once, out of several logs.
struct MergedCampaign {
  CampaignPlan plan;  ///< of the whole: part 1/1
  std::map<Block, BlockRecord> finished;
};

/// Puts logs of parts together. Throws InputError for logs of different campaigns or of different numbers of samples,
/// Rejection for a block that two logs have, whatever they say of it, and Undecided for blocks that none has; each
/// names the logs or the blocks. Precondition: there is a log.
[[nodiscard]] MergedCampaign merged(const std::vector<CampaignRecord>& logs);

/// The log of the whole: where it comes from, then the blocks in order. It depends on what the logs say, not on their
/// order.
[[nodiscard]] std::string merged_text(const MergedCampaign& campaign, const std::vector<CampaignRecord>& logs);

/// The blocks of the log's part that it does not have, in order.
[[nodiscard]] std::vector<Block> missing_blocks(const CampaignRecord& log);

/// "block 17 (…) is missing, and 2 others: 25, 33". Precondition: there is one.
[[nodiscard]] std::string missing_text(const CampaignPlan& plan, const std::vector<Block>& missing);

}  // namespace delcert
