#pragma once

#include <filesystem>
#include <fstream>
#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <string>

namespace delcert {

/// The log of long work that goes on from it: a first line that says which work, then one line of JSON for each job,
/// appended and flushed when it is done. A last line that was cut off by a crash counts as not written.
class JobLog {
 public:
  using ReadLine = std::function<void(const nlohmann::ordered_json&)>;

  /// Opens or begins the log, and calls `read` for every line that it has after the first; an empty path keeps nothing.
  /// `what` is the kind of work in one word, `identity` everything on which its results depend. Throws InputError,
  /// naming the line, for a log of another work, for a line in the midst that is broken or that `read` refuses, and for
  /// a file that cannot be opened. A file that is no log is left as it is.
  JobLog(const std::filesystem::path& path, std::string what, const std::string& identity, const ReadLine& read);

  /// Throws std::runtime_error if it cannot be written.
  void append(const nlohmann::ordered_json& line);

 private:
  [[nodiscard]] std::string first_line(const std::string& identity) const;
  /// How many bytes of it are whole lines; what follows them is cut off.
  std::size_t read_lines(const std::filesystem::path& path, const std::string& identity, const ReadLine& read) const;

  std::string what_;
  std::ofstream out_;
};

}  // namespace delcert
