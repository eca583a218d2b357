#include "support/toml_reader.hpp"

#include <algorithm>
#include <sstream>

#include "support/error.hpp"
#include "support/spelling.hpp"

namespace delcert {

namespace {

constexpr std::size_t most_parts = 1000;

/// Texts come from files: what is quoted stays on one line.
std::string on_one_line(std::string_view text) {
  std::string result(text);
  std::replace_if(
      result.begin(), result.end(), [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; }, '?');
  return result;
}

/// What a value is, for "found …".
std::string description_of(const toml::node& node) {
  std::ostringstream stream;
  if (node.is_table()) return "a table";
  if (const auto* array = node.as_array()) return "an array of length " + std::to_string(array->size());
  if (const auto* string = node.as_string()) return "\"" + shortened(string->get()) + "\"";
  if (const auto* integer = node.as_integer()) {
    stream << *integer;
    return "the integer " + stream.str();
  }
  if (const auto* number = node.as_floating_point()) {
    stream << *number;
    return "the floating-point number " + stream.str();
  }
  if (const auto* boolean = node.as_boolean()) return boolean->get() ? "the boolean true" : "the boolean false";
  return "a date or a time";
}

}  // namespace

std::string key_in_words(std::string_view key) { return "key \"" + std::string(key) + "\""; }

void TomlReader::fail(std::size_t line, std::size_t column, const std::string& message) const {
  throw InputError(file_ + ":" + std::to_string(line) + ":" + std::to_string(column) + ": " + message);
}

void TomlReader::fail(const toml::source_region& where, const std::string& message) const {
  fail(where.begin.line, where.begin.column, message);
}

void TomlReader::fail(const toml::node& node, std::string_view what, std::string_view expected) const {
  fail(node.source(), std::string(what) + ": found " + description_of(node) + ", expected " + std::string(expected));
}

toml::table TomlReader::parse() const {
  try {
    return toml::parse(text_);
  } catch (const toml::parse_error& error) {
    fail(error.source(), "not TOML: " + on_one_line(error.description()));
  }
}

void TomlReader::refuse_unknown(const toml::table& table, const std::vector<std::string>& known) const {
  for (const auto& [key, node] : table) {
    const std::string_view word = key.str();
    if (std::find(known.begin(), known.end(), word) != known.end()) continue;
    std::string hint = suggestion(word, known);
    if (hint.empty()) {
      for (const std::string& each : known) hint += (hint.empty() ? ", expected: " : ", ") + each;
    }
    fail(key.source(), "unknown key " + shortened(word) + hint);
  }
}

const toml::node& TomlReader::required(const toml::table& table, std::string_view key,
                                       std::string_view expected) const {
  const toml::node* node = table.get(key);
  if (node == nullptr) {
    fail(table.source(), "the key " + std::string(key) + " is missing" +
                             (expected.empty() ? "" : ", expected " + std::string(expected)));
  }
  return *node;
}

std::string TomlReader::string(const toml::table& table, std::string_view key, bool required) const {
  const toml::node* node = table.get(key);
  if (node == nullptr) {
    if (required) (void)this->required(table, key);
    return "";
  }
  const auto value = node->value_exact<std::string>();
  if (!value) fail(node->source(), "the key " + std::string(key) + " expects a string");
  if (required && value->empty()) {
    fail(node->source(), "the key " + std::string(key) + " expects a string that is not empty");
  }
  return *value;
}

std::string TomlReader::short_string(const toml::table& table, std::string_view key) const {
  const toml::node& node = required(table, key);
  const auto* value = node.as_string();
  if (value == nullptr || value->get().empty() || value->get().size() > 64) {
    fail(node, key_in_words(key), "a string of 1 to 64 bytes");
  }
  return value->get();
}

const toml::array* TomlReader::list(const toml::table& table, std::string_view key) const {
  const toml::node* node = table.get(key);
  if (node == nullptr) return nullptr;
  if (!node->is_array()) fail(node->source(), "the key " + std::string(key) + " expects a list");
  if (node->as_array()->size() > most_parts) {
    fail(node->source(), "more than 1000 parts of the key " + std::string(key));
  }
  return node->as_array();
}

int TomlReader::integer(const toml::node& node, std::string_view what, int least, int greatest) const {
  const auto* value = node.as_integer();
  if (value == nullptr || value->get() < least || value->get() > greatest) {
    fail(node, what, "an integer from " + std::to_string(least) + " to " + std::to_string(greatest));
  }
  return static_cast<int>(value->get());
}

int TomlReader::integer(const toml::table& table, std::string_view key, int least, int greatest) const {
  const std::string expected = "an integer from " + std::to_string(least) + " to " + std::to_string(greatest);
  return integer(required(table, key, expected), key_in_words(key), least, greatest);
}

const toml::array& TomlReader::array(const toml::node& node, std::size_t length, std::string_view what,
                                     std::string_view of) const {
  const auto* result = node.as_array();
  if (result == nullptr || result->size() != length) {
    fail(node, what, "an array of " + std::to_string(length) + " " + std::string(of));
  }
  return *result;
}

}  // namespace delcert
