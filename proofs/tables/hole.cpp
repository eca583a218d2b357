#include "proofs/tables/hole.hpp"

#include <algorithm>
#include <vector>

#include "kernel/formula/formula_text.hpp"

namespace delcert {

namespace {

bool is_hole(const Expression& pattern) { return pattern.operation == Operation::name && pattern.text == "C"; }

bool has_hole(const Expression& pattern) {
  return is_hole(pattern) || std::any_of(pattern.children.begin(), pattern.children.end(),
                                         [](const ExpressionPointer& child) { return has_hole(*child); });
}

/// An expression as a number times factors above and below a line.
struct Product {
  Rational coefficient{1};
  std::vector<const Expression*> above;
  std::vector<const Expression*> below;
  bool has_hole = false;
};

void multiply_in(Product& product, const Expression& expression, bool is_above) {
  if (is_hole(expression) && is_above) {
    product.has_hole = true;
    return;
  }
  const auto number = constant_value(expression);
  if (number && *number != Rational(0)) {
    product.coefficient = is_above ? product.coefficient * *number : product.coefficient / *number;
  } else if (expression.operation == Operation::multiply || expression.operation == Operation::divide) {
    multiply_in(product, *expression.children[0], is_above);
    multiply_in(product, *expression.children[1], is_above == (expression.operation == Operation::multiply));
  } else {
    (is_above ? product.above : product.below).push_back(&expression);
  }
}

Product product_of(const Expression& expression) {
  Product product;
  multiply_in(product, expression, true);
  return product;
}

bool is_product(const Expression& expression) {
  return expression.operation == Operation::multiply || expression.operation == Operation::divide;
}

std::optional<Rational> matched(const Expression& formula, const Expression& pattern);

/// Parts that agree but for the one with the hole.
template <class Parts>
std::optional<Rational> matched_parts(const Parts& formula, const Parts& pattern) {
  if (formula.size() != pattern.size()) return std::nullopt;
  std::optional<Rational> result;
  for (std::size_t i = 0; i < pattern.size(); ++i) {
    if (has_hole(*pattern[i])) {
      result = matched(*formula[i], *pattern[i]);
    } else if (!is_same_formula(*formula[i], *pattern[i])) {
      return std::nullopt;
    }
  }
  return result;
}

bool are_same(const std::vector<const Expression*>& a, const std::vector<const Expression*>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const Expression* x, const Expression* y) { return is_same_formula(*x, *y); });
}

std::optional<Rational> matched_product(const Product& formula, const Product& pattern) {
  if (pattern.has_hole) {
    if (!are_same(formula.above, pattern.above) || !are_same(formula.below, pattern.below)) return std::nullopt;
    return formula.coefficient / pattern.coefficient;
  }
  if (formula.coefficient != pattern.coefficient) return std::nullopt;
  if (are_same(formula.below, pattern.below)) return matched_parts(formula.above, pattern.above);
  return are_same(formula.above, pattern.above) ? matched_parts(formula.below, pattern.below) : std::nullopt;
}

std::optional<Rational> matched(const Expression& formula, const Expression& pattern) {
  if (is_hole(pattern) || is_product(pattern)) return matched_product(product_of(formula), product_of(pattern));
  if (formula.operation != pattern.operation || formula.text != pattern.text) return std::nullopt;
  return matched_parts(formula.children, pattern.children);
}

std::optional<Rational> power_of(const Rational& base, const Rational& exponent) {
  constexpr long largest = 1000;
  if (exponent.denominator() != 1 || absolute(exponent) > Rational(largest)) return std::nullopt;
  if (base == Rational(0) && exponent < Rational(0)) return std::nullopt;
  return power(base, static_cast<long>(exponent.numerator()));
}

}  // namespace

std::optional<Rational> constant_in(const Expression& formula, const Expression& pattern) {
  return matched(formula, pattern);
}

std::optional<Rational> constant_value(const Expression& expression) {
  if (expression.operation == Operation::literal) return expression.value;
  if (expression.children.empty() || expression.children.size() > 2) return std::nullopt;
  const auto left = constant_value(*expression.children[0]);
  if (!left) return std::nullopt;
  if (expression.operation == Operation::negate) return -*left;
  if (expression.children.size() != 2) return std::nullopt;
  const auto right = constant_value(*expression.children[1]);
  if (!right) return std::nullopt;
  switch (expression.operation) {
    case Operation::add:
      return *left + *right;
    case Operation::subtract:
      return *left - *right;
    case Operation::multiply:
      return *left * *right;
    case Operation::divide:
      return *right == Rational(0) ? std::nullopt : std::optional(*left / *right);
    case Operation::power:
      return power_of(*left, *right);
    default:
      return std::nullopt;
  }
}

}  // namespace delcert
