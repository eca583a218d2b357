#pragma once

// As in kernel/manifold/manifold_file.cpp: toml++ 3.3.0 asserts what a file can break. For sources, not for headers:
// who includes this is compiled with assertions.
#undef NDEBUG
#define TOML_ASSERT(condition) static_cast<void>(0)
#include <toml++/toml.h>

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include "support/error.hpp"

namespace delcert {

/// What the readers of space forms and of metric fields have in common: values of a table, or an InputError that says
/// file, line, column, what was found and what was expected.
class TomlReader {
 protected:
  TomlReader(const toml::table& table, const std::string& source) : table_(table), source_(source) {}

  [[nodiscard]] const toml::table& table() const { return table_; }

  [[noreturn]] void fail_at(const toml::node& node, const std::string& message) const {
    throw InputError(position(node.source()) + message);
  }
  [[noreturn]] void fail(const toml::node& node, const std::string& what, const std::string& expected) const {
    std::string found = "a value of another type";
    if (const auto* integer = node.as_integer()) found = std::to_string(integer->get());
    if (const auto* string = node.as_string()) found = "\"" + string->get().substr(0, 80) + "\"";
    if (const auto* array = node.as_array()) found = "an array of length " + std::to_string(array->size());
    if (node.is_floating_point()) found = "a floating-point number, which would be rounded before it is read";
    fail_at(node, what + ": found " + found + ", expected " + expected);
  }

  /// Only these keys are in the table.
  void allow(const toml::table& table, const std::vector<std::string_view>& keys) const {
    for (const auto& [key, value] : table) {
      if (std::find(keys.begin(), keys.end(), key.str()) != keys.end()) continue;
      std::string known;
      for (const std::string_view name : keys) known += (known.empty() ? "" : ", ") + std::string(name);
      throw InputError(position(key.source()) + "unknown key \"" + std::string(key.str()) + "\", expected: " + known);
    }
  }

  [[nodiscard]] const toml::node& node(const toml::table& table, std::string_view key) const {
    const toml::node* node = table.get(key);
    if (node == nullptr) throw InputError(source_ + ": key \"" + std::string(key) + "\" is missing");
    return *node;
  }
  [[nodiscard]] const toml::node& node(std::string_view key) const { return node(table_, key); }

  [[nodiscard]] std::string text(std::string_view key) const {
    const toml::node& node = this->node(key);
    const auto* value = node.as_string();
    if (value == nullptr || value->get().empty() || value->get().size() > 64)
      fail(node, in_words(key), "a string of 1 to 64 bytes");
    return value->get();
  }

  [[nodiscard]] int integer(const toml::node& node, const std::string& what, int least, int greatest) const {
    const auto* value = node.as_integer();
    if (value == nullptr || value->get() < least || value->get() > greatest)
      fail(node, what, "an integer from " + std::to_string(least) + " to " + std::to_string(greatest));
    return static_cast<int>(value->get());
  }
  [[nodiscard]] int integer(std::string_view key, int least, int greatest) const {
    return integer(node(key), in_words(key), least, greatest);
  }

  /// The elements of a matrix, row by row: `entry(row, column, node, what)` is called for each.
  template <class Entry>
  void for_each_entry(const toml::node& node, std::size_t order, const std::string& what, const Entry& entry) const {
    const std::string size = std::to_string(order);
    const auto* rows = node.as_array();
    if (rows == nullptr || rows->size() != order) fail(node, what, "an array of " + size + " rows");
    for (std::size_t row = 0; row < order; ++row) {
      const auto* entries = (*rows)[row].as_array();
      const std::string name = what + ", row " + std::to_string(row + 1);
      if (entries == nullptr || entries->size() != order) fail((*rows)[row], name, "an array of " + size + " numbers");
      for (std::size_t column = 0; column < order; ++column)
        entry(row, column, (*entries)[column], name + ", entry " + std::to_string(column + 1));
    }
  }

  [[nodiscard]] static std::string in_words(std::string_view key) { return "key \"" + std::string(key) + "\""; }

 private:
  [[nodiscard]] std::string position(const toml::source_region& where) const {
    return source_ + ":" + std::to_string(where.begin.line) + ":" + std::to_string(where.begin.column) + ": ";
  }

  const toml::table& table_;
  const std::string& source_;
};

/// What a reader makes of a text; `source` is what errors call it. Throws InputError.
template <class Reader>
[[nodiscard]] auto read_toml(std::string_view text, const std::string& source) {
  try {
    const toml::table table = toml::parse(text, source);
    return Reader(table, source).read();
  } catch (const toml::parse_error& error) {
    const auto& where = error.source().begin;
    throw InputError(source + ":" + std::to_string(where.line) + ":" + std::to_string(where.column) +
                     ": not TOML: " + std::string(error.description()));
  }
}

}  // namespace delcert
