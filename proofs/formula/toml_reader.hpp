#pragma once

#include <toml++/toml.h>

#include <string>
#include <vector>

#include "proofs/formula/formula_error.hpp"
#include "proofs/formula/step.hpp"
#include "proofs/formula/vocabulary.hpp"

namespace delcert {

/// Reads the parts of a TOML file; everything that is not as expected is an InputError "file:line:column: …".
/// Lines and columns count from 1, columns in characters.
class TomlReader {
 public:
  /// Precondition: the text outlives it.
  TomlReader(const std::string& text, std::string file) : text_(text), file_(std::move(file)) {}

  [[nodiscard]] const std::string& file() const { return file_; }
  [[nodiscard]] toml::table parse() const;

  [[noreturn]] void fail(const toml::source_region& where, const std::string& message) const;
  /// The error stands where in the string value of the node the formula is wrong.
  [[noreturn]] void fail_in(const toml::node& node, const FormulaError& error) const;

  void refuse_unknown(const toml::table& table, const std::vector<std::string>& known) const;
  /// Names of claims and their parts: small letters, digits, '-', '.', '_'.
  void require_name(const toml::node& node, const std::string& name) const;

  /// Empty if the key is missing and not required.
  [[nodiscard]] std::string string(const toml::table& table, const std::string& key, bool required) const;
  /// nullptr if the key is missing; at most 1000 entries.
  [[nodiscard]] const toml::array* list(const toml::table& table, const std::string& key) const;
  [[nodiscard]] const toml::node& required(const toml::table& table, const std::string& key) const;
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

 private:
  [[noreturn]] void fail(std::size_t line, std::size_t column, const std::string& message) const;

  const std::string& text_;
  std::string file_;
};

}  // namespace delcert
