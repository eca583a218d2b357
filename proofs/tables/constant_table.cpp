#include "proofs/tables/constant_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "kernel/number/decimal_bounds.hpp"
#include "kernel/number/exact_text.hpp"
#include "proofs/formula/places.hpp"
#include "proofs/formula/substitution.hpp"
#include "proofs/publication/latex_table.hpp"
#include "proofs/tables/hole.hpp"
#include "support/error.hpp"
#include "support/latex_text.hpp"

namespace delcert {

namespace {

constexpr int digits = 5;

[[noreturn]] void fail(const ConstantRow& row, const std::string& message) {
  throw InputError("constant of " + row.label + ", " + row.statement + ": " + message);
}

template <class Parts>
const auto& part_named(const ConstantRow& row, const Parts& parts, const std::string& name) {
  const auto found = std::find_if(parts.begin(), parts.end(), [&](const auto& part) { return part.name == name; });
  if (found == parts.end()) fail(row, "there is no " + name);
  return *found;
}

Rational in_steps(const ConstantRow& row, const Rational& constant) {
  return row.is_inverse_in_steps ? Rational(1) / constant : constant;
}

/// A constant of a step as its file states it. The name is "claim/step/constant".
Rational stated_constant(const ConstantRow& row, const std::string& name, const std::vector<Claim>& claims) {
  const auto first = name.find('/');
  const auto second = name.find('/', first + 1);
  const Claim& claim = part_named(row, claims, name.substr(0, first));
  const Step& step = part_named(row, claim.steps, name.substr(first + 1, second - first - 1));
  const auto constant = step.constants.find(name.substr(second + 1));
  if (constant == step.constants.end()) fail(row, "there is no " + name);
  return constant->second;
}

/// What stands in the place of C in a formula.
std::optional<Rational> constant_of(const ConstantRow& row, const Statement& statement) {
  return constant_in(*parse_formula(statement.text), *parse_formula(row.pattern));
}

std::optional<Rational> provable_by(const ConstantRow& row, const std::vector<Claim>& claims,
                                    const StepSlacks& slacks) {
  std::optional<Rational> result;
  for (const std::string& name : row.steps) {
    const auto slack = slacks.find(name);
    if (slack == slacks.end()) return std::nullopt;
    if (slack->second.stated != stated_constant(row, name, claims))
      fail(row,
           "the slack of " + name + " is of another version of the step: it has " + exact_text(slack->second.stated));
    if (!slack->second.proved) return std::nullopt;
    const Rational proved = in_steps(row, *slack->second.proved);
    const bool is_weaker = result && (row.direction == Direction::smaller ? proved > *result : proved < *result);
    if (!result || is_weaker) result = proved;
  }
  return result;
}

/// Where C stands in the pattern, by the numbers of the children.
std::optional<std::vector<std::size_t>> path_of_hole(const Expression& pattern) {
  if (pattern.operation == Operation::name && pattern.text == "C") return std::vector<std::size_t>();
  for (std::size_t at = 0; at < pattern.children.size(); ++at) {
    if (auto path = path_of_hole(*pattern.children[at])) {
      path->insert(path->begin(), at);
      return path;
    }
  }
  return std::nullopt;
}

/// The power of the least place around the constant.
std::string power_of_row(const ConstantRow& row, const Statement& statement, const std::vector<PowerOfPlace>& powers) {
  const auto hole = path_of_hole(*parse_formula(row.pattern));
  if (!hole || powers.empty()) return "";
  const auto formula = statement.formula ? without_definitions(statement.formula) : parse_formula(statement.text);
  std::optional<Place> least;
  for (Place& place : places_in(*formula)) {
    if (place.kind == PlaceKind::factor || place.path.size() > hole->size()) continue;
    if (!std::equal(place.path.begin(), place.path.end(), hole->begin())) continue;
    if (!least || place.path.size() >= least->path.size()) least = std::move(place);
  }
  return least ? power_by_dimension(powers, row.claim, statement.name, least->text, name_of(least->kind)) : "";
}

ConstantEntry entry_of(const ConstantRow& row, const std::vector<Claim>& claims, const StepSlacks& slacks,
                       const WorstRatios& ratios, const std::vector<PowerOfPlace>& powers) {
  ConstantEntry entry;
  entry.row = row;
  std::optional<Rational> stated;
  if (!row.claim.empty()) {
    const Claim& claim = part_named(row, claims, row.claim);
    const auto conclusion = std::find_if(claim.conclusions.begin(), claim.conclusions.end(),
                                         [&](const auto& part) { return part.name == row.conclusion; });
    if (conclusion == claim.conclusions.end()) {
      const Hypothesis& hypothesis = part_named(row, claim.hypotheses, row.conclusion);
      stated = constant_of(row, hypothesis);
      entry.power = power_of_row(row, hypothesis, powers);
    } else {
      stated = constant_of(row, *conclusion);
      entry.power = power_of_row(row, *conclusion, powers);
      if (conclusion->twin) entry.refuted = constant_of(row, *conclusion->twin);
      if (entry.refuted) entry.witness = row.claim + "." + row.conclusion + "-twin.json";
    }
    if (!stated) fail(row, "the pattern does not fit " + row.claim + " / " + row.conclusion);
  }
  for (const std::string& name : row.steps) {
    const Rational constant = in_steps(row, stated_constant(row, name, claims));
    if (stated && !row.paper && *stated != constant)
      fail(row, "a step states " + exact_text(constant) + ", not " + exact_text(*stated));
    stated = constant;
  }
  entry.paper = row.paper.value_or(*stated);
  entry.provable = provable_by(row, claims, slacks);
  if (const auto found = ratios.find(row.claim + "/" + row.conclusion); found != ratios.end()) {
    entry.worst = found->second;
  }
  return entry;
}

/// A fraction where it is short, else a decimal number rounded downwards or upwards.
std::string number_text(const Rational& x, bool upwards) {
  if (x.denominator() == 1 || exact_text(x).size() <= 7) return exact_text(x);
  return upwards ? decimal_upper(x, digits) : decimal_lower(x, digits);
}

std::string paper_text(const ConstantEntry& entry) { return exact_text(entry.paper); }

/// Rounded to the safe side: a weaker constant is provable as well.
std::string provable_text(const ConstantEntry& entry) {
  return entry.provable ? number_text(*entry.provable, entry.row.direction == Direction::smaller) : "";
}

/// The best constant is beyond this one; rounded so that it remains true.
std::string refuted_text(const ConstantEntry& entry, const char* greater, const char* less) {
  if (!entry.refuted) return "";
  const bool smaller = entry.row.direction == Direction::smaller;
  return (smaller ? greater : less) + number_text(*entry.refuted, !smaller);
}

std::string worst_text(const ConstantEntry& entry) {
  std::string result;
  for (const auto& [dimension, worst] : entry.worst) {
    result += (result.empty() ? "" : ", ") + dimension + ": " +
              (worst.is_equality ? "1" : decimal_lower(worst.lower, digits));
  }
  return result;
}

/// In a cell of a table, where a bar would end it.
std::string in_table_cell(const std::string& text) {
  std::string result;
  for (const char c : text) result += c == '|' ? std::string("\\|") : std::string(1, c);
  return result;
}

std::string or_dash(const std::string& text) { return text.empty() ? "–" : text; }

}  // namespace

StepSlacks parse_step_slacks(const std::string& json, const std::string& file) {
  StepSlacks slacks;
  try {
    const auto document = nlohmann::json::parse(json);
    const auto& steps = document.is_object() ? document.at("steps") : document;
    if (!steps.is_array()) throw InputError(file + ": not what delcert prove --slack --json prints: no list of steps");
    for (const auto& step : steps) {
      if (!step.contains("slack")) continue;
      const std::string place = step.at("claim").get<std::string>() + "/" + step.at("step").get<std::string>() + "/";
      for (const auto& constant : step.at("slack")) {
        StepSlack slack{parse_exact(constant.at("stated").get<std::string>()), std::nullopt};
        if (!constant.at("proved").is_null()) slack.proved = parse_exact(constant.at("proved").get<std::string>());
        slacks[place + constant.at("constant").get<std::string>()] = slack;
      }
    }
  } catch (const nlohmann::json::exception& error) {
    throw InputError(file + ": not what delcert prove --slack --json prints: " + error.what());
  }
  return slacks;
}

std::vector<ConstantEntry> constant_entries(const ConstantRows& rows, const std::vector<Claim>& claims,
                                            const StepSlacks& slacks, const WorstRatios& ratios,
                                            const std::vector<PowerOfPlace>& powers) {
  std::vector<ConstantEntry> entries;
  for (const ConstantRow& row : rows.rows) entries.push_back(entry_of(row, claims, slacks, ratios, powers));
  return entries;
}

std::string constant_table_markdown(const std::vector<ConstantEntry>& entries,
                                    const std::vector<LemmaWithoutConstant>& without) {
  std::string text = R"(# The constants of the lemmas

For each constant of a lemma, c in the statement: what the paper has; the best value for which the same proof goes through,
as `delcert prove --slack` finds it, to 1/1000 (a dash where the constant stands in no step, or in one that is not proved);
and a value with which the statement is false, as an exact witness in `proofs/claims/witnesses` shows. The best constant
lies between these two. Where equality occurs, the latter is a value next to the paper's. The worst ratio is what
[searches](tightness.md) found for the statement with the constant of its claim: the smaller side to the larger one, or what they
exceed a declared base by, 1 where equality occurs, rounded downwards, for each dimension. The power is the scale nearest to 1 of
the term with the constant with which [a search](power.md) refuted the claim: a wrong constant nearer to the paper's than that
would not have been noticed. This page is what
`delcert tables --slack docs/tables/slack.json --ratios docs/tables/tightness.json --power docs/tables/power.json` prints; a test
compares them.

| lemma | statement | paper | provable by the same proof | shown necessary by a witness | worst ratio found | power | witness |
|---|---|--:|--:|--:|---|---|---|
)";
  std::string notes;
  for (const ConstantEntry& entry : entries) {
    text +=
        fmt::format("| {} | {} | {} | {} | {} | {} | {} | {} |\n", entry.row.label, in_table_cell(entry.row.statement),
                    paper_text(entry), or_dash(provable_text(entry)), or_dash(refuted_text(entry, "> ", "< ")),
                    or_dash(worst_text(entry)), or_dash(entry.power), or_dash(entry.witness));
    if (!entry.row.note.empty())
      notes += fmt::format("* {}, {}: {}\n", entry.row.label, entry.row.statement, entry.row.note);
  }
  if (!notes.empty()) text += "\n## Notes\n\n" + notes;
  text += "\n## Lemmas without a constant of their own\n\n| lemma | why |\n|---|---|\n";
  for (const LemmaWithoutConstant& each : without) text += fmt::format("| {} | {} |\n", each.label, each.reason);
  return text;
}

std::string constant_table_latex(const std::vector<ConstantEntry>& entries) {
  const auto math = [](const std::string& number) { return number.empty() ? "--" : "$" + number + "$"; };
  std::vector<std::vector<std::string>> rows;
  for (const ConstantEntry& entry : entries) {
    rows.push_back({latex_label(entry.row.label), "$" + entry.row.latex + "$", math(paper_text(entry)),
                    math(provable_text(entry)), math(refuted_text(entry, "> ", "< ")),
                    entry.worst.empty() ? "--" : latex_text(worst_text(entry))});
  }
  return latex_table(
      {{"lemma", 60}, {"statement", 104}, {"paper", 26}, {"provable", 34}, {"necessary", 46}, {"ratio", 44}}, rows);
}

}  // namespace delcert
