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
  /// campaign or a line in the midst that is none, and for a file that cannot be opened. A file that is no log is left
  /// as it is.
  CampaignLog(const std::filesystem::path& path, const std::string& identity);

  [[nodiscard]] const std::map<Block, Tally>& finished() const { return finished_; }
  /// Throws std::runtime_error if it cannot be written.
  void append(const Block& block, const Tally& tally);

 private:
  /// How many bytes of it are whole lines; what follows them is cut off.
  std::size_t read(const std::filesystem::path& path, const std::string& identity);
  std::map<Block, Tally> finished_;
  std::ofstream out_;
};

}  // namespace delcert
