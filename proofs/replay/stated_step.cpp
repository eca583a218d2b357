#include "proofs/replay/stated_step.hpp"

#include <toml++/toml.h>

#include <algorithm>
#include <set>

#include "proofs/replay/builtin_steps.hpp"
#include "proofs/replay/digest.hpp"
#include "proofs/replay/formula.hpp"

namespace delcert::replay {

namespace {

std::string without_blanks(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (c != ' ' && c != '\t' && c != '\n' && c != '\r') result += c;
  }
  return result;
}

const std::string& string_of(const toml::node* node, const std::string& what) {
  if (node == nullptr || !node->is_string()) throw Malformed(what + " is no string");
  return node->as_string()->get();
}

/// Of the key of a table that may be left out; it is refused if it is something else than a table.
const toml::table* table_at(const toml::table& table, std::string_view key) {
  const toml::node* node = table.get(key);
  if (node == nullptr) return nullptr;
  if (!node->is_table()) throw Malformed("the key " + std::string(key) + " is no table");
  return node->as_table();
}

/// Abbreviations may be made of one another, in any order.
class Abbreviations {
 public:
  explicit Abbreviations(Meanings constants) : meanings_(std::move(constants)) {}

  void add(const std::string& name, NodePointer formula) {
    if (!waiting_.emplace(name, std::move(formula)).second) throw Malformed("two abbreviations " + name);
  }

  Meanings resolved() {
    while (!waiting_.empty()) resolve(waiting_.begin()->first);
    return meanings_;
  }

 private:
  void resolve(const std::string& name) {
    if (!open_.insert(name).second) throw Malformed(name + " is made of itself");
    const NodePointer formula = waiting_.at(name);
    for (const std::string& other : names_in(*formula)) {
      if (waiting_.contains(other)) resolve(other);
    }
    meanings_[name] = with_meanings(formula, meanings_);
    waiting_.erase(name);
    open_.erase(name);
  }

  static std::set<std::string> names_in(const Node& formula) {
    if (formula.is_name()) return {formula.head};
    std::set<std::string> result;
    for (const NodePointer& part : formula.parts) result.merge(names_in(*part));
    return result;
  }

  Meanings meanings_;
  std::map<std::string, NodePointer> waiting_;
  std::set<std::string> open_;
};

Meanings meanings_of(const toml::table& table) {
  Meanings constants;
  if (const toml::table* all = table_at(table, "constants")) {
    for (const auto& [key, value] : *all) {
      const std::string name(key.str());
      constants[name] = formula_of(Number::read(without_blanks(string_of(&value, "the constant " + name))));
    }
  }
  Abbreviations abbreviations(std::move(constants));
  const toml::node* let = table.get("let");
  if (let == nullptr) return abbreviations.resolved();
  if (let->is_table()) {
    for (const auto& [key, value] : *let->as_table()) {
      abbreviations.add(std::string(key.str()), read_formula(string_of(&value, "an abbreviation")));
    }
  } else if (let->is_array()) {
    for (const toml::node& entry : *let->as_array()) {
      if (!entry.is_table()) throw Malformed("an abbreviation is no table");
      abbreviations.add(string_of(entry.as_table()->get("name"), "the name of an abbreviation"),
                        read_formula(string_of(entry.as_table()->get("is"), "an abbreviation")));
    }
  } else {
    throw Malformed("the key let is no table");
  }
  return abbreviations.resolved();
}

StatedStep read_step(const toml::table& table) {
  StatedStep step;
  if (const toml::table* all = table_at(table, "forall")) {
    for (const auto& [key, value] : *all) {
      const std::string name(key.str());
      step.parameters[name] = read_range(string_of(&value, "the range of " + name));
    }
  }
  const Meanings meanings = meanings_of(table);
  const auto expression = [&](const toml::node* node, const std::string& what) {
    return text_of(*with_meanings(read_formula(string_of(node, what)), meanings));
  };
  if (const toml::node* given = table.get("given")) {
    if (!given->is_array()) throw Malformed("the key given is no list");
    for (const toml::node& hypothesis : *given->as_array()) {
      step.hypotheses.push_back(expression(&hypothesis, "a hypothesis"));
    }
  }
  step.statement = expression(table.get("claim"), "the claim of a step");
  step.line = table.source().begin.line;
  return step;
}

}  // namespace

StatedRange read_range(const std::string& given) {
  std::string text = given;
  StatedRange range;
  const std::size_t bracket = text.find_first_of("([");
  if (bracket == std::string::npos) throw Malformed("no range: " + given);
  const std::string kind = without_blanks(text.substr(0, bracket));
  if (!kind.empty() && kind != "integer") throw Malformed("no range: " + given);
  range.is_integer = kind == "integer";
  text = without_blanks(text.substr(bracket));
  const std::size_t comma = text.find(',');
  const char last = text.back();
  if (comma == std::string::npos || (last != ')' && last != ']')) throw Malformed("no range: " + given);
  const std::string lower = text.substr(1, comma - 1);
  const std::string upper = text.substr(comma + 1, text.size() - comma - 2);
  if (lower != "-infinity") range.lower = Number::read(lower);
  if (upper != "infinity") range.upper = Number::read(upper);
  range.has_lower = text[0] == '[';
  range.has_upper = last == ']';
  if ((!range.lower && range.has_lower) || (!range.upper && range.has_upper)) throw Malformed("no range: " + given);
  return range;
}

std::string text_of(const StatedRange& range) {
  return std::string(range.is_integer ? "integer " : "") + (range.has_lower ? "[" : "(") +
         (range.lower ? range.lower->text() : "-infinity") + ", " + (range.upper ? range.upper->text() : "infinity") +
         (range.has_upper ? "]" : ")");
}

void add_claim(StatedClaims& claims, std::string_view text, const std::string& source) {
  try {
    const toml::table table = toml::parse(text);
    StatedClaim claim{source, sha256_of(text), {}};
    if (const toml::node* steps = table.get("step")) {
      if (!steps->is_array()) throw Malformed("the key step is no list of tables");
      for (const toml::node& node : *steps->as_array()) {
        if (!node.is_table()) throw Malformed("a step is no table");
        const std::string& name = string_of(node.as_table()->get("name"), "the name of a step");
        try {
          if (!claim.steps.emplace(name, read_step(*node.as_table())).second) throw Malformed("it is there twice");
        } catch (const Malformed& malformed) {
          throw Malformed("step " + name + ": " + malformed.what());
        }
      }
    }
    claims[string_of(table.get("name"), "the name of the claim")] = std::move(claim);
  } catch (const toml::parse_error& error) {
    throw Malformed(source + ":" + std::to_string(error.source().begin.line) + ": " + std::string(error.description()));
  } catch (const Malformed& malformed) {
    throw Malformed(source + ": " + malformed.what());
  }
}

StatedClaims builtin_claims_as_stated() {
  StatedClaims result;
  for (const ReplayedClaimText& claim : builtin_texts_to_replay()) {
    add_claim(result, claim.text, "proofs/claims/" + claim.name + ".toml");
  }
  return result;
}

}  // namespace delcert::replay
