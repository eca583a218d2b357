#include "proofs/formula/claim.hpp"

#include <algorithm>
#include <fstream>

#include "kernel/formula/formula_error.hpp"
#include "kernel/formula/token.hpp"
#include "proofs/formula/abbreviation_reader.hpp"
#include "proofs/formula/formula_reader.hpp"
#include "proofs/formula/step_reader.hpp"
#include "proofs/formula/substitution.hpp"
#include "proofs/formula/type_check.hpp"
#include "support/error.hpp"

namespace delcert {

namespace {

constexpr std::size_t largest_claim_file = std::size_t{1} << 20U;

class ClaimReader : FormulaReader {
 public:
  ClaimReader(const std::string& text, std::string file, const Vocabulary& vocabulary, const Signatures& signatures)
      : FormulaReader(text, std::move(file)), vocabulary_(vocabulary), signatures_(signatures) {}

  Claim read() {
    const toml::table table = parse();
    refuse_unknown(table, {"name", "title", "source", "status", "instance", "note", "points", "forall", "let", "given",
                           "show", "step"});
    Claim claim;
    claim.file = file();
    claim.name = string(table, "name", true);
    require_name(*table.get("name"), claim.name);
    claim.title = string(table, "title", false);
    claim.source = string(table, "source", false);
    claim.note = string(table, "note", false);
    claim.status = status(table);
    if (table.contains("step") && !table.contains("show")) {
      for (const char* key : {"instance", "points", "forall", "let", "given"}) {
        if (const toml::node* node = table.get(key))
          fail(node->source(), "a file of steps only has no key " + std::string(key));
      }
    } else {
      read_instance(table, claim);
      read_parameters(table, claim);
      read_points(table, claim);
      read_abbreviations(table, claim);
      read_hypotheses(table, claim);
      read_conclusions(table, claim);
    }
    claim.steps = read_steps(*this, table, claim.status, vocabulary_);
    return claim;
  }

 private:
  void read_instance(const toml::table& table, Claim& claim) {
    claim.instance = string(table, "instance", true);
    const auto found = signatures_.find(claim.instance);
    if (found == signatures_.end()) {
      std::vector<std::string> known;
      for (const auto& [name, signature] : signatures_) known.push_back(name);
      fail(table.get("instance")->source(),
           "no instance class is called " + shortened(claim.instance) + suggestion(claim.instance, known));
    }
    signature_ = found->second;
  }

  ClaimStatus status(const toml::table& table) const {
    const toml::node* node = table.get("status");
    if (node == nullptr) return ClaimStatus::user;
    const std::string text = string(table, "status", true);
    for (const ClaimStatus candidate : claim_statuses) {
      if (text != name_of(candidate)) continue;
      if (candidate != ClaimStatus::user && !table.contains("source")) {
        fail(node->source(), "a claim of the paper says where it stands there: the key source is missing");
      }
      return candidate;
    }
    fail(node->source(), "a status is \"paper\", \"mended\", \"sharper\" or \"user\", not \"" + shortened(text) + "\"");
  }

  void read_parameters(const toml::table& table, Claim& claim) {
    const toml::node* node = table.get("forall");
    if (node == nullptr) return;
    if (!node->is_table()) fail(node->source(), "the key forall expects a table such as { eta = \"(0, 1]\" }");
    for (const auto& [key, value] : *node->as_table()) {
      const std::string name(key.str());
      require_free(key.source(), name, "a parameter");
      if (signature_.contains(name)) fail(key.source(), "the class " + claim.instance + " binds " + name + " already");
      claim.parameters[name] = in_string(value, "a parameter expects a string such as \"(0, 1]\"",
                                         [](const std::string& text) { return parse_range(text); });
    }
    for (const auto& [name, range] : claim.parameters) signature_[name] = types::number;
  }

  void require_free(const toml::source_region& where, const std::string& name, const std::string& what) const {
    if (is_name_of_formula(name) && vocabulary_.function(name) == nullptr && vocabulary_.definition(name) == nullptr) {
      return;
    }
    fail(where, shortened(name) + " is no name for " + what + ": letters, digits and '_', and no function");
  }

  void read_points(const toml::table& table, Claim& claim) {
    const toml::node* node = table.get("points");
    if (node == nullptr) return;
    if (claim.instance != point_set_name) {
      fail(node->source(), "the key points is for claims about the class " + std::string(point_set_name));
    }
    claim.points = read_point_rules(*this, *node);
    for (const std::string& text : box_formulas(*claim.points)) {
      try {
        add_constraint(claim, {"", text, type_checked(parse_formula(text), vocabulary_, signature_, types::truth)});
      } catch (const FormulaError& error) {
        fail(node->source(), "the box as a formula, " + text + ": " + error.what());
      }
    }
    const toml::array* constraints = list(*node->as_table(), "constraints");
    if (constraints == nullptr) return;
    for (const toml::node& constraint : *constraints) {
      Statement here = formula(constraint, "", vocabulary_, signature_, types::truth);
      claim.points->constraints.push_back(here.text);
      add_constraint(claim, std::move(here));
    }
  }

  static void add_constraint(Claim& claim, Statement statement) {
    Hypothesis hypothesis;
    static_cast<Statement&>(hypothesis) = std::move(statement);
    hypothesis.name = "constraint-" + std::to_string(claim.hypotheses.size() + 1);
    hypothesis.no_twin = "what the points are";
    hypothesis.is_constraint = true;
    claim.hypotheses.push_back(std::move(hypothesis));
  }

  void read_abbreviations(const toml::table& table, Claim& claim) {
    const AbbreviationRules rules{[this](const toml::source_region& where, const std::string& name) {
                                    require_free(where, name, "an abbreviation");
                                    if (signature_.contains(name)) fail(where, name + " is already something else");
                                  },
                                  [this](const toml::node& node, const std::string& name) {
                                    Statement term = formula(node, name, vocabulary_, signature_);
                                    term.formula = replaced(term.formula, abbreviations_);
                                    return term;
                                  },
                                  [this](const Statement& term) {
                                    signature_[term.name] = term.formula->type;
                                    abbreviations_[term.name] = term.formula;
                                  }};
    claim.abbreviations = delcert::read_abbreviations(*this, table, rules);
  }

  /// With what the abbreviations stand for in their place.
  Statement statement(const toml::node& node, const std::string& name) const {
    Statement result = formula(node, name, vocabulary_, signature_, types::truth);
    result.formula = replaced(result.formula, abbreviations_);
    return result;
  }

  void require_new(const toml::node& part, const std::vector<std::string>& taken, const std::string& name) const {
    if (std::find(taken.begin(), taken.end(), name) != taken.end()) {
      fail(part.source(), "two parts of the claim are called " + name);
    }
  }

  std::string part_name(const toml::table& part, const std::vector<std::string>& taken,
                        const std::string& usual_name) const {
    std::string name = string(part, "name", false);
    if (name.empty()) name = usual_name;
    if (const toml::node* node = part.get("name")) require_name(*node, name);
    require_new(part, taken, name);
    return name;
  }

  void read_hypotheses(const toml::table& table, Claim& claim) const {
    const toml::array* given = list(table, "given");
    if (given == nullptr) return;
    std::vector<std::string> taken;
    for (const Hypothesis& constraint : claim.hypotheses) taken.push_back(constraint.name);
    const std::size_t constraints = taken.size();
    for (const toml::node& node : *given) {
      const std::string usual_name = "hypothesis-" + std::to_string(taken.size() - constraints + 1);
      Hypothesis hypothesis;
      if (const toml::table* part = node.as_table()) {
        refuse_unknown(*part, {"name", "claim", "no_twin"});
        const std::string name = part_name(*part, taken, usual_name);
        static_cast<Statement&>(hypothesis) = statement(required(*part, "claim"), name);
        hypothesis.no_twin = reason(*part);
      } else {
        static_cast<Statement&>(hypothesis) = statement(node, usual_name);
        require_new(node, taken, hypothesis.name);
      }
      taken.push_back(hypothesis.name);
      claim.hypotheses.push_back(std::move(hypothesis));
    }
  }

  void read_conclusions(const toml::table& table, Claim& claim) const {
    const toml::array* show = list(table, "show");
    if (show == nullptr || show->empty()) fail(table.source(), "a claim shows something: [[show]] is missing");
    std::vector<std::string> taken;
    for (const toml::node& node : *show) {
      const toml::table* part = node.as_table();
      if (part == nullptr) fail(node.source(), "the key show expects tables, [[show]]");
      refuse_unknown(*part, {"name", "claim", "base", "twin", "no_twin"});
      const std::string name = part_name(*part, taken, "conclusion-" + std::to_string(taken.size() + 1));
      Conclusion conclusion;
      static_cast<Statement&>(conclusion) = statement(required(*part, "claim"), name);
      if (const toml::node* twin = part->get("twin")) conclusion.twin = statement(*twin, name + "-twin");
      if (const toml::node* base = part->get("base")) {
        conclusion.base = formula(*base, name + "-base", vocabulary_, signature_, types::number);
      }
      conclusion.no_twin = reason(*part);
      if (conclusion.twin && !conclusion.no_twin.empty()) {
        fail(part->get("no_twin")->source(), "a conclusion has a twin or a reason why not, not both");
      }
      taken.push_back(name);
      claim.conclusions.push_back(std::move(conclusion));
    }
  }

  /// Why there is no twin; empty if the key is missing.
  std::string reason(const toml::table& part) const {
    return part.contains("no_twin") ? string(part, "no_twin", true) : "";
  }

  const Vocabulary& vocabulary_;
  const Signatures& signatures_;
  Signature signature_;
  Replacements abbreviations_;
};

}  // namespace

Claim parse_claim(const std::string& text, const std::string& file, const Vocabulary& vocabulary,
                  const Signatures& signatures) {
  return ClaimReader(text, file, vocabulary, signatures).read();
}

Claim read_claim(const std::string& file, const Vocabulary& vocabulary, const Signatures& signatures) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream) throw InputError(file + ": cannot be read");
  std::string text;
  for (char c = 0; text.size() <= largest_claim_file && stream.get(c);) text += c;
  if (stream.bad()) throw InputError(file + ": cannot be read");
  if (text.size() > largest_claim_file) throw InputError(file + ": larger than 1 MiB");
  return parse_claim(text, file, vocabulary, signatures);
}

}  // namespace delcert
