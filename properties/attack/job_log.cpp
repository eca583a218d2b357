#include "properties/attack/job_log.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <nlohmann/json.hpp>
#include <system_error>
#include <thread>

#include "support/error.hpp"
#include "support/host.hpp"
#include "support/utc_time.hpp"

namespace delcert {

namespace {

using Json = nlohmann::ordered_json;

constexpr const char* writer_key = "writer";

LogWriter writer_from(const Json& json) {
  LogWriter result{json.at("host").get<std::string>(), json.at("process").get<long>(),
                   json.at("begun").get<std::string>()};
  (void)parse_utc(result.begun);
  return result;
}

/// Who writes to it, as its last line about writers says.
std::string writer_text(const std::filesystem::path& path, const std::string& what) {
  const auto any = [](const Json&, std::size_t) {};
  try {
    const JobLogContents contents = read_job_log(path, what, any, any);
    if (!contents.writers.empty()) {
      const LogWriter& last = contents.writers.back();
      return "process " + std::to_string(last.process) + " on " + last.host + ", since " + last.begun + ",";
    }
  } catch (const InputError&) {
    // It is locked all the same.
  }
  return "another process";
}

/// Whether it could be had; who only asks whether it is locked holds it for a moment.
bool lock(int descriptor, const std::filesystem::path& path) {
  constexpr int attempts = 10;
  for (int attempt = 0; attempt < attempts; ++attempt) {
    if (::flock(descriptor, LOCK_EX | LOCK_NB) == 0) return true;
    if (errno != EWOULDBLOCK && errno != EINTR) throw InputError(path.string() + ": cannot be locked");
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  return false;
}

}  // namespace

JobLog::JobLog(const std::filesystem::path& path, std::string what, const Json& first, const ReadLine& agree,
               const ReadLine& read)
    : what_(std::move(what)), path_(path) {
  if (path.empty()) return;
  std::error_code unknown;
  if (std::filesystem::is_directory(path, unknown)) throw InputError(path.string() + ": a folder, not a log");
  descriptor_ = ::open(path.c_str(), O_RDWR | O_CREAT | O_APPEND | O_CLOEXEC, 0666);
  if (descriptor_ < 0) throw InputError(path.string() + ": the log of the " + what_ + " cannot be written");
  try {
    if (!lock(descriptor_, path))
      throw InputError(path.string() + ": " + writer_text(path, what_) + " writes to this log");
    const ChainedFile file =
        read_chained_lines(path, "the log of a " + what_, chain_, [&](const Json& line, std::size_t number) {
          if (number == 1) {
            (void)line.at("delcert_" + what_);
            return agree(line, number);
          }
          if (!line.contains(writer_key)) read(line, number);
        });
    // What a crash cut off; but nothing is cut off from a file that was no log.
    if (file.lines == 0 && !Chain().seal(first).starts_with(file.torn)) {
      throw InputError(path.string() + ":1: not the first line of the log of this " + what_);
    }
    if (!file.torn.empty()) std::filesystem::resize_file(path, file.whole);
    if (file.lines == 0) write(first);
  } catch (...) {
    ::close(descriptor_);
    throw;
  }
}

JobLog::JobLog(const std::filesystem::path& path, std::string what, const std::string& identity, const ReadLine& read)
    : JobLog(
          path, what, Json{{"delcert_" + what, identity}},
          [&](const Json& line, std::size_t) {
            if (line.at("delcert_" + what) == identity) return;
            throw InputError("the log of another " + what + ": other claims, other numbers or another version");
          },
          read) {}

JobLog::~JobLog() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

void JobLog::begin() {
  if (begun_ || descriptor_ < 0) return;
  begun_ = true;
  write({{writer_key,
          {{"host", host_name()},
           {"process", static_cast<long>(::getpid())},
           {"begun", utc_text(std::chrono::system_clock::now())}}}});
}

void JobLog::append(const Json& line) {
  if (descriptor_ < 0) return;
  begin();
  write(line);
}

void JobLog::write(const Json& line) {
  const std::string text = chain_.seal(line) + "\n";
  std::string_view rest = text;
  while (!rest.empty()) {
    const ::ssize_t written = ::write(descriptor_, rest.data(), rest.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) {
      throw std::system_error(errno, std::generic_category(),
                              path_.string() + ": the log of the " + what_ + " cannot be written");
    }
    rest.remove_prefix(static_cast<std::size_t>(written));
  }
}

JobLogContents read_job_log(const std::filesystem::path& path, const std::string& what, const JobLog::ReadLine& first,
                            const JobLog::ReadLine& read) {
  std::error_code unknown;
  if (std::filesystem::is_directory(path, unknown)) throw InputError(path.string() + ": a folder, not a log");
  JobLogContents result;
  Chain chain;
  result.file = read_chained_lines(path, "the log of a " + what, chain, [&](const Json& line, std::size_t number) {
    if (number == 1) {
      (void)line.at("delcert_" + what);
      first(line, number);
    } else if (line.contains(writer_key)) {
      result.writers.push_back(writer_from(line.at(writer_key)));
    } else {
      read(line, number);
    }
  });
  if (result.file.lines == 0) throw InputError(path.string() + ":1: not the first line of the log of a " + what);
  result.sum = chain.sum();
  return result;
}

bool is_being_written(const std::filesystem::path& path) {
  const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0) return false;
  const bool locked = ::flock(descriptor, LOCK_SH | LOCK_NB) != 0 && errno == EWOULDBLOCK;
  ::close(descriptor);
  return locked;
}

}  // namespace delcert
