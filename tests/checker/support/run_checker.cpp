#include "tests/checker/support/run_checker.hpp"

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>

namespace delcert::checker_tests {
namespace {

/// Removes its file when the process ends.
struct TemporaryFile {
  std::string path =
      (std::filesystem::temp_directory_path() / ("delcert-check-test-" + std::to_string(getpid()))).string();
  ~TemporaryFile() { std::filesystem::remove(path); }
};

rusage usage_of_children() {
  rusage usage{};
  getrusage(RUSAGE_CHILDREN, &usage);
  return usage;
}

double seconds_of_children() {
  const rusage usage = usage_of_children();
  return static_cast<double>(usage.ru_utime.tv_sec + usage.ru_stime.tv_sec) +
         1e-6 * static_cast<double>(usage.ru_utime.tv_usec + usage.ru_stime.tv_usec);
}

/// The checker of this build, or the one that the environment names, for tests of tests.
std::string checker() {
  const char* other = std::getenv("DELCERT_CHECK");
  return other != nullptr ? other : DELCERT_CHECK;
}

CheckerRun run(const std::string& command) {
  CheckerRun result;
  const double before = seconds_of_children();
  std::FILE* pipe = popen((command + " 2>&1").c_str(), "r");
  if (pipe == nullptr) throw std::runtime_error("cannot run " + command);
  std::array<char, 4096> block{};
  while (const std::size_t got = std::fread(block.data(), 1, block.size(), pipe))
    result.output.append(block.data(), got);
  const int status = pclose(pipe);
  if (WIFEXITED(status)) result.status = WEXITSTATUS(status);
  result.seconds = seconds_of_children() - before;
  result.peak_kib = usage_of_children().ru_maxrss;
  return result;
}

}  // namespace

std::string temporary_file(const std::string& bytes) {
  static const TemporaryFile file;
  std::ofstream(file.path, std::ios::binary) << bytes;
  return file.path;
}

CheckerRun run_checker_with(const std::string& arguments) { return run(checker() + " " + arguments); }
CheckerRun run_crippled_checker_with(const std::string& arguments) {
  return run(std::string(DELCERT_CHECK_CRIPPLED) + " " + arguments);
}

CheckerRun run_checker(const std::string& bytes, const std::string& without_rule) {
  const std::string file = temporary_file(bytes);
  CheckerRun result =
      run((without_rule.empty() ? checker() : DELCERT_CHECK_CRIPPLED " --without-rule " + without_rule) + " --json " +
          file);
  const auto json = nlohmann::json::parse(result.output, nullptr, false);
  if (json.is_discarded()) return result;
  const auto add = [&](const nlohmann::json& finding) {
    const auto rule = finding["rule"].get<std::string>();
    result.rules.insert(rule);
    if (result.message.empty()) result.message = rule + ": " + finding["what"].get<std::string>();
  };
  if (!json["malformed"].is_null()) add(json["malformed"]);
  for (const auto& level : json["levels"]) {
    for (const auto& finding : level["findings"]) add(finding);
  }
  return result;
}

}  // namespace delcert::checker_tests
