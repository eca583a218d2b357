#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "kernel/number/rational.hpp"

namespace delcert {

struct Function;
struct Definition;

/// The type of an expression: `number`, `integer`, `truth`, the kind of an object, or a finite set of one of these.
struct Type {
  std::string name;
  bool is_set = false;

  friend bool operator==(const Type& a, const Type& b) = default;
  /// For messages: "number", "set of simplex".
  [[nodiscard]] std::string text() const { return is_set ? "set of " + name : name; }
};

namespace types {
inline const Type number{"number", false};
inline const Type integer{"integer", false};
inline const Type truth{"truth", false};
inline const Type integers{"integer", true};
}  // namespace types

enum class Operation : unsigned char {
  literal,        ///< a rational number
  name,           ///< a bound name
  call,           ///< a function of the vocabulary, or a definition
  negate,         ///< −a
  add,            ///< a + b
  subtract,       ///< a − b
  multiply,       ///< a · b
  divide,         ///< a / b
  power,          ///< a ^ b, b an integer or half an integer that depends on integers only
  less,           ///< a < b
  less_equal,     ///< a ≤ b
  greater,        ///< a > b
  greater_equal,  ///< a ≥ b
  equal,          ///< a = b
  negation,       ///< not a
  conjunction,    ///< a and b
  disjunction,    ///< a or b
  implication,    ///< a implies b
  for_all,        ///< forall text in a: b
  exists,         ///< exists text in a: b
  sum_over,       ///< sum(text in a: b)
  product_over,   ///< product(text in a: b)
  least_over,     ///< min(text in a: b)
  greatest_over,  ///< max(text in a: b)
};

/// One node of the syntax tree that all readers share: the exact decision, the enclosure of ratios, LaTeX, the prover.
struct Expression {
  Operation operation = Operation::literal;
  std::size_t offset = 0;  ///< where in the text of the formula its operator, name or number begins
  std::string text;        ///< the name, the function's name, or the variable that a quantifier or a term binds
  Rational value;          ///< of a literal
  std::vector<std::shared_ptr<const Expression>> children;

  // What the type check finds.
  Type type;
  const Function* function = nullptr;      ///< of a call, unless it is a definition
  const Definition* definition = nullptr;  ///< of a call of a definition
};

using ExpressionPointer = std::shared_ptr<const Expression>;

[[nodiscard]] constexpr bool is_comparison(Operation operation) {
  return operation >= Operation::less && operation <= Operation::equal;
}

/// A sum, a product, the least or the greatest of the terms for all elements of a set.
[[nodiscard]] constexpr bool is_term_over_set(Operation operation) { return operation >= Operation::sum_over; }

/// Whether `text` is a variable in the second child, which runs through the first.
[[nodiscard]] constexpr bool binds_variable(Operation operation) {
  return operation == Operation::for_all || operation == Operation::exists || is_term_over_set(operation);
}

}  // namespace delcert
