#pragma once

#include <map>
#include <string>

#include "kernel/formula/expression.hpp"

namespace delcert {

using Replacements = std::map<std::string, ExpressionPointer>;

/// The formula with terms in the place of names; what a quantifier binds is left alone.
/// Precondition: type-checked, and no term has a name that a quantifier around the place binds.
[[nodiscard]] ExpressionPointer replaced(const ExpressionPointer& formula, const Replacements& replacements);

/// The formula with the bodies of definitions, such as constant_c(m, mu0), in the place of their calls.
[[nodiscard]] ExpressionPointer without_definitions(const ExpressionPointer& formula);

/// The statement with a term taken off both sides of all comparisons. Precondition: type-checked.
[[nodiscard]] ExpressionPointer less_base(const ExpressionPointer& statement, const ExpressionPointer& base);

/// The term that is this number, as the parser would make it: −3/4 is −(3/4), literals are integers from 0 on.
[[nodiscard]] ExpressionPointer number_expression(const Rational& value);

}  // namespace delcert
