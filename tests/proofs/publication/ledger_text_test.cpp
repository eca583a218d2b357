#include "proofs/publication/ledger_text.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>

#include "kernel/number/exact_text.hpp"
#include "proofs/constants/ledger_entries.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

Ledger ledger_of(int dimension) { return constants_for(Dimension{dimension}, Rational(1), Rational(1) / Rational(4)); }

std::string line_with(const std::string& text, const std::string& part) {
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);)
    if (line.find(part) != std::string::npos) return line;
  return "no line with " + part;
}

std::string with_single_blanks(const std::string& line) {
  std::istringstream words(line);
  std::string result;
  for (std::string word; words >> word;) result += (result.empty() ? "" : " ") + word;
  return result;
}

/// How many blanks follow the symbol at the start of a line.
std::size_t blanks_after(const std::string& line, const std::string& symbol) {
  return line.find_first_not_of(' ', symbol.size()) - symbol.size();
}

TEST(LedgerText, aligns_letters_with_and_without_combining_marks) {
  const std::string table = ledger_table(ledger_of(2));
  const std::size_t blanks = blanks_after(line_with(table, "ρ₀  "), "ρ₀");
  EXPECT_GT(blanks, 1U);
  EXPECT_EQ(blanks_after(line_with(table, "perturbation tilde"), "ρ̃₀"), blanks);
  EXPECT_EQ(blanks_after(line_with(table, "riemannian flake divisor"), "C̃"), blanks + 1);
}

TEST(LedgerText, tabulates_every_constant) {
  const std::string table = ledger_table(ledger_of(2));
  EXPECT_EQ(with_single_blanks(line_with(table, "flake parameter  ")),
            "Γ₀ flake parameter 2^(-101/2) [6.28036e-16, 6.28037e-16] -50.5 lem:loc.eucl.protect");
  EXPECT_EQ(line_with(table, "Hypotheses"), "Hypotheses 2 (hyps:param.bnds) hold for these parameters.");
  for (const LedgerEntry& entry : ledger_entries(ledger_of(2)))
    EXPECT_NE(table.find(entry.exact), std::string::npos) << entry.name;
}

TEST(LedgerText, says_when_the_hypotheses_fail) {
  const Ledger ledger =
      constants_for(Dimension{2}, Rational(1), Rational(1) / Rational(5), Rational(0), Rational(1) / Rational(100));
  EXPECT_EQ(line_with(ledger_table(ledger), "Hypotheses"),
            "Hypotheses 2 (hyps:param.bnds) do not hold: the distortion 1/100 is above its bound.");
  EXPECT_EQ(nlohmann::json::parse(ledger_json(ledger))["hypotheses_2"], false);
}

TEST(LedgerText, is_json_with_exact_and_enclosing_strings) {
  const auto document = nlohmann::json::parse(ledger_json(ledger_of(3)));
  EXPECT_EQ(document["hypotheses_2"], true);
  const auto& flake = document["constants"]["flake_parameter"];
  EXPECT_EQ(flake["exact"], "2^(-74)·3^(-3/2)");
  EXPECT_EQ(flake["log2_lower"], "-76.3775");
  EXPECT_EQ(flake["log2_upper"], "-76.3774");
  EXPECT_EQ(document["constants"]["tolerance"]["log2_lower"], "-57");
  EXPECT_EQ(document["constants"].size(), ledger_entries(ledger_of(3)).size());
}

TEST(LedgerText, gives_an_estimate_as_one_and_without_false_precision) {
  const auto constants = nlohmann::json::parse(ledger_json(ledger_of(2)))["constants"];
  EXPECT_EQ(constants["sphere_sample_size_estimate"]["estimate"], "3.84e169");
  EXPECT_FALSE(constants["sphere_sample_size_estimate"].contains("lower"));
  EXPECT_FALSE(constants["sphere_sample_size_at_least"].contains("estimate"));
  EXPECT_NE(line_with(ledger_table(ledger_of(2)), "estimate").find("about 3.84e169"), std::string::npos);
}

TEST(LedgerText, shows_only_what_was_asked_for) {
  const ConstantNames only{"tolerance", "flake_parameter"};
  EXPECT_EQ(nlohmann::json::parse(ledger_json(ledger_of(2), only))["constants"].size(), 2U);
  const std::string table = ledger_table(ledger_of(2), only);
  EXPECT_EQ(std::count(table.begin(), table.end(), '\n'), 5) << table;
  EXPECT_EQ(line_with(table, "hoop"), "no line with hoop");
  EXPECT_EQ(line_with(ledger_latex(ledger_of(2), only), "hoop"), "no line with hoop");
}

TEST(LedgerText, names_every_constant_that_a_ledger_can_have) {
  const ConstantNames names = all_constant_names();
  for (const int dimension : {1, 2, 3, 4}) {
    for (const LedgerEntry& entry : ledger_entries(ledger_of(dimension)))
      EXPECT_NE(std::find(names.begin(), names.end(), entry.name), names.end()) << entry.name;
  }
}

SweptLedgers sweep() {
  const Rational quarter = Rational(1) / Rational(4);
  return ledgers_of({{Dimension{2}, Dimension{3}}, {quarter, Rational(1)}, {quarter, quarter / Rational(4)}, {}, {}});
}

TEST(LedgerText, compares_the_ledgers_of_a_sweep) {
  const std::string table = sweep_table(sweep(), {"distortion_bound", "sphere_sample_size_estimate", "dimension"});
  EXPECT_EQ(table.rfind("ξ₀ ≤  distortion bound  (hyps:param.bnds)\n  m  μ₀", 0), 0U) << table;
  EXPECT_EQ(with_single_blanks(line_with(table, "2^(-509)")), "2 1 1/4 2^(-509) [5.96667e-154, 5.96668e-154] -509");
  // Beyond every double, and exact.
  EXPECT_EQ(with_single_blanks(line_with(table, "  3  1/4")).rfind("3 1/4 1/16 2^(", 0), 0U) << table;
  EXPECT_EQ(
      line_with(table, "left out: ").rfind("left out: m = 2, μ₀ = 1/4, ρ₀ = 1/4: perturbation is 1/4; allowed", 0), 0U);
  EXPECT_EQ(line_with(table, "Hypotheses"), "Hypotheses 2 (hyps:param.bnds) hold for all of these parameters.");
  EXPECT_EQ(line_with(table, " m  dimension"), "no line with  m  dimension");
}

TEST(LedgerText, says_which_ledgers_of_a_sweep_violate_the_hypotheses) {
  const SweptLedgers swept = ledgers_of({{Dimension{2}}, {Rational(1)}, {}, {}, Rational(1) / Rational(100)});
  EXPECT_EQ(line_with(sweep_table(swept), "Hypotheses").rfind("m = 2, μ₀ = 1, ρ₀ = 25/101: Hypotheses 2", 0), 0U);
}

TEST(LedgerText, lists_the_ledgers_of_a_sweep_as_json) {
  const auto document = nlohmann::json::parse(sweep_json(sweep()));
  ASSERT_EQ(document["ledgers"].size(), 6U);
  ASSERT_EQ(document["left_out"].size(), 2U);
  EXPECT_EQ(document["left_out"][0]["separation"], "1/4");
  EXPECT_EQ(document["ledgers"][0]["parameters"]["perturbation"], "1/16");
  for (std::size_t i = 0; i < 6; ++i)
    EXPECT_EQ(document["ledgers"][i], nlohmann::json::parse(ledger_json(sweep().ledgers[i])));
}

TEST(LedgerText, sets_a_sweep_as_a_latex_longtable) {
  const std::string latex = sweep_latex(sweep());
  EXPECT_NE(latex.find("\\end{longtable}}\n% Hypotheses 2"), std::string::npos);
  std::istringstream lines(latex);
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("%") || !line.ends_with("\\\\")) continue;
    EXPECT_EQ(std::count(line.begin(), line.end(), '&'), 4) << line;
    EXPECT_EQ(std::count(line.begin(), line.end(), '$') % 2, 0) << line;
  }
}

TEST(LedgerText, is_a_latex_table_with_five_columns) {
  const std::string latex = ledger_latex(ledger_of(3));
  EXPECT_NE(latex.find("\\end{longtable}}\n"), std::string::npos);
  EXPECT_NE(line_with(latex, "flake parameter\\par} &")
                .find("{\\raggedright $\\Gamma_0$\\par} & {\\raggedright flake parameter\\par} & {\\raggedright "
                      "$2^{-74} \\cdot 3^{-3/2}$\\par} & "),
            std::string::npos);
  std::istringstream lines(latex);
  std::size_t rows = 0;
  for (std::string line; std::getline(lines, line);) {
    if (!line.ends_with("\\\\")) continue;
    EXPECT_EQ(std::count(line.begin(), line.end(), '&'), 4) << line;
    EXPECT_EQ(std::count(line.begin(), line.end(), '$') % 2, 0) << line;
    // Outside mathematics an underscore would end the run of LaTeX.
    bool mathematics = false;
    for (const char c : line) {
      if (c == '$') mathematics = !mathematics;
      EXPECT_TRUE(mathematics || c != '_') << line;
    }
    ++rows;
  }
  EXPECT_EQ(rows, ledger_entries(ledger_of(3)).size() + 1);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
