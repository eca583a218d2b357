#include "proofs/publication/ledger_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "kernel/number/decimal_bounds.hpp"
#include "kernel/number/exact_text.hpp"
#include "proofs/constants/ledger_entries.hpp"
#include "proofs/publication/exact_latex.hpp"
#include "proofs/publication/latex_table.hpp"
#include "support/text_table.hpp"

namespace delcert {

namespace {

constexpr int digits_of_ledger = 6;
constexpr int digits_of_estimates = 3;

std::vector<LedgerEntry> selected_entries(const Ledger& ledger, const ConstantNames& only) {
  std::vector<LedgerEntry> entries = ledger_entries(ledger);
  if (!only.empty())
    std::erase_if(entries, [&](const auto& e) { return std::find(only.begin(), only.end(), e.name) == only.end(); });
  return entries;
}

std::string hypotheses_text(const Ledger& ledger) {
  return ledger.constraints == ParameterConstraints::sharper ? "The sharper Hypotheses 2 (docs/sharper-lemmas.md)"
                                                             : "Hypotheses 2 (hyps:param.bnds)";
}

std::string parameters_sentence(const Ledger& ledger) {
  return hypotheses_text(ledger) +
         (satisfies_parameter_constraints(ledger)
              ? " hold for these parameters."
              : " do not hold: the distortion " + exact_text(ledger.distortion) + " is above its bound.");
}

/// One number where both bounds print alike, an interval otherwise.
std::string enclosure_text(const Bounds& bounds) {
  const std::string lower = decimal_lower(bounds.lower, digits_of_ledger);
  const std::string upper = decimal_upper(bounds.upper, digits_of_ledger);
  return lower == upper ? lower : "[" + lower + ", " + upper + "]";
}

std::string value_text(const LedgerEntry& entry) {
  return entry.is_estimate ? "about " + decimal_lower(entry.value.lower, digits_of_estimates)
                           : enclosure_text(entry.value);
}

std::string log2_text(const LedgerEntry& entry) { return entry.log2 ? enclosure_text(*entry.log2) : ""; }

std::string value_latex(const LedgerEntry& entry) {
  if (entry.is_estimate) return decimal_latex(decimal_lower(entry.value.lower, digits_of_estimates));
  const std::string lower = decimal_lower(entry.value.lower, digits_of_ledger);
  const std::string upper = decimal_upper(entry.value.upper, digits_of_ledger);
  if (lower == upper) return decimal_latex(lower);
  return "[" + decimal_latex(lower) + ", \\allowbreak " + decimal_latex(upper) + "]";
}

std::string exact_latex(const LedgerEntry& entry) {
  return entry.exact_latex.empty() ? "" : "$" + entry.exact_latex + "$";
}

std::string with_spaces(std::string name) {
  std::replace(name.begin(), name.end(), '_', ' ');
  return name;
}

nlohmann::ordered_json ledger_object(const Ledger& ledger, const ConstantNames& only) {
  nlohmann::ordered_json constants = nlohmann::ordered_json::object();
  for (const LedgerEntry& entry : selected_entries(ledger, only)) {
    nlohmann::ordered_json& object = constants[entry.name];
    object["symbol"] = entry.symbol;
    if (!entry.exact.empty()) object["exact"] = entry.exact;
    if (entry.is_estimate) {
      object["estimate"] = decimal_lower(entry.value.lower, digits_of_estimates);
    } else {
      object["lower"] = decimal_lower(entry.value.lower, digits_of_ledger);
      object["upper"] = decimal_upper(entry.value.upper, digits_of_ledger);
    }
    if (entry.log2) {
      object["log2_lower"] = decimal_lower(entry.log2->lower, digits_of_ledger);
      object["log2_upper"] = decimal_upper(entry.log2->upper, digits_of_ledger);
    }
    object["source"] = entry.source;
  }
  nlohmann::ordered_json document;
  document["parameters"] = {{"dimension", ledger.dimension.value},
                            {"separation", exact_text(ledger.separation)},
                            {"perturbation", exact_text(ledger.perturbation)},
                            {"radius_variation", exact_text(ledger.radius_variation)},
                            {"distortion", exact_text(ledger.distortion)}};
  if (ledger.constraints == ParameterConstraints::sharper) document["parameters"]["hypotheses"] = "sharper";
  document["constants"] = std::move(constants);
  document["hypotheses_2"] = satisfies_parameter_constraints(ledger);
  return document;
}

/// A constant of one ledger of a sweep.
struct SweptEntry {
  const Ledger* ledger;
  LedgerEntry entry;
};

/// The constants of all ledgers, one block after the other; what is an input makes no block.
std::vector<std::vector<SweptEntry>> blocks_of(const SweptLedgers& swept, const ConstantNames& only) {
  const ConstantNames names = all_constant_names();
  std::vector<std::vector<SweptEntry>> blocks(names.size());
  for (const Ledger& ledger : swept.ledgers) {
    for (LedgerEntry& entry : selected_entries(ledger, only)) {
      if (entry.source == "input") continue;
      const auto block = std::find(names.begin(), names.end(), entry.name) - names.begin();
      blocks[static_cast<std::size_t>(block)].push_back({&ledger, std::move(entry)});
    }
  }
  std::erase_if(blocks, [](const auto& block) { return block.empty(); });
  return blocks;
}

std::string text_of(const LeftOut& left_out) {
  return fmt::format("left out: m = {}, μ₀ = {}, ρ₀ = {}: {}", left_out.dimension.value,
                     exact_text(left_out.separation), exact_text(left_out.perturbation), left_out.reason);
}

/// The ledgers whose distortion is above its bound, and what was left out: one line each.
std::vector<std::string> remarks_on(const SweptLedgers& swept) {
  std::vector<std::string> remarks;
  for (const Ledger& ledger : swept.ledgers) {
    if (satisfies_parameter_constraints(ledger)) continue;
    remarks.push_back(fmt::format("m = {}, μ₀ = {}, ρ₀ = {}: {}", ledger.dimension.value, exact_text(ledger.separation),
                                  exact_text(ledger.perturbation), parameters_sentence(ledger)));
  }
  if (remarks.empty()) remarks.push_back(hypotheses_text(swept.ledgers.front()) + " hold for all of these parameters.");
  for (const LeftOut& left_out : swept.left_out) remarks.push_back(text_of(left_out));
  return remarks;
}

}  // namespace

ConstantNames all_constant_names() {
  // In dimension 2 there is everything, and the sharper hypotheses have all constants of the printed ones.
  const Ledger ledger = constants_for(Dimension{2}, Rational(1), Rational(1) / Rational(4), Rational(0), Rational(0),
                                      ParameterConstraints::sharper);
  ConstantNames names;
  for (const LedgerEntry& entry : ledger_entries(ledger)) names.push_back(entry.name);
  return names;
}

std::string ledger_table(const Ledger& ledger, const ConstantNames& only) {
  std::vector<std::vector<std::string>> rows{{"", "constant", "exact", "value", "log2", "source"}};
  for (const LedgerEntry& entry : selected_entries(ledger, only))
    rows.push_back(
        {entry.symbol, with_spaces(entry.name), entry.exact, value_text(entry), log2_text(entry), entry.source});
  return text_table(rows) + "\n" + parameters_sentence(ledger) + "\n";
}

std::string ledger_json(const Ledger& ledger, const ConstantNames& only) {
  return ledger_object(ledger, only).dump(2) + "\n";
}

std::string ledger_latex(const Ledger& ledger, const ConstantNames& only) {
  std::vector<std::vector<std::string>> rows;
  for (const LedgerEntry& entry : selected_entries(ledger, only))
    rows.push_back({fmt::format("${}$", entry.latex_symbol), with_spaces(entry.name), exact_latex(entry),
                    fmt::format("${}$", value_latex(entry)), latex_label(entry.source)});
  return latex_table({{"", 66}, {"constant", 58}, {"exact", 74}, {"value", 64}, {"source", 59}}, rows) + "% " +
         parameters_sentence(ledger) + "\n";
}

std::string sweep_table(const SweptLedgers& swept, const ConstantNames& only) {
  std::string text;
  for (const auto& block : blocks_of(swept, only)) {
    const LedgerEntry& first = block.front().entry;
    text += fmt::format("{}  {}  ({})\n", first.symbol, with_spaces(first.name), first.source);
    std::vector<std::vector<std::string>> rows{{"  m", "μ₀", "ρ₀", "exact", "value", "log2"}};
    for (const auto& [ledger, entry] : block)
      rows.push_back({"  " + std::to_string(ledger->dimension.value), exact_text(ledger->separation),
                      exact_text(ledger->perturbation), entry.exact, value_text(entry), log2_text(entry)});
    text += text_table(rows) + "\n";
  }
  for (const std::string& remark : remarks_on(swept)) text += remark + "\n";
  return text;
}

std::string sweep_json(const SweptLedgers& swept, const ConstantNames& only) {
  nlohmann::ordered_json document{{"ledgers", nlohmann::ordered_json::array()},
                                  {"left_out", nlohmann::ordered_json::array()}};
  for (const Ledger& ledger : swept.ledgers) document["ledgers"].push_back(ledger_object(ledger, only));
  for (const LeftOut& left_out : swept.left_out)
    document["left_out"].push_back({{"dimension", left_out.dimension.value},
                                    {"separation", exact_text(left_out.separation)},
                                    {"perturbation", exact_text(left_out.perturbation)},
                                    {"reason", left_out.reason}});
  return document.dump(2) + "\n";
}

std::string sweep_latex(const SweptLedgers& swept, const ConstantNames& only) {
  std::vector<std::vector<std::string>> rows;
  for (const auto& block : blocks_of(swept, only)) {
    const LedgerEntry& first = block.front().entry;
    rows.push_back(
        {fmt::format("${}$ {} ({})", first.latex_symbol, with_spaces(first.name), latex_label(first.source))});
    for (const auto& [ledger, entry] : block) {
      rows.push_back({std::to_string(ledger->dimension.value), "$" + exact_latex(ledger->separation) + "$",
                      "$" + exact_latex(ledger->perturbation) + "$", exact_latex(entry),
                      fmt::format("${}$", value_latex(entry))});
    }
  }
  std::string text =
      latex_table({{"$m$", 14}, {"$\\mu_0$", 50}, {"$\\rho_0$", 50}, {"exact", 110}, {"value", 97}}, rows);
  for (const std::string& remark : remarks_on(swept)) text += "% " + remark + "\n";
  return text;
}

}  // namespace delcert
