#pragma once

#include <rapidcheck.h>

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "kernel/formula/expression.hpp"

namespace delcert::formulas {

inline ExpressionPointer made(Operation operation, std::vector<ExpressionPointer> children, std::string text = {}) {
  auto result = std::make_shared<Expression>();
  result->operation = operation;
  result->children = std::move(children);
  result->text = std::move(text);
  return result;
}

inline ExpressionPointer literal(Rational value) {
  auto result = std::make_shared<Expression>();
  result->value = std::move(value);
  return result;
}

/// Any tree that the parser can make, of at most the given height; types do not matter.
inline ExpressionPointer any_tree(int height) {
  const auto part = [height] { return any_tree(height - 1); };
  if (height == 0 || *rc::gen::inRange(0, 6) == 0) {
    if (*rc::gen::arbitrary<bool>()) return literal(Rational(*rc::gen::inRange(0, 100)));
    return made(Operation::name, {}, *rc::gen::element<std::string>("a", "k", "mu0", "xi_tilde"));
  }
  const auto operation = static_cast<Operation>(
      *rc::gen::inRange(static_cast<int>(Operation::call), static_cast<int>(Operation::exists) + 1));
  switch (operation) {
    case Operation::call: {
      std::vector<ExpressionPointer> arguments;
      const int count = *rc::gen::inRange(0, 4);
      for (int i = 0; i < count; ++i) arguments.push_back(part());
      return made(operation, std::move(arguments), *rc::gen::element<std::string>("f", "range", "thickness"));
    }
    case Operation::negate:
    case Operation::negation:
      return made(operation, {part()});
    case Operation::for_all:
    case Operation::exists: {
      // A set is not a statement, which the grammar knows.
      auto set = made(Operation::call, {part(), part()}, *rc::gen::element<std::string>("range", "faces"));
      return made(operation, {std::move(set), part()}, *rc::gen::element<std::string>("i", "j"));
    }
    default: {
      auto left = part();
      auto right = part();
      return made(operation, {std::move(left), std::move(right)});
    }
  }
}

/// A term of rational operations and integers, with its exact value; no division by 0.
inline std::pair<ExpressionPointer, Rational> rational_term(int height) {
  if (height == 0 || *rc::gen::inRange(0, 5) == 0) {
    const Rational value(*rc::gen::inRange(0, 50));
    return {literal(value), value};
  }
  auto [a, x] = rational_term(height - 1);
  switch (*rc::gen::inRange(0, 6)) {
    case 0:
      return {made(Operation::negate, {a}), -x};
    case 1: {
      const int exponent = *rc::gen::inRange(x == Rational(0) ? 0 : -3, 4);
      auto written = literal(Rational(exponent < 0 ? -exponent : exponent));
      if (exponent < 0) written = made(Operation::negate, {written});
      return {made(Operation::power, {a, written}), power(x, exponent)};
    }
    default:
      break;
  }
  auto [b, y] = rational_term(height - 1);
  switch (*rc::gen::inRange(0, 4)) {
    case 0:
      return {made(Operation::add, {a, b}), x + y};
    case 1:
      return {made(Operation::subtract, {a, b}), x - y};
    case 2:
      if (y != Rational(0)) return {made(Operation::divide, {a, b}), x / y};
      [[fallthrough]];
    default:
      return {made(Operation::multiply, {a, b}), x * y};
  }
}

}  // namespace delcert::formulas
