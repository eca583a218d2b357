#pragma once

#include <functional>
#include <string>
#include <vector>

#include "proofs/formula/formula_reader.hpp"

namespace delcert {

/// What claims and steps have of their own when abbreviations are read.
struct AbbreviationRules {
  /// Throws InputError for a name that cannot be used.
  std::function<void(const toml::source_region&, const std::string&)> require_free;
  /// Reads the term of a name; those that it needs have been announced.
  std::function<Statement(const toml::node&, const std::string&)> term;
  /// Makes the name known to the terms that follow.
  std::function<void(const Statement&)> announce;
};

/// The key `let` of a table: a table of names and terms, or a list of tables of `name` and `is`; in an order in which
/// each term only needs those before it. Empty if there is no such key. Throws InputError also for a term that is made
/// of itself.
[[nodiscard]] std::vector<Statement> read_abbreviations(const FormulaReader& reader, const toml::table& table,
                                                        const AbbreviationRules& rules);

}  // namespace delcert
