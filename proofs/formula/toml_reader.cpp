#include "proofs/formula/toml_reader.hpp"

#include <algorithm>

#include "proofs/formula/parser.hpp"
#include "proofs/formula/toml_position.hpp"
#include "proofs/formula/type_check.hpp"

namespace delcert {

namespace {

constexpr std::size_t most_parts = 1000;

bool is_name(std::string_view text) {
  const auto fits = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '-' || c == '.' || c == '_';
  };
  const auto is_sign = [](char c) { return c == '-' || c == '.' || c == '_'; };
  return !text.empty() && text.size() <= 80 && !is_sign(text[0]) && std::all_of(text.begin(), text.end(), fits);
}

std::string one_line(std::string_view text) {
  std::string result(text);
  std::replace_if(
      result.begin(), result.end(), [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; }, ' ');
  return result;
}

}  // namespace

void TomlReader::fail(std::size_t line, std::size_t column, const std::string& message) const {
  throw InputError(file_ + ":" + std::to_string(line) + ":" + std::to_string(column) + ": " + message);
}

void TomlReader::fail(const toml::source_region& where, const std::string& message) const {
  fail(where.begin.line, where.begin.column, message);
}

void TomlReader::fail_in(const toml::node& node, const FormulaError& error) const {
  const auto& begin = node.source().begin;
  const TextPosition where = position_in_toml_string(text_, {begin.line, begin.column}, error.offset());
  fail(where.line, where.column, error.what());
}

toml::table TomlReader::parse() const {
  try {
    return toml::parse(text_);
  } catch (const toml::parse_error& error) {
    fail(error.source(), one_line(error.description()));
  }
}

void TomlReader::refuse_unknown(const toml::table& table, const std::vector<std::string>& known) const {
  for (const auto& [key, node] : table) {
    const std::string word(key.str());
    if (std::find(known.begin(), known.end(), word) == known.end()) {
      fail(key.source(), "unknown key " + shortened(word) + suggestion(word, known));
    }
  }
}

void TomlReader::require_name(const toml::node& node, const std::string& name) const {
  if (!is_name(name)) {
    fail(node.source(),
         "a name is made of at most 80 small letters, digits, '-', '.' and '_', and begins with a letter or a digit");
  }
}

std::string TomlReader::string(const toml::table& table, const std::string& key, bool required) const {
  const toml::node* node = table.get(key);
  if (node == nullptr) {
    if (required) fail(table.source(), "the key " + key + " is missing");
    return "";
  }
  const auto value = node->value_exact<std::string>();
  if (!value) fail(node->source(), "the key " + key + " wants a string");
  if (required && value->empty()) fail(node->source(), "the key " + key + " wants a string that is not empty");
  return *value;
}

const toml::array* TomlReader::list(const toml::table& table, const std::string& key) const {
  const toml::node* node = table.get(key);
  if (node == nullptr) return nullptr;
  if (!node->is_array()) fail(node->source(), "the key " + key + " wants a list");
  if (node->as_array()->size() > most_parts) fail(node->source(), "more than 1000 parts of the key " + key);
  return node->as_array();
}

const toml::node& TomlReader::required(const toml::table& table, const std::string& key) const {
  const toml::node* node = table.get(key);
  if (node == nullptr) fail(table.source(), "the key " + key + " is missing");
  return *node;
}

Statement TomlReader::formula(const toml::node& node, const std::string& name, const Vocabulary& vocabulary,
                              const Signature& signature, const Type& type) const {
  return in_string(node, "a formula wants a string", [&](const std::string& text) {
    return Statement{name, text, type_checked(parse_formula(text), vocabulary, signature, type)};
  });
}

}  // namespace delcert
