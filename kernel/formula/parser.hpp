#pragma once

#include <optional>
#include <string_view>

#include "kernel/formula/expression.hpp"

namespace delcert {

/// Reads a statement or a term (docs/claim-format.md has the grammar). Types are not looked at yet.
/// Throws FormulaError, saying what stands where and what was expected; also for a tree of more than 200 levels (a sum
/// of n terms has n of them), so that no reader of it needs a deep stack.
[[nodiscard]] ExpressionPointer parse_formula(std::string_view text);

/// The operation of a term that runs through a set, by its word: `sum`, `product`, `min`, `max`.
[[nodiscard]] std::optional<Operation> operation_over_set(std::string_view word);
/// The word of such an operation; empty for others.
[[nodiscard]] std::string_view word_over_set(Operation operation);

/// An interval of reals that a parameter runs through: "(0, 1]", "[1/2, 2)", "[1, infinity)".
struct ParameterRange {
  std::optional<Rational> lower;  ///< nothing: −∞
  std::optional<Rational> upper;  ///< nothing: ∞
  bool has_lower = false;         ///< the lower end belongs to it
  bool has_upper = false;
};

/// Reads an interval with ends that are rational or, open there, infinite. Throws FormulaError for anything else, and
/// for an empty one.
[[nodiscard]] ParameterRange parse_range(std::string_view text);

}  // namespace delcert
