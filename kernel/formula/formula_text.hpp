#pragma once

#include <string>

#include "kernel/formula/expression.hpp"

namespace delcert {

/// The text of a tree, with parentheses only where precedence asks for them: `parse_formula` makes the same tree of it.
/// Precondition: literals are integers that are not negative, as the parser makes them.
[[nodiscard]] std::string formula_text(const Expression& expression);

/// Whether two trees are the same but for the places in their texts and what the type check has found.
[[nodiscard]] bool is_same_formula(const Expression& a, const Expression& b);

}  // namespace delcert
