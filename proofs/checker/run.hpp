#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "proofs/checker/report.hpp"

namespace delcert::checker {

/// What became of one level. It holds if it is `passed`.
struct LevelResult {
  enum class State { passed, rejected, undecided, unsupported };
  std::string level;
  State state = State::passed;
  std::vector<Finding> findings;  // the broken rules, or why it is undecided or unsupported
  std::string summary;            // what was looked at
  double seconds = 0;
};

/// What became of a certificate: the exit status of the format, and the levels that were checked.
struct Outcome {
  int status = 0;
  std::optional<Finding> malformed;
  std::vector<LevelResult> levels;
  std::vector<std::string> unchecked;  // claimed, but not selected
};

/// Checks the selected levels (all that are claimed if none is selected) and those on which they rest. The text is a
/// decompressed certificate. Throws std::invalid_argument if a selected level is not claimed.
/// Precondition: self_test() found nothing in this thread.
Outcome check(std::string_view text, const std::vector<std::string>& selected);

}  // namespace delcert::checker
