#include "proofs/tables/constant_rows.hpp"

#include <algorithm>
#include <stdexcept>

#include "kernel/number/exact_text.hpp"
#include "support/error.hpp"
#include "support/toml_reader.hpp"

namespace delcert {

namespace {

class RowReader {
 public:
  RowReader(const std::string& text, const std::string& file) : toml_(text, file), table_(toml_.parse()) {}

  ConstantRows read() const {
    toml_.refuse_unknown(table_, {"constant", "without"});
    ConstantRows result;
    for (const toml::table* part : parts("constant")) result.rows.push_back(row(*part));
    for (const toml::table* part : parts("without")) {
      toml_.refuse_unknown(*part, {"label", "reason"});
      result.without.push_back({toml_.string(*part, "label", true), toml_.string(*part, "reason", true)});
    }
    return result;
  }

 private:
  std::vector<const toml::table*> parts(const std::string& key) const {
    std::vector<const toml::table*> result;
    const toml::array* list = toml_.list(table_, key);
    if (list == nullptr) return result;
    for (const toml::node& node : *list) {
      if (!node.is_table()) toml_.fail(node.source(), "the key " + key + " expects tables, [[" + key + "]]");
      result.push_back(node.as_table());
    }
    return result;
  }

  ConstantRow row(const toml::table& table) const {
    toml_.refuse_unknown(table, {"label", "statement", "latex", "best", "claim", "conclusion", "pattern", "paper",
                                 "steps", "inverse", "note"});
    ConstantRow row;
    row.label = toml_.string(table, "label", true);
    row.statement = toml_.string(table, "statement", true);
    row.latex = toml_.string(table, "latex", true);
    const std::string best = toml_.string(table, "best", true);
    if (best != "smaller" && best != "larger")
      toml_.fail(table.get("best")->source(), "best is \"smaller\" or \"larger\"");
    row.direction = best == "smaller" ? Direction::smaller : Direction::larger;
    row.claim = toml_.string(table, "claim", false);
    row.conclusion = toml_.string(table, "conclusion", !row.claim.empty());
    row.pattern = toml_.string(table, "pattern", !row.claim.empty());
    row.note = toml_.string(table, "note", false);
    if (table.contains("paper")) {
      try {
        row.paper = parse_exact(toml_.string(table, "paper", true));
      } catch (const ExactTextError& error) {
        toml_.fail(table.get("paper")->source(), error.what());
      }
    }
    if (const toml::node* inverse = table.get("inverse")) {
      const auto value = inverse->value_exact<bool>();
      if (!value) toml_.fail(inverse->source(), "the key inverse expects true or false");
      row.is_inverse_in_steps = *value;
    }
    if (const toml::node* steps = table.get("steps")) row.steps = step_names(*steps);
    if (row.claim.empty() && row.steps.empty())
      toml_.fail(table.source(), "a constant is that of a claim or of a step");
    return row;
  }

  std::vector<std::string> step_names(const toml::node& node) const {
    if (!node.is_array()) toml_.fail(node.source(), "the key steps expects a list of \"claim/step/constant\"");
    std::vector<std::string> result;
    for (const toml::node& each : *node.as_array()) {
      const auto name = each.value_exact<std::string>();
      if (!name || std::count(name->begin(), name->end(), '/') != 2)
        toml_.fail(each.source(), "a constant of a step is \"claim/step/constant\"");
      result.push_back(*name);
    }
    return result;
  }

  TomlReader toml_;
  toml::table table_;
};

}  // namespace

ConstantRows parse_constant_rows(const std::string& text, const std::string& file) {
  return RowReader(text, file).read();
}

const ConstantRows& builtin_constant_rows() {
  static const ConstantRows rows = [] {
    for (const BuiltinTable& table : builtin_tables())
      if (table.name == "constants") return parse_constant_rows(table.text, "proofs/tables/constants.toml");
    throw std::logic_error("the library has no table of constants");
  }();
  return rows;
}

}  // namespace delcert
