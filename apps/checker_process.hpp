#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace delcert {

/// The program delcert-check of this installation. Throws std::runtime_error, naming the places where it was looked
/// for.
[[nodiscard]] std::filesystem::path installed_checker();

/// What a program printed on standard output, and how it ended.
struct CheckerRun {
  int status = 0;  ///< its exit status; 128 + the signal that ended it
  std::string output;
};

/// Runs the checker with these arguments and waits for it. Standard error is that of this process. Throws
/// std::system_error if it cannot be started.
[[nodiscard]] CheckerRun run_checker_with(const std::filesystem::path& checker, std::vector<std::string> arguments);

/// The same with `--json` and a file.
[[nodiscard]] CheckerRun run_checker_on(const std::filesystem::path& checker, const std::filesystem::path& certificate);

}  // namespace delcert
