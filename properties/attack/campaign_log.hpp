#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <map>
#include <string>
#include <utility>

#include "properties/attack/tally.hpp"

namespace delcert {

/// The log of a campaign: a first line that says which campaign, then one line for each finished block, appended and
/// flushed when it is done. A last line that was cut off by a crash counts as not written.
class CampaignLog {
 public:
  using Block = std::pair<std::size_t, std::uint64_t>;  ///< target, first sample

  /// Opens or begins the log; an empty path keeps nothing. Throws InputError, naming the line, for a log of another
  /// campaign or a line in the midst that is none, std::runtime_error if it cannot be written.
  CampaignLog(const std::filesystem::path& path, const std::string& identity);

  [[nodiscard]] const std::map<Block, Tally>& finished() const { return finished_; }
  void append(const Block& block, const Tally& tally);

 private:
  void read(const std::filesystem::path& path, const std::string& identity);
  std::map<Block, Tally> finished_;
  std::ofstream out_;
};

}  // namespace delcert
