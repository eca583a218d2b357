#include "properties/attack/exponent.hpp"

#include <algorithm>

#include "kernel/formula/formula_text.hpp"
#include "proofs/formula/decision.hpp"

namespace delcert {

namespace {

bool contains(const Expression& term, const Expression& quantity) {
  return is_same_formula(term, quantity) ||
         std::any_of(term.children.begin(), term.children.end(),
                     [&](const ExpressionPointer& child) { return contains(*child, quantity); });
}

}  // namespace

std::optional<Rational> exponent_of(const Expression& quantity, const Expression& term, const Bindings& integers) {
  if (is_same_formula(term, quantity)) return Rational(1);
  if (!contains(term, quantity)) return Rational(0);
  const auto of_child = [&](std::size_t at) { return exponent_of(quantity, *term.children[at], integers); };
  switch (term.operation) {
    case Operation::negate:
      return of_child(0);
    case Operation::multiply:
    case Operation::divide: {
      const auto left = of_child(0);
      const auto right = of_child(1);
      if (!left || !right) return std::nullopt;
      return term.operation == Operation::multiply ? *left + *right : *left - *right;
    }
    case Operation::add:
    case Operation::subtract: {
      const auto left = of_child(0);
      return left && left == of_child(1) ? left : std::nullopt;
    }
    case Operation::power: {
      const auto base = of_child(0);
      if (!base || contains(*term.children[1], quantity)) return std::nullopt;
      Scene scene(integers);
      const auto exponent = exact_value(*term.children[1], scene);
      return exponent ? std::optional(*base * *exponent) : std::nullopt;
    }
    case Operation::call: {
      if (term.text != "sqrt") return std::nullopt;
      const auto inside = of_child(0);
      return inside ? std::optional(*inside / Rational(2)) : std::nullopt;
    }
    default:
      return std::nullopt;
  }
}

}  // namespace delcert
