#include "kernel/formula/plain_formula.hpp"

#include <algorithm>

#include "kernel/formula/formula_error.hpp"
#include "kernel/formula/formula_text.hpp"
#include "kernel/formula/parser.hpp"
#include "kernel/formula/token.hpp"

namespace delcert {

namespace {

constexpr std::size_t longest_variable = 16;
constexpr std::string_view name_of_absolute_value = "abs";

bool is_small_letter(char c) { return c >= 'a' && c <= 'z'; }
bool belongs_to_variable(char c) { return is_small_letter(c) || (c >= '0' && c <= '9') || c == '_'; }

void check_name(const Expression& formula, const std::vector<std::string>& variables) {
  if (std::find(variables.begin(), variables.end(), formula.text) != variables.end()) return;
  const std::vector<std::string_view>& functions = functions_of_plain_formulas();
  if (std::find(functions.begin(), functions.end(), formula.text) != functions.end())
    throw FormulaError(formula.offset, formula.text + " is a function: write " + formula.text + "(…)");
  throw FormulaError(formula.offset,
                     "unknown variable " + shortened(formula.text) + suggestion(formula.text, variables));
}

void check_call(const Expression& formula, AbsoluteValues absolute_values) {
  const std::vector<std::string_view>& functions = functions_of_plain_formulas();
  const bool is_known = std::find(functions.begin(), functions.end(), formula.text) != functions.end() ||
                        (formula.text == name_of_absolute_value && absolute_values == AbsoluteValues::allowed);
  if (!is_known)
    throw FormulaError(formula.offset, "unknown function " + shortened(formula.text) +
                                           suggestion(formula.text, functions) + "; there are sqrt, exp, sin and cos");
  if (formula.children.size() != 1) throw FormulaError(formula.offset, formula.text + " takes one argument");
}

void check_exponent(const Expression& exponent) {
  if (exponent.operation == Operation::literal && exponent.value <= Rational(greatest_exponent)) return;
  throw FormulaError(exponent.offset, "an exponent is a whole number from 0 to " + std::to_string(greatest_exponent));
}

void check(const Expression& formula, const std::vector<std::string>& variables, AbsoluteValues absolute_values) {
  switch (formula.operation) {
    case Operation::literal:
      return;
    case Operation::name:
      return check_name(formula, variables);
    case Operation::power:
      check(*formula.children[0], variables, absolute_values);
      return check_exponent(*formula.children[1]);
    case Operation::call:
      check_call(formula, absolute_values);
      break;
    case Operation::negate:
    case Operation::add:
    case Operation::subtract:
    case Operation::multiply:
    case Operation::divide:
      break;
    default:
      throw FormulaError(formula.offset, is_comparison(formula.operation)
                                             ? "a comparison where a real function was expected: for a = b write a - b"
                                             : "a statement where a real function was expected");
  }
  for (const ExpressionPointer& child : formula.children) check(*child, variables, absolute_values);
}

}  // namespace

const std::vector<std::string_view>& functions_of_plain_formulas() {
  static const std::vector<std::string_view> functions{"sqrt", "exp", "sin", "cos"};
  return functions;
}

bool is_name_of_variable(std::string_view name) {
  const std::vector<std::string_view>& functions = functions_of_plain_formulas();
  return !name.empty() && name.size() <= longest_variable && is_small_letter(name[0]) &&
         std::all_of(name.begin(), name.end(), belongs_to_variable) && !is_keyword(name) &&
         std::find(functions.begin(), functions.end(), name) == functions.end();
}

ExpressionPointer parse_plain_formula(std::string_view text, const std::vector<std::string>& variables,
                                      AbsoluteValues absolute_values) {
  ExpressionPointer result = parse_formula(text);
  check(*result, variables, absolute_values);
  return result;
}

bool has_absolute_values(const Expression& formula) {
  return (formula.operation == Operation::call && formula.text == name_of_absolute_value) ||
         std::any_of(formula.children.begin(), formula.children.end(),
                     [](const ExpressionPointer& child) { return has_absolute_values(*child); });
}

std::string canonical_text(const Expression& formula) {
  std::string text = formula_text(formula);
  text.erase(std::remove(text.begin(), text.end(), ' '), text.end());
  return text;
}

}  // namespace delcert
