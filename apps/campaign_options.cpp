#include "apps/campaign_options.hpp"

#include <algorithm>
#include <delcert_version.hpp>
#include <thread>

#include "apps/build_commit.hpp"

namespace delcert {

std::string software_name() {
  const std::string commit = build_commit();
  return std::string("delcert ") + version + (commit.empty() ? "" : ", commit " + commit);
}

unsigned threads_or_all(unsigned threads) {
  return threads > 0 ? threads : std::max(1U, std::thread::hardware_concurrency());
}

}  // namespace delcert
