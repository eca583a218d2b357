#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <string>

namespace delcert {

/// The lines of a log, each of which ends with a sum of itself and of all lines before it: the SHA-256, in hexadecimal,
/// of the sum of the line before (nothing for the first) followed by the object as it was without its sum. A line that
/// is changed, doubled, left out, moved or put in does not fit its sum or the next one. Whoever computes all sums anew
/// can still write what he likes.
class Chain {
 public:
  /// The line of the next object, without its line feed. Precondition: the object is not empty.
  [[nodiscard]] std::string seal(const nlohmann::ordered_json& object);
  /// The next object, without its sum. Throws InputError for a line that does not fit, nlohmann::json::exception for
  /// one that is no JSON.
  [[nodiscard]] nlohmann::ordered_json open(const std::string& line);
  /// The last sum; empty before the first line.
  [[nodiscard]] const std::string& sum() const { return sum_; }

 private:
  std::string sum_;
};

/// What a file of chained lines holds besides its lines.
struct ChainedFile {
  std::size_t lines = 0;
  std::size_t whole = 0;  ///< bytes up to the end of the last whole line
  std::string torn;       ///< what follows it: the beginning of a line that a crash cut off
};

/// Calls `read` for each whole line, numbered from 1. Throws InputError that begins with "FILE:LINE: " for a line that
/// does not fit, is no JSON, or is refused by `read` (by InputError or by nlohmann::json::exception), and one that
/// names the file where it cannot be read. `kind` is what the lines are of, for the message: "the log of a campaign".
ChainedFile read_chained_lines(const std::filesystem::path& path, const std::string& kind, Chain& chain,
                               const std::function<void(const nlohmann::ordered_json&, std::size_t)>& read);

}  // namespace delcert
