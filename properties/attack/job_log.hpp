#pragma once

#include <filesystem>
#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "properties/attack/chained_lines.hpp"

namespace delcert {

/// A process that wrote to a log, and when it began.
struct LogWriter {
  std::string host;
  long process = 0;
  std::string begun;  ///< as `utc_text` writes it
};

/// The log of long work that goes on from it: a first line that says which work, then one line of JSON for each job,
/// written in one go when it is done, and one for each process that did some. Lines are chained. A last line that was
/// cut off by a crash counts as not written. One process at a time writes to it.
class JobLog {
 public:
  using Json = nlohmann::ordered_json;
  /// Is given a line with its number, from 1. What it refuses is an InputError or a nlohmann::json::exception.
  using ReadLine = std::function<void(const Json& line, std::size_t number)>;

  /// Opens or begins the log. `what` is the kind of work in one word; `first` is the first line of a new log, `agree`
  /// is given that of one that is there, and refuses that of other work; `read` is called for every other line but
  /// those of writers. An empty path keeps nothing. Throws InputError, naming the line, for what they refuse and for
  /// lines that are broken or do not fit those before them; for a file that cannot be opened; and for one that another
  /// process writes, which it names. A file that is no log is left as it is.
  JobLog(const std::filesystem::path& path, std::string what, const Json& first, const ReadLine& agree,
         const ReadLine& read);
  /// The same for work of which `identity` says all on which its results depend.
  JobLog(const std::filesystem::path& path, std::string what, const std::string& identity, const ReadLine& read);
  ~JobLog();
  JobLog(const JobLog&) = delete;
  JobLog& operator=(const JobLog&) = delete;

  /// Throws std::runtime_error if it cannot be written. The first line is preceded by one that names this process.
  void append(const Json& line);
  /// Writes that one already now, so that others see who works.
  void begin();

 private:
  void write(const Json& line);

  std::string what_;
  std::filesystem::path path_;
  Chain chain_;
  int descriptor_ = -1;
  bool begun_ = false;
};

/// What a log holds besides its lines.
struct JobLogContents {
  ChainedFile file;
  std::string sum;  ///< the last one
  std::vector<LogWriter> writers;
};

/// Reads a log without writing to it; `first` is given its first line, `read` all others but those of writers. Throws
/// InputError as JobLog does.
[[nodiscard]] JobLogContents read_job_log(const std::filesystem::path& path, const std::string& what,
                                          const JobLog::ReadLine& first, const JobLog::ReadLine& read);

/// Whether a process, this one included, has the log open to write to it.
[[nodiscard]] bool is_being_written(const std::filesystem::path& path);

}  // namespace delcert
