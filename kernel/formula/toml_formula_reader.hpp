#pragma once

#include <string>

#include "kernel/formula/formula_error.hpp"
#include "support/toml_reader.hpp"

namespace delcert {

/// Reads TOML files with formulas in them: what is wrong within a formula is shown at its place in the file.
class TomlFormulaReader : public TomlReader {
 public:
  using TomlReader::TomlReader;

  /// The error stands where in the string value of the node the formula is wrong.
  [[noreturn]] void fail_in(const toml::node& node, const FormulaError& error) const;

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
