#include "proofs/formula/formula_reader.hpp"

#include <algorithm>

#include "kernel/formula/parser.hpp"
#include "proofs/formula/type_check.hpp"

namespace delcert {

namespace {

bool is_name(std::string_view text) {
  const auto fits = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '-' || c == '.' || c == '_';
  };
  const auto is_sign = [](char c) { return c == '-' || c == '.' || c == '_'; };
  return !text.empty() && text.size() <= 80 && !is_sign(text[0]) && std::all_of(text.begin(), text.end(), fits);
}

}  // namespace

void FormulaReader::require_name(const toml::node& node, const std::string& name) const {
  if (!is_name(name)) {
    fail(node.source(),
         "a name is made of at most 80 small letters, digits, '-', '.' and '_', and begins with a letter or a digit");
  }
}

Statement FormulaReader::formula(const toml::node& node, const std::string& name, const Vocabulary& vocabulary,
                                 const Signature& signature, const Type& type) const {
  return in_string(node, "a formula expects a string", [&](const std::string& text) {
    return Statement{name, text, type_checked(parse_formula(text), vocabulary, signature, type)};
  });
}

Statement FormulaReader::formula(const toml::node& node, const std::string& name, const Vocabulary& vocabulary,
                                 const Signature& signature) const {
  return in_string(node, "a formula expects a string", [&](const std::string& text) {
    return Statement{name, text, type_checked(parse_formula(text), vocabulary, signature)};
  });
}

}  // namespace delcert
