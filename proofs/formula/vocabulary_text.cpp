#include "proofs/formula/vocabulary_text.hpp"

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
  result += "\n| definition | formula | what it is |\n|---|---|---|\n";
  for (const auto& [name, definition] : vocabulary.definitions()) {
    result += "| `" + name + "(" + parameters_text(definition) + ")` | `" + cell(definition.text) + "` | " +
              cell(definition.meaning) + " |\n";
  }
  return result;
}

}  // namespace delcert
