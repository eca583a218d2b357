#include "proofs/formula/coq.hpp"

#include <algorithm>
#include <array>
#include <string_view>

namespace delcert {

namespace {

/// Thrown inside this file for what has no counterpart.
struct NotInCoq {};

class Printer {
 public:
  explicit Printer(const CoqNames& names) : names_(names) {}

  std::string text(const Expression& expression) const {
    switch (expression.operation) {
      case Operation::literal:
        return coq_number(expression.value);
      case Operation::name: {
        const auto found = names_.find(expression.text);
        return found == names_.end() ? coq_name(expression.text) : found->second;
      }
      case Operation::call:
        return call(expression);
      case Operation::negate:
        return "(- " + part(expression, 0) + ")";
      case Operation::power:
        return power(expression);
      case Operation::negation:
        return "(~ " + part(expression, 0) + ")";
      case Operation::for_all:
      case Operation::exists:
      case Operation::sum_over:
      case Operation::product_over:
      case Operation::least_over:
      case Operation::greatest_over:
        throw NotInCoq();
      default:
        return "(" + part(expression, 0) + std::string(sign_of(expression.operation)) + part(expression, 1) + ")";
    }
  }

 private:
  std::string part(const Expression& expression, std::size_t at) const { return text(*expression.children.at(at)); }

  static std::string_view sign_of(Operation operation) {
    switch (operation) {
      case Operation::add:
        return " + ";
      case Operation::subtract:
        return " - ";
      case Operation::multiply:
        return " * ";
      case Operation::divide:
        return " / ";
      case Operation::less:
        return " < ";
      case Operation::less_equal:
        return " <= ";
      case Operation::greater:
        return " > ";
      case Operation::greater_equal:
        return " >= ";
      case Operation::equal:
        return " = ";
      case Operation::conjunction:
        return " /\\ ";
      case Operation::disjunction:
        return " \\/ ";
      case Operation::implication:
        return " -> ";
      default:
        throw NotInCoq();
    }
  }

  std::string power(const Expression& expression) const {
    const std::string base = part(expression, 0);
    const auto exponent = rational_constant(*expression.children[1]);
    if (!exponent) return "(Rpower " + base + " " + part(expression, 1) + ")";
    const Integer denominator = exponent->denominator();
    if (denominator != 1 && denominator != 2) throw NotInCoq();
    const std::string radical = denominator == 1 ? base : "(sqrt " + base + ")";
    const Integer size = absolute(*exponent).numerator();
    const std::string raised = "(" + radical + " ^ " + size.str() + ")";
    return *exponent < Rational(0) ? "(/ " + raised + ")" : raised;
  }

  std::string call(const Expression& expression) const {
    if (expression.definition != nullptr) throw NotInCoq();
    const std::string& name = expression.text;
    if (name == "sqrt") return "(sqrt " + part(expression, 0) + ")";
    if (name == "abs") return "(Rabs " + part(expression, 0) + ")";
    if (name == "log2") return "(ln " + part(expression, 0) + " / ln 2)";
    if (name != "min" && name != "max") throw NotInCoq();
    std::string result = part(expression, 0);
    for (std::size_t at = 1; at < expression.children.size(); ++at) {
      result = (name == "min" ? "(Rmin " : "(Rmax ") + result + " " + part(expression, at) + ")";
    }
    return result;
  }

  const CoqNames& names_;
};

}  // namespace

std::optional<std::string> coq_of(const Expression& expression, const CoqNames& names) {
  try {
    return Printer(names).text(expression);
  } catch (const NotInCoq&) {
    return std::nullopt;
  }
}

std::string coq_name(const std::string& name) {
  constexpr std::array<std::string_view, 27> taken{
      "R",  "Type", "Prop", "Set", "SProp", "as",  "at",     "by",     "cofix", "else",  "end",   "fix",  "for", "fun",
      "if", "in",   "is",   "let", "match", "mod", "return", "struct", "then",  "using", "where", "with", "_"};
  return std::find(taken.begin(), taken.end(), name) == taken.end() ? name : name + "_";
}

std::string coq_number(const Rational& value) {
  std::string result = value.numerator().str();
  if (value.denominator() != 1) return "(" + result + " / " + value.denominator().str() + ")";
  return value < Rational(0) ? "(" + result + ")" : result;
}

std::optional<Rational> rational_constant(const Expression& term) {
  if (term.operation == Operation::literal) return term.value;
  if (term.operation == Operation::name || term.operation == Operation::call || term.children.empty()) {
    return std::nullopt;
  }
  const auto a = rational_constant(*term.children[0]);
  if (!a) return std::nullopt;
  if (term.operation == Operation::negate) return -*a;
  if (term.children.size() < 2) return std::nullopt;
  const auto b = rational_constant(*term.children[1]);
  if (!b) return std::nullopt;
  constexpr long largest_exponent = 10000;
  switch (term.operation) {
    case Operation::add:
      return *a + *b;
    case Operation::subtract:
      return *a - *b;
    case Operation::multiply:
      return *a * *b;
    case Operation::divide:
      if (*b == Rational(0)) return std::nullopt;
      return *a / *b;
    case Operation::power:
      if (b->denominator() != 1 || absolute(*b) > Rational(largest_exponent)) return std::nullopt;
      if (*a == Rational(0) && *b < Rational(0)) return std::nullopt;
      return power(*a, static_cast<long>(b->numerator()));
    default:
      return std::nullopt;
  }
}

}  // namespace delcert
