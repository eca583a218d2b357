#include "proofs/formula/vocabulary_text.hpp"

#include <array>

namespace delcert {

namespace {

/// A cell of a table must not end it.
std::string cell(const std::string& text) {
  std::string result;
  for (const char c : text) result += c == '|' ? "\\|" : c == '\n' ? " " : std::string(1, c);
  return result;
}

std::string parameters_text(const Definition& definition) {
  std::string result;
  for (const std::string& parameter : definition.parameters) result += (result.empty() ? "" : ", ") + parameter;
  return result;
}

}  // namespace

std::span<const TermOverSet> terms_over_sets() {
  static constexpr std::array<TermOverSet, 4> all{
      TermOverSet{"max", "The greatest of the numbers for all elements x of a set; undefined if it is empty."},
      TermOverSet{"min", "The least of them; undefined if the set is empty."},
      TermOverSet{"product", "Their product, 1 if the set is empty."},
      TermOverSet{"sum", "Their sum, 0 if the set is empty."}};
  return all;
}

std::string signature_text(const Function& function) {
  std::string result = function.name + "(";
  for (std::size_t at = 0; at < function.parameters.size(); ++at) {
    result += (at == 0 ? "" : ", ") + function.parameters[at].text();
  }
  return result + (function.is_variadic ? ", ...)" : ")") + " -> " + function.result.text();
}

std::string vocabulary_table(const Vocabulary& vocabulary) {
  std::string result = "| function | what it is |\n|---|---|\n";
  for (const auto& [name, function] : vocabulary.functions()) {
    result += "| `" + cell(signature_text(function)) + "` | " + cell(function.meaning) + " |\n";
  }
  result += "\n| over a set | what it is |\n|---|---|\n";
  for (const TermOverSet& term : terms_over_sets()) {
    result += "| `" + std::string(term.word) + "(x in set: number) -> number` | " + std::string(term.meaning) + " |\n";
  }
  result += "\n| definition | formula | what it is |\n|---|---|---|\n";
  for (const auto& [name, definition] : vocabulary.definitions()) {
    result += "| `" + name + "(" + parameters_text(definition) + ")` | `" + cell(definition.text) + "` | " +
              cell(definition.meaning) + " |\n";
  }
  return result;
}

}  // namespace delcert
