#include "proofs/formula/latex.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "proofs/formula/type_check.hpp"
#include "properties/instances/instance_class.hpp"
#include "tests/proofs/formula/random_formulas.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

Signature signature() {
  return {{"s", {"simplex", false}}, {"k", types::integer},  {"m", types::integer},
          {"xi", types::number},     {"eta", types::number}, {"mu0", types::number}};
}

std::string latex(std::string_view text, const Type& type = types::number) {
  return latex_of(*type_checked(parse_formula(text), full_vocabulary(), signature(), type));
}
std::string latex_of_statement(std::string_view text) { return latex(text, types::truth); }

TEST(Latex, terms) {
  EXPECT_EQ(latex("1 + 2*k"), "1 + 2 k");
  EXPECT_EQ(latex("k*2"), "k \\cdot 2");
  EXPECT_EQ(latex("(1 + xi)*k"), "\\left(1 + \\xi\\right) k");
  EXPECT_EQ(latex("k*(1 + xi)"), "k \\cdot \\left(1 + \\xi\\right)");
  EXPECT_EQ(latex("2*(1 + xi)"), "2 \\left(1 + \\xi\\right)");
  EXPECT_EQ(latex("k - (m - 1)"), "k - \\left(m - 1\\right)");
  EXPECT_EQ(latex("k - m - 1"), "k - m - 1");
  EXPECT_EQ(latex("k - -m"), "k - \\left(-m\\right)");
  EXPECT_EQ(latex("-(k + m)"), "-\\left(k + m\\right)");
  EXPECT_EQ(latex("-k*m"), "\\left(-k\\right) m");
}

TEST(Latex, quotients_are_fractions_and_roots_are_roots) {
  EXPECT_EQ(latex("(1 + xi)/k"), "\\frac{1 + \\xi}{k}");
  EXPECT_EQ(latex("1/k/m"), "\\frac{\\frac{1}{k}}{m}");
  EXPECT_EQ(latex("(xi/k)^2"), "\\left(\\frac{\\xi}{k}\\right)^{2}");
  EXPECT_EQ(latex("sqrt(k + 1)"), "\\sqrt{k + 1}");
  EXPECT_EQ(latex("(k + 1)^(1/2)"), "\\sqrt{k + 1}");
  EXPECT_EQ(latex("m^(3/2)"), "m^{3/2}");
  EXPECT_EQ(latex("2^(k + 1)"), "2^{k + 1}");
  EXPECT_EQ(latex("xi^((k + 1)/2)"), "\\xi^{\\left(k + 1\\right)/2}");
  EXPECT_EQ(latex("(2^k)^m"), "\\left(2^{k}\\right)^{m}");
  EXPECT_EQ(latex("-xi^2"), "-\\xi^{2}");
}

TEST(Latex, functions_fill_their_templates) {
  EXPECT_EQ(latex("thickness(s)"), "\\Upsilon(s)");
  EXPECT_EQ(latex("thickness(s)^2"), "\\Upsilon(s)^{2}");
  EXPECT_EQ(latex("edge(s, 0, k - 1)"), "\\lVert {s}_{0} - {s}_{k - 1}\\rVert");
  EXPECT_EQ(latex("min(1, xi, k + 1)"), "\\min\\{1, \\xi, k + 1\\}");
  EXPECT_EQ(latex("abs(xi - 1)"), "\\lvert \\xi - 1\\rvert");
  EXPECT_EQ(latex("log2(k)"), "\\log_2 k");
  EXPECT_EQ(latex("log2(k + 1)"), "\\log_2 \\left(k + 1\\right)");
  EXPECT_EQ(latex("log2(k)^2"), "\\left(\\log_2 k\\right)^{2}");
  EXPECT_EQ(latex("2*constant_c(m, mu0)"), "2 C(m, \\mu_0)");
}

TEST(Latex, terms_over_sets) {
  EXPECT_EQ(latex("sum(p in vertices(s): altitude(s, p))"), "\\sum_{p \\in s} D(p, s)");
  EXPECT_EQ(latex("k*max(i in 1 .. k: i + xi)"),
            "k \\cdot \\left(\\max_{i \\in \\{1, \\ldots, k\\}} \\left(i + \\xi\\right)\\right)");
  EXPECT_EQ(latex("product(i in 1 .. k: i)^2"), "\\left(\\prod_{i \\in \\{1, \\ldots, k\\}} i\\right)^{2}");
  EXPECT_EQ(latex("min(i in 1 .. k: i) + 1"), "\\min_{i \\in \\{1, \\ldots, k\\}} i + 1");
}

TEST(Latex, statements) {
  EXPECT_EQ(latex_of_statement("xi <= 1 and k >= 1 or m > 2"), "\\xi \\leq 1 \\land k \\geq 1 \\lor m > 2");
  EXPECT_EQ(latex_of_statement("xi <= 1 and (k >= 1 or m > 2)"),
            "\\xi \\leq 1 \\land \\left(k \\geq 1 \\lor m > 2\\right)");
  EXPECT_EQ(latex_of_statement("0 < xi <= 1"), "0 < \\xi \\leq 1");
  EXPECT_EQ(latex_of_statement("0 < xi <= 1 < k"), "0 < \\xi \\leq 1 < k");
  EXPECT_EQ(latex_of_statement("0 < xi and eta <= 1"), "0 < \\xi \\land \\eta \\leq 1");
  EXPECT_EQ(latex_of_statement("not xi = 1"), "\\lnot \\left(\\xi = 1\\right)");
  EXPECT_EQ(latex_of_statement("xi < 1 implies k < 2 implies m < 3"), "\\xi < 1 \\implies k < 2 \\implies m < 3");
  EXPECT_EQ(latex_of_statement("forall i in 1..k: altitude(s, i) > 0"),
            "\\forall i \\in \\{1, \\ldots, k\\}\\colon D(i, s) > 0");
  EXPECT_EQ(latex_of_statement("(exists i in 1..k: altitude(s, i) > 0) and k > 1"),
            "\\left(\\exists i \\in \\{1, \\ldots, k\\}\\colon D(i, s) > 0\\right) \\land k > 1");
}

TEST(Latex, names_become_symbols) {
  EXPECT_EQ(latex_name("k"), "k");
  EXPECT_EQ(latex_name("mu0"), "\\mu_0");
  EXPECT_EQ(latex_name("xi_tilde"), "\\tilde{\\xi}");
  EXPECT_EQ(latex_name("rho0_tilde"), "\\tilde{\\rho}_0");
  EXPECT_EQ(latex_name("mu0_prime"), "\\mu_0'");
  EXPECT_EQ(latex_name("x12"), "x_{12}");
  EXPECT_EQ(latex_name("s_i"), "s_i");
  EXPECT_EQ(latex_name("label"), "\\mathrm{label}");
  EXPECT_EQ(latex_name("first_label"), "\\mathrm{first\\_label}");
  EXPECT_EQ(latex_name("_"), "\\mathrm{\\_}");
}

/// Braces, \left and \right of LaTeX come in pairs.
bool is_balanced(const std::string& text) {
  std::vector<char> open;
  for (std::size_t at = 0; at < text.size(); ++at) {
    if (text[at] == '\\' && at + 1 < text.size() && (text[at + 1] == '{' || text[at + 1] == '}')) {
      ++at;
    } else if (text[at] == '{') {
      open.push_back('}');
    } else if (text.compare(at, 5, "\\left") == 0) {
      open.push_back('r');
    } else if (text[at] == '}' || text.compare(at, 6, "\\right") == 0) {
      if (open.empty() || open.back() != (text[at] == '}' ? '}' : 'r')) return false;
      open.pop_back();
    }
  }
  return open.empty();
}

RC_GTEST_PROP(Latex, of_any_tree_is_balanced, ()) {
  const std::string text = latex_of(*formulas::any_tree(*rc::gen::inRange(0, 6)));
  RC_LOG(text);
  RC_ASSERT(is_balanced(text));
}

TEST(Latex, the_check_of_balance_notices_what_is_not) {
  EXPECT_FALSE(is_balanced("\\frac{a}{b"));
  EXPECT_FALSE(is_balanced("\\left({a\\right)}"));
  EXPECT_TRUE(is_balanced("\\{a\\left(b\\right)"));
}

TEST(Latex, every_function_has_a_template_with_all_its_arguments) {
  for (const auto& [name, function] : full_vocabulary().functions()) {
    EXPECT_FALSE(function.latex.empty()) << name;
    EXPECT_TRUE(is_balanced(function.latex)) << name << ": " << function.latex;
    for (std::size_t number = 1; number <= function.parameters.size(); ++number) {
      const bool is_there = function.latex.find("#" + std::to_string(number)) != std::string::npos ||
                            function.latex.find("#*") != std::string::npos;
      EXPECT_TRUE(is_there) << name << " without #" << number << ": " << function.latex;
    }
    for (std::size_t at = function.latex.find('#'); at != std::string::npos; at = function.latex.find('#', at + 1)) {
      if (at > 0 && function.latex[at - 1] == '\\') continue;  // the sign itself
      const char number = function.latex.at(at + 1);
      EXPECT_TRUE(number == '*' || (number >= '1' && number < static_cast<char>('1' + function.parameters.size())))
          << name << ": " << function.latex;
    }
  }
  for (const auto& [name, definition] : full_vocabulary().definitions()) {
    EXPECT_TRUE(is_balanced(definition.latex) && !definition.latex.empty()) << name;
  }
}

TEST(Latex, a_claim_is_a_paragraph) {
  const Claim claim = parse_claim(
      "name = \"thick\"\ntitle = \"Thick & thin_\"\nsource = \"lem:x_y\"\nstatus = \"paper\"\n"
      "instance = \"simplex\"\nforall = { eta = \"(0, 1/2]\" }\ngiven = [\"eta <= thickness(s)\", \"k > 1\"]\n"
      "[[show]]\nclaim = \"longest_edge(s) > eta\"\n",
      "a.toml", full_vocabulary(), {{"simplex", {{"s", {"simplex", false}}, {"k", types::integer}}}});
  EXPECT_EQ(latex_of(claim),
            "\\paragraph{Thick \\& thin\\_} (\\texttt{lem:x\\_y})\n"
            "For every instance of the class \\texttt{simplex}, all $\\eta \\in \\left(0, \\frac{1}{2}\\right]$ with\n"
            "\\begin{gather*}\n  \\eta \\leq \\Upsilon(s) \\\\\n  k > 1\n\\end{gather*}\n"
            "there holds\n"
            "\\begin{gather*}\n  \\Delta(s) > \\eta\n\\end{gather*}\n");
}

TEST(Latex, a_formula_that_may_not_fit_a_line_is_a_paragraph) {
  std::string sum = "k";
  for (int term = 0; term < 40; ++term) sum += " + k";
  const auto latex_with = [](const std::string& formula) {
    return latex_of(parse_claim(
        "name = \"n\"\n[[step]]\nname = \"s\"\nforall = { k = \"(0, 1]\" }\nclaim = \"" + formula + " > 0\"\n",
        "a.toml", full_vocabulary(), {}));
  };
  EXPECT_NE(latex_with(sum).find("\\parbox{0.98\\linewidth}{\\centering$\\displaystyle k + k"), std::string::npos);
  EXPECT_EQ(latex_with("k").find("\\parbox"), std::string::npos);
}

TEST(Latex, of_steps_names_parameters_abbreviations_and_constants) {
  const Claim claim = parse_claim(
      "name = \"n\"\n[[step]]\nname = \"s_1\"\nlines = \"6-7\"\n"
      "forall = { k = \"integer [1, infinity)\", xi = \"(-infinity, 1/4]\" }\nlet = { a = \"1 + xi\" }\n"
      "constants = { c = \"-4/5\" }\ngiven = [\"xi > 0\"]\nclaim = \"1/a >= c*k\"\n"
      "[[step]]\nname = \"t\"\nclaim = \"1 < 2\"\n",
      "a.toml", full_vocabulary(), {});
  EXPECT_EQ(latex_of(claim),
            "\\paragraph{n}\n\\subparagraph{s\\_1} (lines 6-7)\n"
            "For all $k \\in \\mathbb{Z} \\cap \\left[1, \\infty\\right)$, $\\xi \\in \\left(-\\infty, "
            "\\frac{1}{4}\\right]$\n"
            "with $a = 1 + \\xi$, $c = -\\frac{4}{5}$\n"
            "such that\n\\begin{gather*}\n  \\xi > 0\n\\end{gather*}\n"
            "there holds\n\\begin{gather*}\n  \\frac{1}{a} \\geq c k\n\\end{gather*}\n"
            "\\subparagraph{t}\nthere holds\n\\begin{gather*}\n  1 < 2\n\\end{gather*}\n");
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
