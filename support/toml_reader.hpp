#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "support/toml.hpp"

namespace delcert {

/// Reads the parts of a TOML file; everything that is not as expected is an InputError "file:line:column: …".
/// Lines and columns count from 1, columns in characters.
class TomlReader {
 public:
  /// `file` is what messages call the text. Precondition: the text outlives the reader.
  TomlReader(std::string_view text, std::string file) : text_(text), file_(std::move(file)) {}

  [[nodiscard]] const std::string& file() const { return file_; }
  [[nodiscard]] toml::table parse() const;

  [[noreturn]] void fail(std::size_t line, std::size_t column, const std::string& message) const;
  [[noreturn]] void fail(const toml::source_region& where, const std::string& message) const;
  /// "WHAT: found …, expected EXPECTED", where the node stands.
  [[noreturn]] void fail(const toml::node& node, std::string_view what, std::string_view expected) const;

  /// Only these keys are in the table.
  void refuse_unknown(const toml::table& table, const std::vector<std::string>& known) const;

  /// The value of a key; if it is missing the message says what was expected, where that is given.
  [[nodiscard]] const toml::node& required(const toml::table& table, std::string_view key,
                                           std::string_view expected = {}) const;
  /// Empty if the key is missing and not required.
  [[nodiscard]] std::string string(const toml::table& table, std::string_view key, bool required) const;
  /// 1 to 64 bytes.
  [[nodiscard]] std::string short_string(const toml::table& table, std::string_view key) const;
  /// nullptr if the key is missing; at most 1000 entries.
  [[nodiscard]] const toml::array* list(const toml::table& table, std::string_view key) const;
  /// Of a key, or of a node that messages call `what`.
  [[nodiscard]] int integer(const toml::table& table, std::string_view key, int least, int greatest) const;
  [[nodiscard]] int integer(const toml::node& node, std::string_view what, int least, int greatest) const;

  /// The entries of a square matrix, row by row: `entry(row, column, node, what)` is called for each.
  template <class Entry>
  void for_each_entry(const toml::node& node, std::size_t order, const std::string& what, const Entry& entry) const {
    const toml::array& rows = array(node, order, what, "rows of " + std::to_string(order) + " numbers");
    for (std::size_t row = 0; row < order; ++row) {
      const std::string name = what + ", row " + std::to_string(row + 1);
      const toml::array& entries = array(rows[row], order, name, "numbers");
      for (std::size_t column = 0; column < order; ++column)
        entry(row, column, entries[column], name + ", entry " + std::to_string(column + 1));
    }
  }

 protected:
  [[nodiscard]] std::string_view text() const { return text_; }

 private:
  [[nodiscard]] const toml::array& array(const toml::node& node, std::size_t length, std::string_view what,
                                         std::string_view of) const;

  std::string_view text_;
  std::string file_;
};

/// `key "KEY"`, for messages.
[[nodiscard]] std::string key_in_words(std::string_view key);

}  // namespace delcert
