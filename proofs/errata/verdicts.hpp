#pragma once

#include <string>
#include <vector>

namespace delcert {

/// What the findings add up to for one main result of the paper. All texts are Markdown on one line.
struct TheoremVerdict {
  std::string number;      ///< "Theorem 1"
  std::string label;       ///< its LaTeX label
  std::string as_printed;  ///< whether it is true as it is printed
  std::string hypotheses;  ///< under which hypotheses it is true
  std::string constants;   ///< with which constants
  std::string proof;       ///< where that is proved, and what the proof quotes
};

/// The verdicts on the three theorems, in the order of the paper.
[[nodiscard]] const std::vector<TheoremVerdict>& theorem_verdicts();

/// The same as a section of docs/errata.md.
[[nodiscard]] std::string verdicts_markdown();

}  // namespace delcert
