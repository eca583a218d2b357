#include "apps/ledger_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <vector>

#include "kernel/number/exact_text.hpp"
#include "proofs/constants/decimal_bounds.hpp"
#include "proofs/constants/ledger_entries.hpp"

namespace delcert {

namespace {

constexpr int digits = 6;
constexpr int digits_of_estimates = 3;

std::string parameters_sentence(const Ledger& ledger) {
  return satisfies_parameter_constraints(ledger) ? "Hypotheses 2 (hyps:param.bnds) hold for these parameters."
                                                 : "Hypotheses 2 (hyps:param.bnds) do not hold: the distortion " +
                                                       exact_text(ledger.distortion) + " is above its bound.";
}

/// One number where both bounds print alike, an interval otherwise.
std::string enclosure_text(const Bounds& bounds) {
  const std::string lower = decimal_lower(bounds.lower, digits);
  const std::string upper = decimal_upper(bounds.upper, digits);
  return lower == upper ? lower : "[" + lower + ", " + upper + "]";
}

std::string value_text(const LedgerEntry& entry) {
  return entry.is_estimate ? "about " + decimal_lower(entry.value.lower, digits_of_estimates)
                           : enclosure_text(entry.value);
}

std::string decimal_latex(const std::string& decimal) {
  const auto exponent = decimal.find('e');
  if (exponent == std::string::npos) return decimal;
  return decimal.substr(0, exponent) + " \\cdot 10^{" + decimal.substr(exponent + 1) + "}";
}

std::string value_latex(const LedgerEntry& entry) {
  if (entry.is_estimate) return decimal_latex(decimal_lower(entry.value.lower, digits_of_estimates));
  const std::string lower = decimal_lower(entry.value.lower, digits);
  const std::string upper = decimal_upper(entry.value.upper, digits);
  if (lower == upper) return decimal_latex(lower);
  return "[" + decimal_latex(lower) + ", " + decimal_latex(upper) + "]";
}

/// Columns that a text takes on a terminal: its code points without combining marks (as in ρ̃).
std::size_t width_of(const std::string& text) {
  std::size_t width = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto byte = static_cast<unsigned char>(text[i]);
    const bool continues = (byte & 0xC0U) == 0x80U;
    const auto next = i + 1 < text.size() ? static_cast<unsigned char>(text[i + 1]) : 0U;
    const bool combines = byte == 0xCCU || (byte == 0xCDU && next < 0xB0U);
    if (!continues && !combines) ++width;
  }
  return width;
}

using Row = std::array<std::string, 6>;

std::string layout(const std::vector<Row>& rows) {
  std::array<std::size_t, std::tuple_size_v<Row>> widths{};
  for (const Row& row : rows)
    for (std::size_t column = 0; column < row.size(); ++column)
      widths[column] = std::max(widths[column], width_of(row[column]));
  std::string text;
  for (const Row& row : rows) {
    std::string line;
    for (std::size_t column = 0; column < row.size(); ++column)
      line += row[column] + std::string(widths[column] + 2 - width_of(row[column]), ' ');
    line.erase(line.find_last_not_of(' ') + 1);
    text += line + "\n";
  }
  return text;
}

std::string with_spaces(std::string name) {
  std::replace(name.begin(), name.end(), '_', ' ');
  return name;
}

}  // namespace

std::string ledger_table(const Ledger& ledger) {
  std::vector<Row> rows{{"", "constant", "exact", "value", "log2", "source"}};
  for (const LedgerEntry& entry : ledger_entries(ledger))
    rows.push_back({entry.symbol, with_spaces(entry.name), entry.exact, value_text(entry),
                    entry.log2 ? enclosure_text(*entry.log2) : "", entry.source});
  return layout(rows) + "\n" + parameters_sentence(ledger) + "\n";
}

std::string ledger_json(const Ledger& ledger) {
  nlohmann::ordered_json constants = nlohmann::ordered_json::object();
  for (const LedgerEntry& entry : ledger_entries(ledger)) {
    nlohmann::ordered_json& object = constants[entry.name];
    object["symbol"] = entry.symbol;
    if (!entry.exact.empty()) object["exact"] = entry.exact;
    if (entry.is_estimate) {
      object["estimate"] = decimal_lower(entry.value.lower, digits_of_estimates);
    } else {
      object["lower"] = decimal_lower(entry.value.lower, digits);
      object["upper"] = decimal_upper(entry.value.upper, digits);
    }
    if (entry.log2) {
      object["log2_lower"] = decimal_lower(entry.log2->lower, digits);
      object["log2_upper"] = decimal_upper(entry.log2->upper, digits);
    }
    object["source"] = entry.source;
  }
  nlohmann::ordered_json document;
  document["constants"] = std::move(constants);
  document["hypotheses_2"] = satisfies_parameter_constraints(ledger);
  return document.dump(2) + "\n";
}

std::string ledger_latex(const Ledger& ledger) {
  std::string text = "\\begin{tabular}{lllll}\n\\toprule\n & constant & exact & value & source \\\\\n\\midrule\n";
  for (const LedgerEntry& entry : ledger_entries(ledger)) {
    const std::string exact = entry.exact_latex.empty() ? "" : "$" + entry.exact_latex + "$";
    text += fmt::format("${}$ & {} & {} & ${}$ & {} \\\\\n", entry.latex_symbol, with_spaces(entry.name), exact,
                        value_latex(entry), entry.source);
  }
  return text + "\\bottomrule\n\\end{tabular}\n% " + parameters_sentence(ledger) + "\n";
}

}  // namespace delcert
