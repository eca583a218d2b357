#pragma once

#include <set>
#include <string>

namespace delcert::checker_tests {

/// What a run of the checker said.
struct CheckerRun {
  int status = -1;              // the exit status; -1 if the program was killed by a signal
  std::string output;           // what it printed
  std::set<std::string> rules;  // the rules that it says are broken
  std::string message;          // the first of them with its text
  double seconds = 0;           // of processor time
  long peak_kib = 0;            // the most memory that any run so far has used
};

/// Writes the bytes to a file and runs the checker on it with --json; with the crippled checker, without the rule.
CheckerRun run_checker(const std::string& bytes, const std::string& without_rule = "");

/// Runs the checker with the given arguments, in the words of a shell.
CheckerRun run_checker_with(const std::string& arguments);
/// The crippled checker likewise.
CheckerRun run_crippled_checker_with(const std::string& arguments);

/// A file of this process that is removed at its end.
std::string temporary_file(const std::string& bytes);

}  // namespace delcert::checker_tests
