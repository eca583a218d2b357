#pragma once

#include <string_view>

#include "kernel/formula/expression.hpp"

namespace delcert {

/// Reads a statement or a term (docs/claim-format.md has the grammar). Types are not looked at yet.
/// Throws FormulaError, saying what stands where and what was expected; also for a tree of more than 200 levels (a sum
/// of n terms has n of them), so that no reader of it needs a deep stack.
[[nodiscard]] ExpressionPointer parse_formula(std::string_view text);

/// An interval of reals that a parameter runs through: "(0, 1]", "[1/2, 2)".
struct ParameterRange {
  Rational lower;
  Rational upper;
  bool has_lower = false;  ///< the lower end belongs to it
  bool has_upper = false;
};

/// Reads an interval with rational ends. Throws FormulaError for anything else, and for an empty one.
[[nodiscard]] ParameterRange parse_range(std::string_view text);

}  // namespace delcert
