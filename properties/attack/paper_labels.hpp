#pragma once

#include <string>
#include <vector>

#include "proofs/formula/claim.hpp"

namespace delcert {

/// A label of the paper's LaTeX source, in the order of the source.
struct PaperLabel {
  std::string label;
  /// Why no claim has it as its source; empty where one has to.
  std::string reason;
};

/// All labels of the paper but those of sections.
[[nodiscard]] const std::vector<PaperLabel>& paper_labels();

/// What is wrong with the map from labels to claims: a label without claim or reason, one with both, a claim of the
/// paper whose source is no label. Empty if nothing is.
[[nodiscard]] std::vector<std::string> complaints_about_labels(const std::vector<Claim>& claims);

/// The table label → claims with their status, or the reason, in Markdown (docs/paper-to-code.md).
[[nodiscard]] std::string paper_to_code(const std::vector<Claim>& claims);

}  // namespace delcert
