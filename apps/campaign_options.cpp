#include "apps/campaign_options.hpp"

#include <algorithm>
#include <delcert_version.hpp>
#include <thread>

#include "properties/attack/campaign_recheck.hpp"
#include "support/build_commit.hpp"
#include "support/error.hpp"

namespace delcert {

std::string software_name() {
  const std::string commit = build_commit();
  return std::string("delcert ") + version + (commit.empty() ? "" : ", commit " + commit);
}

unsigned threads_or_all(unsigned threads) {
  return threads > 0 ? threads : std::max(1U, std::thread::hardware_concurrency());
}

void decide_anew(const std::string& log, const CampaignPlan& plan, const std::map<Block, BlockRecord>& finished,
                 unsigned threads, const Progress& progress) {
  if (log.empty()) return;
  try {
    require_evidence(plan, finished, threads, progress);
  } catch (const Rejection& rejection) {
    throw Rejection(log + ": " + rejection.what());
  }
}

}  // namespace delcert
