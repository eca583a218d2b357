#pragma once

#include <span>
#include <string>
#include <string_view>

#include "proofs/formula/vocabulary.hpp"

namespace delcert {

/// A word that makes one number of the numbers for all elements of a set (`kernel/formula/parser.hpp`).
struct TermOverSet {
  std::string_view word;
  std::string_view meaning;
};

/// All of them, in alphabetical order.
[[nodiscard]] std::span<const TermOverSet> terms_over_sets();

/// Markdown tables of the functions of a vocabulary and of its definitions, in alphabetical order: how each is called,
/// its type, what it means. For docs/claim-format.md and `delcert claims`.
[[nodiscard]] std::string vocabulary_table(const Vocabulary& vocabulary);

/// `thickness(simplex) -> number`, `min(number, ...) -> number`.
[[nodiscard]] std::string signature_text(const Function& function);

}  // namespace delcert
