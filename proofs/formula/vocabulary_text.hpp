#pragma once

#include <string>

#include "proofs/formula/vocabulary.hpp"

namespace delcert {

/// Markdown tables of the functions of a vocabulary and of its definitions, in alphabetical order: how each is called,
/// its type, what it means. For docs/claim-format.md and `delcert claims`.
[[nodiscard]] std::string vocabulary_table(const Vocabulary& vocabulary);

/// `thickness(simplex) -> number`, `min(number, ...) -> number`.
[[nodiscard]] std::string signature_text(const Function& function);

}  // namespace delcert
