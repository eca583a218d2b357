#include "proofs/formula/step_reader.hpp"

#include <algorithm>

#include "kernel/formula/parser.hpp"
#include "kernel/formula/token.hpp"
#include "proofs/formula/abbreviation_reader.hpp"
#include "proofs/formula/type_check.hpp"

namespace delcert {

namespace {

/// "612", "612-614", "612, 640-641": numbers that grow.
bool is_list_of_lines(std::string_view text) {
  long last = 0;
  std::size_t at = 0;
  const auto number = [&]() -> bool {
    const std::size_t begin = at;
    long value = 0;
    while (at < text.size() && at - begin < 6 && text[at] >= '0' && text[at] <= '9')
      value = 10 * value + (text[at++] - '0');
    const bool grows = at > begin && text[begin] != '0' && value > last;
    last = value;
    return grows;
  };
  while (true) {
    if (!number()) return false;
    if (at < text.size() && text[at] == '-') {
      ++at;
      if (!number()) return false;
    }
    if (at == text.size()) return true;
    if (text.substr(at, 2) != ", ") return false;
    at += 2;
  }
}

class StepReader {
 public:
  StepReader(const FormulaReader& reader, const toml::table& table, const Vocabulary& vocabulary)
      : reader_(reader), table_(table), vocabulary_(vocabulary) {}

  Step read(ClaimStatus status_of_file) {
    reader_.refuse_unknown(table_, {"name", "lines", "status", "note", "forall", "let", "given", "constants", "claim"});
    step_.name = reader_.string(table_, "name", true);
    reader_.require_name(*table_.get("name"), step_.name);
    step_.status = status(status_of_file);
    step_.note = reader_.string(table_, "note", false);
    read_lines();
    read_parameters();
    read_constants();
    read_abbreviations();
    read_hypotheses();
    step_.claim = formula(reader_.required(table_, "claim"), "claim", types::truth);
    return std::move(step_);
  }

 private:
  ClaimStatus status(ClaimStatus status_of_file) const {
    const toml::node* node = table_.get("status");
    if (node == nullptr) return status_of_file;
    const std::string text = reader_.string(table_, "status", true);
    for (const ClaimStatus candidate : claim_statuses) {
      if (text == name_of(candidate)) return candidate;
    }
    reader_.fail(node->source(),
                 "a status is \"paper\", \"mended\", \"sharper\" or \"user\", not \"" + shortened(text) + "\"");
  }

  void read_lines() {
    const toml::node* node = table_.get("lines");
    if (node == nullptr) {
      if (step_.status == ClaimStatus::user || step_.status == ClaimStatus::sharper) return;
      reader_.fail(table_.source(), "a step of the paper says where it stands there: the key lines is missing");
    }
    step_.lines = reader_.string(table_, "lines", true);
    if (!is_list_of_lines(step_.lines)) {
      reader_.fail(node->source(), "lines of the paper's LaTeX are such as \"612\", \"612-614\" or \"612, 640-641\"");
    }
  }

  /// Whether a new name can be used in the formulas of the step.
  void require_free(const toml::source_region& where, const std::string& name) const {
    if (!is_name_of_formula(name) || vocabulary_.function(name) != nullptr || vocabulary_.definition(name) != nullptr) {
      reader_.fail(where, shortened(name) + " is no name here: letters, digits and '_', and no function");
    }
    if (signature_.contains(name)) reader_.fail(where, name + " is already something else");
  }

  const toml::table* table_of(const std::string& key, const std::string& example) const {
    const toml::node* node = table_.get(key);
    if (node == nullptr) return nullptr;
    if (!node->is_table()) reader_.fail(node->source(), "the key " + key + " expects a table such as " + example);
    return node->as_table();
  }

  void read_parameters() {
    const toml::table* all = table_of("forall", "{ eta = \"(0, 1]\", k = \"integer [1, infinity)\" }");
    if (all == nullptr) return;
    for (const auto& [key, value] : *all) {
      const std::string name(key.str());
      require_free(key.source(), name);
      const StepRange range = reader_.in_string(value, "a parameter expects a string such as \"(0, 1]\"",
                                                [](const std::string& text) { return parse_step_range(text); });
      step_.parameters[name] = range;
      signature_[name] = range.is_integer ? types::integer : types::number;
    }
  }

  void read_constants() {
    const toml::table* all = table_of("constants", "{ c = \"4/5\" }");
    if (all == nullptr) return;
    for (const auto& [key, value] : *all) {
      const std::string name(key.str());
      require_free(key.source(), name);
      step_.constants[name] =
          reader_.in_string(value, "a constant expects a string such as \"4/5\"", [](const std::string& text) {
            try {
              return parse_range("[" + text + ", " + text + "]").lower.value();
            } catch (const FormulaError& error) {
              throw FormulaError(error.offset() - 1, error.what());
            }
          });
      signature_[name] = types::number;
    }
  }

  Statement formula(const toml::node& node, const std::string& name, const Type& type) const {
    Statement result = reader_.formula(node, name, vocabulary_, signature_, type);
    require_no_quantifier(node, *result.formula);
    return result;
  }

  void require_no_quantifier(const toml::node& node, const Expression& expression) const {
    if (binds_variable(expression.operation)) {
      const std::string what = is_term_over_set(expression.operation)
                                   ? std::string(word_over_set(expression.operation)) + " over a set"
                                   : "quantifier";
      reader_.fail_in(node, FormulaError(expression.offset, "a " + what + " in a step, which speaks of numbers only"));
    }
    for (const auto& child : expression.children) require_no_quantifier(node, *child);
  }

  void read_abbreviations() {
    const AbbreviationRules rules{
        [this](const toml::source_region& where, const std::string& name) { require_free(where, name); },
        [this](const toml::node& node, const std::string& name) { return formula(node, name, types::number); },
        [this](const Statement& term) { signature_[term.name] = term.formula->type; }};
    step_.abbreviations = delcert::read_abbreviations(reader_, table_, rules);
  }

  void read_hypotheses() {
    const toml::array* given = reader_.list(table_, "given");
    if (given == nullptr) return;
    for (const toml::node& node : *given) {
      step_.hypotheses.push_back(
          formula(node, "hypothesis-" + std::to_string(step_.hypotheses.size() + 1), types::truth));
    }
  }

  const FormulaReader& reader_;
  const toml::table& table_;
  const Vocabulary& vocabulary_;
  Signature signature_;
  Step step_;
};

}  // namespace

std::vector<Step> read_steps(const FormulaReader& reader, const toml::table& claim, ClaimStatus status,
                             const Vocabulary& vocabulary) {
  std::vector<Step> steps;
  const toml::array* all = reader.list(claim, "step");
  if (all == nullptr) return steps;
  for (const toml::node& node : *all) {
    const toml::table* table = node.as_table();
    if (table == nullptr) reader.fail(node.source(), "the key step expects tables, [[step]]");
    Step step = StepReader(reader, *table, vocabulary).read(status);
    const bool taken = std::any_of(steps.begin(), steps.end(), [&](const Step& one) { return one.name == step.name; });
    if (taken) reader.fail(table->get("name")->source(), "two steps of the claim are called " + step.name);
    steps.push_back(std::move(step));
  }
  return steps;
}

}  // namespace delcert
