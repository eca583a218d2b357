#pragma once

#include <string>

#include "kernel/formula/formula_error.hpp"
#include "proofs/formula/step.hpp"
#include "proofs/formula/vocabulary.hpp"
#include "support/toml_reader.hpp"

namespace delcert {

/// Reads TOML files with formulas in them.
class FormulaReader : public TomlReader {
 public:
  using TomlReader::TomlReader;

  /// The error stands where in the string value of the node the formula is wrong.
  [[noreturn]] void fail_in(const toml::node& node, const FormulaError& error) const;

  /// Names of claims and their parts: small letters, digits, '-', '.', '_'.
  void require_name(const toml::node& node, const std::string& name) const;

  [[nodiscard]] Statement formula(const toml::node& node, const std::string& name, const Vocabulary& vocabulary,
                                  const Signature& signature, const Type& type) const;

  /// What `read` makes of the string that the node is; its FormulaError is put in its place.
  template <class Read>
  [[nodiscard]] auto in_string(const toml::node& node, const std::string& wanted, const Read& read) const {
    const auto text = node.value_exact<std::string>();
    if (!text) fail(node.source(), wanted);
    try {
      return read(*text);
    } catch (const FormulaError& error) {
      fail_in(node, error);
    }
  }
};

}  // namespace delcert
