#pragma once

#include <string>
#include <vector>

namespace delcert {

/// A file of proofs/claims as this program has it: the same files as those of `delcert`, embedded once more.
struct ReplayedClaimText {
  std::string name;  ///< the file's name without the ending
  std::string text;
};

/// All of them, ordered by name. The definition is generated (cmake/EmbedFiles.cmake).
const std::vector<ReplayedClaimText>& builtin_texts_to_replay();

}  // namespace delcert
