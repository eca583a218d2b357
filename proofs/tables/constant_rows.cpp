#include "proofs/tables/constant_rows.hpp"

#include <toml++/toml.h>

#include <algorithm>
#include <stdexcept>

#include "kernel/error.hpp"
#include "kernel/number/exact_text.hpp"
#include "proofs/formula/formula_error.hpp"

namespace delcert {

namespace {

class Reader {
 public:
  Reader(const std::string& text, std::string file) : file_(std::move(file)), table_(parse(text)) {}

  ConstantRows read() const {
    refuse_unknown(table_, {"constant", "without"});
    ConstantRows result;
    for (const toml::table* part : parts("constant")) result.rows.push_back(row(*part));
    for (const toml::table* part : parts("without")) {
      refuse_unknown(*part, {"label", "reason"});
      result.without.push_back({string(*part, "label", true), string(*part, "reason", true)});
    }
    return result;
  }

 private:
  [[noreturn]] void fail(const toml::source_region& where, const std::string& message) const {
    throw InputError(file_ + ":" + std::to_string(where.begin.line) + ":" + std::to_string(where.begin.column) + ": " +
                     message);
  }

  toml::table parse(const std::string& text) const {
    try {
      return toml::parse(text);
    } catch (const toml::parse_error& error) {
      fail(error.source(), shortened(error.description()));
    }
  }

  void refuse_unknown(const toml::table& table, const std::vector<std::string>& known) const {
    for (const auto& [key, node] : table) {
      const std::string word(key.str());
      if (std::find(known.begin(), known.end(), word) == known.end())
        fail(key.source(), "unknown key " + shortened(word) + suggestion(word, known));
    }
  }

  std::vector<const toml::table*> parts(const std::string& key) const {
    std::vector<const toml::table*> result;
    const toml::node* list = table_.get(key);
    if (list == nullptr) return result;
    if (!list->is_array()) fail(list->source(), "the key " + key + " wants tables, [[" + key + "]]");
    for (const toml::node& node : *list->as_array()) {
      if (!node.is_table()) fail(node.source(), "the key " + key + " wants tables, [[" + key + "]]");
      result.push_back(node.as_table());
    }
    return result;
  }

  std::string string(const toml::table& table, const std::string& key, bool required) const {
    const toml::node* node = table.get(key);
    if (node == nullptr && required) fail(table.source(), "the key " + key + " is missing");
    if (node == nullptr) return "";
    const auto value = node->value_exact<std::string>();
    if (!value || value->empty()) fail(node->source(), "the key " + key + " wants a string that is not empty");
    return *value;
  }

  ConstantRow row(const toml::table& table) const {
    refuse_unknown(table, {"label", "statement", "latex", "best", "claim", "conclusion", "pattern", "paper", "steps",
                           "inverse", "note"});
    ConstantRow row;
    row.label = string(table, "label", true);
    row.statement = string(table, "statement", true);
    row.latex = string(table, "latex", true);
    const std::string best = string(table, "best", true);
    if (best != "smaller" && best != "larger") fail(table.get("best")->source(), "best is \"smaller\" or \"larger\"");
    row.direction = best == "smaller" ? Direction::smaller : Direction::larger;
    row.claim = string(table, "claim", false);
    row.conclusion = string(table, "conclusion", !row.claim.empty());
    row.pattern = string(table, "pattern", !row.claim.empty());
    row.note = string(table, "note", false);
    if (table.contains("paper")) {
      try {
        row.paper = parse_exact(string(table, "paper", true));
      } catch (const ExactTextError& error) {
        fail(table.get("paper")->source(), error.what());
      }
    }
    if (const toml::node* inverse = table.get("inverse")) {
      const auto value = inverse->value_exact<bool>();
      if (!value) fail(inverse->source(), "the key inverse wants true or false");
      row.is_inverse_in_steps = *value;
    }
    if (const toml::node* steps = table.get("steps")) row.steps = step_names(*steps);
    if (row.claim.empty() && row.steps.empty()) fail(table.source(), "a constant is that of a claim or of a step");
    return row;
  }

  std::vector<std::string> step_names(const toml::node& node) const {
    if (!node.is_array()) fail(node.source(), "the key steps wants a list of \"claim/step/constant\"");
    std::vector<std::string> result;
    for (const toml::node& each : *node.as_array()) {
      const auto name = each.value_exact<std::string>();
      if (!name || std::count(name->begin(), name->end(), '/') != 2)
        fail(each.source(), "a constant of a step is \"claim/step/constant\"");
      result.push_back(*name);
    }
    return result;
  }

  std::string file_;
  toml::table table_;
};

}  // namespace

ConstantRows parse_constant_rows(const std::string& text, const std::string& file) { return Reader(text, file).read(); }

const ConstantRows& builtin_constant_rows() {
  static const ConstantRows rows = [] {
    for (const BuiltinTable& table : builtin_tables())
      if (table.name == "constants") return parse_constant_rows(table.text, "proofs/tables/constants.toml");
    throw std::logic_error("the library has no table of constants");
  }();
  return rows;
}

}  // namespace delcert
