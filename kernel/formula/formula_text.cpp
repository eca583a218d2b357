#include "kernel/formula/formula_text.hpp"

#include <algorithm>
#include <string_view>

#include "kernel/formula/parser.hpp"

namespace delcert {

namespace {

// The levels of the grammar, the loosest first.
enum class Level : unsigned char { statement, disjunction, conjunction, negation, sum, product, factor, atom };

Level level_of(Operation operation) {
  switch (operation) {
    case Operation::for_all:
    case Operation::exists:
    case Operation::implication:
      return Level::statement;
    case Operation::disjunction:
      return Level::disjunction;
    case Operation::conjunction:
      return Level::conjunction;
    case Operation::negation:
    case Operation::less:
    case Operation::less_equal:
    case Operation::greater:
    case Operation::greater_equal:
    case Operation::equal:
      return Level::negation;
    case Operation::add:
    case Operation::subtract:
      return Level::sum;
    case Operation::multiply:
    case Operation::divide:
      return Level::product;
    case Operation::negate:
    case Operation::power:
      return Level::factor;
    default:
      return Level::atom;
  }
}

std::string_view sign_of(Operation operation) {
  switch (operation) {
    case Operation::implication:
      return " implies ";
    case Operation::disjunction:
      return " or ";
    case Operation::conjunction:
      return " and ";
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
    case Operation::add:
      return " + ";
    case Operation::subtract:
      return " - ";
    case Operation::multiply:
      return "*";
    case Operation::divide:
      return "/";
    default:
      return "^";
  }
}

std::string text_at(const Expression& expression, Level least);

/// left and right are the levels that may stand there without parentheses.
std::string infix(const Expression& expression, Level left, Level right) {
  return text_at(*expression.children[0], left) + std::string(sign_of(expression.operation)) +
         text_at(*expression.children[1], right);
}

std::string call_text(const Expression& expression) {
  std::string result = expression.text + "(";
  for (std::size_t at = 0; at < expression.children.size(); ++at) {
    result += (at == 0 ? "" : ", ") + text_at(*expression.children[at], Level::statement);
  }
  return result + ")";
}

std::string set_text(const Expression& set) {
  if (set.operation == Operation::call && set.text == "range" && set.children.size() == 2) {
    return text_at(*set.children[0], Level::sum) + " .. " + text_at(*set.children[1], Level::sum);
  }
  return text_at(set, Level::sum);
}

std::string variable_text(const Expression& expression) {
  return expression.text + " in " + set_text(*expression.children[0]) + ": " +
         text_at(*expression.children[1], Level::statement);
}

std::string bare_text(const Expression& expression) {
  switch (expression.operation) {
    case Operation::literal:
      return expression.value.numerator().str();
    case Operation::name:
      return expression.text;
    case Operation::call:
      return call_text(expression);
    case Operation::negate:
      return "-" + text_at(*expression.children[0], Level::factor);
    case Operation::negation:
      return "not " + text_at(*expression.children[0], Level::negation);
    case Operation::for_all:
    case Operation::exists:
      return (expression.operation == Operation::for_all ? "forall " : "exists ") + variable_text(expression);
    case Operation::sum_over:
    case Operation::product_over:
    case Operation::least_over:
    case Operation::greatest_over:
      return std::string(word_over_set(expression.operation)) + "(" + variable_text(expression) + ")";
    case Operation::implication:
      return infix(expression, Level::disjunction, Level::statement);
    case Operation::disjunction:
      return infix(expression, Level::disjunction, Level::conjunction);
    case Operation::conjunction:
      return infix(expression, Level::conjunction, Level::negation);
    case Operation::add:
    case Operation::subtract:
      return infix(expression, Level::sum, Level::product);
    case Operation::multiply:
    case Operation::divide:
      return infix(expression, Level::product, Level::factor);
    case Operation::power:
      return infix(expression, Level::atom, Level::factor);
    default:
      return infix(expression, Level::sum, Level::sum);
  }
}

std::string text_at(const Expression& expression, Level least) {
  const std::string text = bare_text(expression);
  return level_of(expression.operation) < least ? "(" + text + ")" : text;
}

}  // namespace

std::string formula_text(const Expression& expression) { return text_at(expression, Level::statement); }

bool is_same_formula(const Expression& a, const Expression& b) {
  return a.operation == b.operation && a.text == b.text && a.value == b.value &&
         std::equal(a.children.begin(), a.children.end(), b.children.begin(), b.children.end(),
                    [](const auto& x, const auto& y) { return is_same_formula(*x, *y); });
}

}  // namespace delcert
