#include "proofs/formula/step_reader.hpp"

#include <algorithm>

#include "kernel/formula/parser.hpp"
#include "kernel/formula/token.hpp"
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
              return parse_range("[" + text + ", " + text + "]").lower;
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
    if (expression.operation == Operation::for_all || expression.operation == Operation::exists) {
      reader_.fail_in(node, FormulaError(expression.offset, "a quantifier in a step, which speaks of numbers only"));
    }
    for (const auto& child : expression.children) require_no_quantifier(node, *child);
  }

  struct Abbreviation {
    const toml::node* node;
    std::string name;
    std::vector<std::string> needs;
  };

  void add_abbreviation(std::vector<Abbreviation>& all, const toml::source_region& where, const std::string& name,
                        const toml::node& node) const {
    require_free(where, name);
    const bool taken = std::any_of(all.begin(), all.end(), [&](const Abbreviation& one) { return one.name == name; });
    if (taken) reader_.fail(where, name + " is already something else");
    all.push_back({&node, name, reader_.in_string(node, "a formula expects a string", [](const std::string& text) {
                     return free_names(*parse_formula(text));
                   })});
  }

  void read_abbreviations() {
    const toml::node* node = table_.get("let");
    if (node == nullptr) return;
    std::vector<Abbreviation> waiting;
    if (const toml::table* all = node->as_table()) {
      for (const auto& [key, value] : *all) add_abbreviation(waiting, key.source(), std::string(key.str()), value);
    } else if (const toml::array* all_in_order = node->as_array()) {
      for (const toml::node& part : *all_in_order) {
        const toml::table* entry = part.as_table();
        if (entry == nullptr) reader_.fail(part.source(), "an abbreviation expects a table { name = …, is = … }");
        reader_.refuse_unknown(*entry, {"name", "is"});
        const std::string name = reader_.string(*entry, "name", true);
        add_abbreviation(waiting, entry->get("name")->source(), name, reader_.required(*entry, "is"));
      }
    } else {
      reader_.fail(node->source(), "the key let expects a table such as { ratio = \"1/(1 + xi)\" }");
    }
    while (!waiting.empty()) {
      const auto is_waiting = [&](const std::string& name) {
        return std::any_of(waiting.begin(), waiting.end(), [&](const Abbreviation& one) { return one.name == name; });
      };
      auto next = std::find_if(waiting.begin(), waiting.end(), [&](const Abbreviation& one) {
        return std::none_of(one.needs.begin(), one.needs.end(), is_waiting);
      });
      if (next == waiting.end()) reader_.fail(waiting[0].node->source(), waiting[0].name + " is made of itself");
      Statement term = formula(*next->node, next->name, types::number);
      signature_[next->name] = term.formula->type;
      step_.abbreviations.push_back(std::move(term));
      waiting.erase(next);
    }
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
