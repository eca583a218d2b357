#pragma once

#include <cstdint>
#include <map>
#include <utility>

#include "properties/attack/job_log.hpp"
#include "properties/attack/tally.hpp"

namespace delcert {

/// The log of a campaign: a line for each finished block.
class CampaignLog {
 public:
  using Block = std::pair<std::size_t, std::uint64_t>;  ///< target, first sample

  /// Opens or begins the log, as JobLog does.
  CampaignLog(const std::filesystem::path& path, const std::string& identity);

  [[nodiscard]] const std::map<Block, Tally>& finished() const { return finished_; }
  /// Throws std::runtime_error if it cannot be written.
  void append(const Block& block, const Tally& tally);

 private:
  std::map<Block, Tally> finished_;
  JobLog log_;
};

}  // namespace delcert
