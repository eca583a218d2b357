#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "kernel/formula/expression.hpp"

namespace delcert {

/// The functions that a plain formula can name: sqrt, exp, sin, cos.
[[nodiscard]] const std::vector<std::string_view>& functions_of_plain_formulas();

/// Whether a variable may have this name: `[a-z][a-z0-9_]*`, at most 16 characters, no function's name and no word of
/// the language.
[[nodiscard]] bool is_name_of_variable(std::string_view name);

/// The greatest exponent that a plain formula may have.
inline constexpr unsigned greatest_exponent = 100;

/// Whether a formula can name abs() too: only readers who take formulas apart into pieces know it.
enum class AbsoluteValues : unsigned char { refused, allowed };

/// Reads a real function of the variables: whole numbers, + − * /, ^ with a whole number from 0 to 100, sqrt(), exp(),
/// sin(), cos(). Throws FormulaError for everything else that the language knows: an unknown name, a comparison, a
/// quantifier, another exponent (a^b^c has one).
[[nodiscard]] ExpressionPointer parse_plain_formula(std::string_view text, const std::vector<std::string>& variables,
                                                    AbsoluteValues absolute_values = AbsoluteValues::refused);

/// Whether abs() occurs in it. Precondition: it has come from `parse_plain_formula`.
[[nodiscard]] bool has_absolute_values(const Expression& formula);

/// Its text without blanks, with parentheses only where precedence asks for them: the one of certificates.
[[nodiscard]] std::string canonical_text(const Expression& formula);

}  // namespace delcert
