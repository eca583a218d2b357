#include "proofs/formula/latex.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <string_view>

#include "kernel/number/exact_text.hpp"
#include "support/latex_text.hpp"

namespace delcert {

namespace {

// How tightly a piece of LaTeX holds together, the loosest first.
enum class LatexLevel : unsigned char {
  statement,
  disjunction,
  conjunction,
  negation,
  comparison,
  sum,
  product,
  power,
  fraction,
  atom
};

struct Piece {
  std::string text;
  LatexLevel level = LatexLevel::atom;
};

std::string in_parentheses(const std::string& text) { return "\\left(" + text + "\\right)"; }

std::string at_least(const Piece& piece, LatexLevel least) {
  return piece.level < least ? in_parentheses(piece.text) : piece.text;
}

bool is_greek(std::string_view word) {
  constexpr std::array<std::string_view, 26> letters{
      "alpha", "beta", "gamma", "delta", "epsilon", "zeta", "eta", "theta", "iota",  "kappa", "lambda", "mu",    "nu",
      "xi",    "pi",   "rho",   "sigma", "tau",     "phi",  "chi", "psi",   "omega", "Gamma", "Delta",  "Sigma", "Phi"};
  return std::find(letters.begin(), letters.end(), word) != letters.end();
}

Piece piece_of(const Expression& expression);

/// The arguments of a template are delimited where a parenthesis, a brace of a command or a comma stands before them.
bool is_delimited(std::string_view before) {
  while (!before.empty() && before.back() == ' ') before.remove_suffix(1);
  if (before.empty()) return false;
  const char last = before.back();
  if (last == '(' || last == ',') return true;
  if (before.ends_with("\\lvert") || before.ends_with("\\lVert") || before.ends_with("\\langle")) return true;
  return last == '{' && before.size() > 1;
}

std::string filled(const std::string& pattern, const std::vector<Piece>& arguments) {
  std::string result;
  for (std::size_t at = 0; at < pattern.size(); ++at) {
    const bool is_sign = at > 0 && pattern[at - 1] == '\\';
    const bool is_place = pattern[at] == '#' && !is_sign && at + 1 < pattern.size();
    if (is_place && pattern[at + 1] == '*') {
      for (std::size_t number = 0; number < arguments.size(); ++number) {
        result += (number == 0 ? "" : ", ") + arguments[number].text;
      }
      ++at;
    } else if (is_place && std::isdigit(static_cast<unsigned char>(pattern[at + 1])) != 0) {
      const Piece& argument = arguments.at(static_cast<std::size_t>(pattern[at + 1] - '1'));
      const bool delimited = is_delimited(std::string_view(pattern).substr(0, at));
      result += at_least(argument, delimited ? LatexLevel::statement : LatexLevel::fraction);
      ++at;
    } else {
      result += pattern[at];
    }
  }
  return result;
}

std::string listed(const std::vector<Piece>& arguments) {
  std::string result = "(";
  for (const Piece& argument : arguments) result += (result.size() == 1 ? "" : ", ") + argument.text;
  return result + ")";
}

/// Whether what a function's template makes can stand anywhere without parentheses.
bool is_closed(std::string_view pattern) {
  if (pattern.find("\\,") != std::string_view::npos) return false;
  constexpr std::array<std::string_view, 5> closing{")", "}", "Vert", "vert", "\\rangle"};
  return std::any_of(closing.begin(), closing.end(), [&](std::string_view end) { return pattern.ends_with(end); });
}

Piece call_piece(const Expression& expression) {
  std::vector<Piece> arguments;
  for (const auto& child : expression.children) arguments.push_back(piece_of(*child));
  if (expression.definition != nullptr) {
    const std::string& pattern = expression.definition->latex;
    const bool has_places = pattern.find('#') != std::string::npos;
    return {has_places ? filled(pattern, arguments) : pattern + listed(arguments), LatexLevel::atom};
  }
  if (expression.function == nullptr)
    return {"\\mathrm{" + expression.text + "}" + listed(arguments), LatexLevel::atom};
  const std::string& pattern = expression.function->latex;
  LatexLevel level = is_closed(pattern) ? LatexLevel::atom : LatexLevel::product;
  if (expression.type == types::truth) level = LatexLevel::comparison;
  return {filled(pattern, arguments), level};
}

std::string_view relation_of(Operation operation) {
  switch (operation) {
    case Operation::less:
      return " < ";
    case Operation::less_equal:
      return " \\leq ";
    case Operation::greater:
      return " > ";
    case Operation::greater_equal:
      return " \\geq ";
    default:
      return " = ";
  }
}

Piece comparison_piece(const Expression& expression) {
  return {at_least(piece_of(*expression.children[0]), LatexLevel::sum) +
              std::string(relation_of(expression.operation)) +
              at_least(piece_of(*expression.children[1]), LatexLevel::sum),
          LatexLevel::comparison};
}

/// The last side of a comparison or of a chain of them; empty if there is none.
std::string last_side(const Expression& expression) {
  if (is_comparison(expression.operation)) return at_least(piece_of(*expression.children[1]), LatexLevel::sum);
  const bool may_be_chain =
      expression.operation == Operation::conjunction && is_comparison(expression.children[1]->operation);
  return may_be_chain ? last_side(*expression.children[1]) : "";
}

Piece conjunction_piece(const Expression& expression) {
  const Expression& left = *expression.children[0];
  const Expression& right = *expression.children[1];
  const Piece first = piece_of(left);
  const std::string middle = last_side(left);
  if (is_comparison(right.operation) && !middle.empty() && first.level == LatexLevel::comparison &&
      middle == at_least(piece_of(*right.children[0]), LatexLevel::sum)) {
    return {first.text + std::string(relation_of(right.operation)) +
                at_least(piece_of(*right.children[1]), LatexLevel::sum),
            LatexLevel::comparison};
  }
  return {at_least(first, LatexLevel::conjunction) + " \\land " + at_least(piece_of(right), LatexLevel::negation),
          LatexLevel::conjunction};
}

Piece product_piece(const Expression& expression) {
  const std::string left = at_least(piece_of(*expression.children[0]), LatexLevel::product);
  const std::string right = at_least(piece_of(*expression.children[1]), LatexLevel::power);
  const bool begins_with_digit = std::isdigit(static_cast<unsigned char>(right[0])) != 0;
  // A name before a parenthesis would read like a function.
  const bool reads_like_call = right.starts_with("\\left(") && expression.children[0]->operation != Operation::literal;
  return {left + (begins_with_digit || reads_like_call ? " \\cdot " : " ") + right, LatexLevel::product};
}

bool is_half(const Expression& exponent) {
  return exponent.operation == Operation::divide && exponent.children[0]->operation == Operation::literal &&
         exponent.children[0]->value == Rational(1) && exponent.children[1]->operation == Operation::literal &&
         exponent.children[1]->value == Rational(2);
}

Piece power_piece(const Expression& expression) {
  const Piece base = piece_of(*expression.children[0]);
  const Expression& exponent = *expression.children[1];
  if (is_half(exponent)) return {"\\sqrt{" + base.text + "}", LatexLevel::atom};
  // A fraction above the line is hard to read.
  const std::string raised = exponent.operation == Operation::divide
                                 ? at_least(piece_of(*exponent.children[0]), LatexLevel::product) + "/" +
                                       at_least(piece_of(*exponent.children[1]), LatexLevel::power)
                                 : piece_of(exponent).text;
  return {at_least(base, LatexLevel::atom) + "^{" + raised + "}", LatexLevel::power};
}

Piece quantifier_piece(const Expression& expression) {
  return {(expression.operation == Operation::for_all ? "\\forall " : "\\exists ") + latex_name(expression.text) +
              " \\in " + piece_of(*expression.children[0]).text + "\\colon " +
              at_least(piece_of(*expression.children[1]), LatexLevel::statement),
          LatexLevel::statement};
}

/// \sum_{p \in s} D(p, s): as loose as a sum, because a factor behind it would seem to belong to it.
Piece over_set_piece(const Expression& expression) {
  const auto sign = [&]() -> std::string {
    switch (expression.operation) {
      case Operation::sum_over:
        return "\\sum";
      case Operation::product_over:
        return "\\prod";
      case Operation::least_over:
        return "\\min";
      default:
        return "\\max";
    }
  };
  return {sign() + "_{" + latex_name(expression.text) + " \\in " + piece_of(*expression.children[0]).text + "} " +
              at_least(piece_of(*expression.children[1]), LatexLevel::product),
          LatexLevel::sum};
}

Piece infix(const Expression& expression, std::string_view sign, LatexLevel level, LatexLevel left, LatexLevel right) {
  return {at_least(piece_of(*expression.children[0]), left) + std::string(sign) +
              at_least(piece_of(*expression.children[1]), right),
          level};
}

Piece piece_of(const Expression& expression) {
  const auto part = [&](std::size_t at) { return piece_of(*expression.children[at]); };
  switch (expression.operation) {
    case Operation::literal:
      return {expression.value.numerator().str()};
    case Operation::name:
      return {latex_name(expression.text)};
    case Operation::call:
      return call_piece(expression);
    case Operation::negate:
      return {"-" + at_least(part(0), LatexLevel::product), LatexLevel::sum};
    case Operation::add:
      // Of a sum, a sign would follow the sign.
      return infix(expression, " + ", LatexLevel::sum, LatexLevel::sum, LatexLevel::product);
    case Operation::subtract:
      return infix(expression, " - ", LatexLevel::sum, LatexLevel::sum, LatexLevel::product);
    case Operation::multiply:
      return product_piece(expression);
    case Operation::divide:
      return {"\\frac{" + part(0).text + "}{" + part(1).text + "}", LatexLevel::fraction};
    case Operation::power:
      return power_piece(expression);
    case Operation::negation:
      return {"\\lnot " + at_least(part(0), LatexLevel::atom), LatexLevel::negation};
    case Operation::conjunction:
      return conjunction_piece(expression);
    case Operation::disjunction:
      return infix(expression, " \\lor ", LatexLevel::disjunction, LatexLevel::disjunction, LatexLevel::conjunction);
    case Operation::implication:
      return infix(expression, " \\implies ", LatexLevel::statement, LatexLevel::disjunction, LatexLevel::statement);
    case Operation::for_all:
    case Operation::exists:
      return quantifier_piece(expression);
    case Operation::sum_over:
    case Operation::product_over:
    case Operation::least_over:
    case Operation::greatest_over:
      return over_set_piece(expression);
    default:
      return comparison_piece(expression);
  }
}

/// A formula that may not fit a line is a paragraph, broken after relations and signs.
std::string display_line(const std::string& formula) {
  constexpr std::size_t longest = 110;
  if (formula.size() <= longest) return formula;
  return "\\parbox{0.98\\linewidth}{\\centering$\\displaystyle " + formula + "$}";
}

template <class Statements>
std::string displayed(const Statements& statements) {
  std::string result = "\\begin{gather*}\n";
  for (std::size_t at = 0; at < statements.size(); ++at) {
    result +=
        "  " + display_line(latex_of(*statements[at].formula)) + (at + 1 < statements.size() ? " \\\\" : "") + "\n";
  }
  return result + "\\end{gather*}\n";
}

std::string number_latex(const Rational& x) {
  const std::string sign = x < Rational(0) ? "-" : "";
  const Rational size = absolute(x);
  if (size.denominator() == 1) return sign + size.numerator().str();
  return sign + "\\frac{" + size.numerator().str() + "}{" + size.denominator().str() + "}";
}

std::string range_latex(const std::string& name, const ParameterRange& range) {
  return latex_name(name) + " \\in \\left" + (range.has_lower ? "[" : "(") +
         (range.lower ? number_latex(*range.lower) : "-\\infty") + ", " +
         (range.upper ? number_latex(*range.upper) : "\\infty") + "\\right" + (range.has_upper ? "]" : ")");
}

std::string range_latex(const std::string& name, const StepRange& range) {
  const std::string lower = range.lower ? number_latex(*range.lower) : "-\\infty";
  const std::string upper = range.upper ? number_latex(*range.upper) : "\\infty";
  return latex_name(name) + " \\in " + (range.is_integer ? "\\mathbb{Z} \\cap " : "") + "\\left" +
         (range.has_lower ? "[" : "(") + lower + ", " + upper + "\\right" + (range.has_upper ? "]" : ")");
}

}  // namespace

std::string latex_name(const std::string& name) {
  std::string stem = name;
  std::string wrapped_by;
  std::string primes;
  const auto take_ending = [&stem](std::string_view ending) {
    if (stem.size() <= ending.size() || !stem.ends_with(ending)) return false;
    stem.resize(stem.size() - ending.size());
    return true;
  };
  if (take_ending("_tilde")) wrapped_by = "\\tilde";
  while (take_ending("_prime")) primes += "'";
  std::size_t letters = stem.size();
  while (letters > 1 && std::isdigit(static_cast<unsigned char>(stem[letters - 1])) != 0) --letters;
  std::string subscript = stem.substr(letters);
  std::string symbol = stem.substr(0, letters);
  const std::size_t underscore = symbol.find('_');
  if (underscore == 1 && subscript.empty() && underscore + 2 == symbol.size()) {
    subscript = symbol.substr(2);
    symbol.resize(1);
  }
  if (is_greek(symbol)) {
    symbol = "\\" + symbol;
  } else if (symbol.size() != 1 || symbol == "_") {
    symbol = "\\mathrm{" + latex_text(symbol) + "}";
  }
  if (!wrapped_by.empty()) symbol = wrapped_by + "{" + symbol + "}";
  if (!subscript.empty()) symbol += subscript.size() == 1 ? "_" + subscript : "_{" + subscript + "}";
  return symbol + primes;
}

std::string latex_of(const Expression& expression) { return piece_of(expression).text; }

std::string latex_of(const Step& step) {
  std::string result = "\\subparagraph{" + latex_text(step.name) + "}";
  if (!step.lines.empty()) result += " (lines " + latex_text(step.lines) + ")";
  result += "\n";
  std::string separator = "For all ";
  for (const auto& [name, range] : step.parameters) {
    result += separator + "$" + range_latex(name, range) + "$";
    separator = ", ";
  }
  if (!step.parameters.empty()) result += "\n";
  separator = "with ";
  for (const Statement& abbreviation : step.abbreviations) {
    result += separator + "$" + latex_name(abbreviation.name) + " = " + latex_of(*abbreviation.formula) + "$";
    separator = ", ";
  }
  for (const auto& [name, value] : step.constants) {
    result += separator + "$" + latex_name(name) + " = " + number_latex(value) + "$";
    separator = ", ";
  }
  if (separator == ", ") result += "\n";
  if (!step.hypotheses.empty()) result += "such that\n" + displayed(step.hypotheses);
  return result + "there holds\n" + displayed(std::vector<Statement>{step.claim});
}

std::string latex_of(const Claim& claim) {
  std::string result = "\\paragraph{" + latex_text(claim.title.empty() ? claim.name : claim.title) + "}";
  if (!claim.source.empty()) result += " (\\texttt{" + latex_text(claim.source) + "})";
  result += "\n";
  if (claim.instance.empty()) {
    for (const Step& step : claim.steps) result += latex_of(step);
    return result;
  }
  result += "For every instance of the class \\texttt{" + latex_text(claim.instance) + "}";
  for (const auto& [name, range] : claim.parameters) result += ", all $" + range_latex(name, range) + "$";
  if (!claim.hypotheses.empty()) result += " with\n" + displayed(claim.hypotheses) + "there holds\n";
  if (claim.hypotheses.empty()) result += " there holds\n";
  result += displayed(claim.conclusions);
  for (const Step& step : claim.steps) result += latex_of(step);
  return result;
}

}  // namespace delcert
