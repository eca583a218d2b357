#pragma once

#include <string>
#include <vector>

#include "properties/attack/campaign_log.hpp"
#include "support/progress.hpp"

namespace delcert {

/// So many of the blocks that the log has, drawn without replacement, in order. The same for the same seed.
/// Precondition: count ≤ log.finished.size().
[[nodiscard]] std::vector<Block> drawn_blocks(const CampaignRecord& log, std::uint64_t count, std::uint64_t seed);

/// Does these blocks anew, on so many threads, and says where the log differs: "FILE:LINE: block 17 (…): …", one text
/// for each block that does. Precondition: the log has them.
[[nodiscard]] std::vector<std::string> recheck(const CampaignRecord& log, const std::vector<Block>& blocks,
                                               unsigned threads, const Progress& progress);

/// The least number k such that, if k of so many blocks were false, one of them would be among those drawn with a
/// probability of at least 95 %; approximate_ as it is worked out in doubles. Precondition: 0 < drawn ≤ blocks.
[[nodiscard]] std::uint64_t approximate_noticeable_blocks(std::uint64_t blocks, std::uint64_t drawn);

/// Decides anew what the tallies of all blocks rest on: for each conclusion that is violated, that the instance of its
/// first violation is that of its sample and violates it; and the worst ratio of each conclusion, from its sample.
/// Throws Rejection, naming the block, where the log says otherwise. Precondition: all blocks are there.
void require_evidence(const CampaignPlan& plan, const std::map<Block, BlockRecord>& finished, unsigned threads,
                      const Progress& progress);

}  // namespace delcert
