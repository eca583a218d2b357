#pragma once

#include <map>
#include <string>

#include "properties/attack/campaign_log.hpp"
#include "support/progress.hpp"

namespace delcert {

/// What draws and decides here, for logs of campaigns: version and commit.
[[nodiscard]] std::string software_name();

/// So many threads as were asked for; as many as there are processors for 0.
[[nodiscard]] unsigned threads_or_all(unsigned threads);

/// `require_evidence` of what a log says, whose name its message has. Nothing for an empty name: what was done just now
/// need not be done again.
void decide_anew(const std::string& log, const CampaignPlan& plan, const std::map<Block, BlockRecord>& finished,
                 unsigned threads, const Progress& progress);

}  // namespace delcert
