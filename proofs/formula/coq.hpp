#pragma once

#include <map>
#include <optional>
#include <string>

#include "kernel/formula/expression.hpp"

namespace delcert {

/// Terms of Coq that stand for names of a formula.
using CoqNames = std::map<std::string, std::string>;

/// A formula about numbers as a term or a proposition of Coq, in the scope of the real numbers: x^3 with `pow`, x^(3/2)
/// as sqrt x ^ 3, x^e with an exponent that is not constant as Rpower x e (which is what it says for x > 0), log2 x as
/// ln x / ln 2. Names that are not among `names` are printed by `coq_name`.
/// Nothing if it has quantifiers, definitions or functions other than sqrt, abs, min, max and log2, or a constant
/// exponent that is not an integer or half of one. Precondition: type-checked.
[[nodiscard]] std::optional<std::string> coq_of(const Expression& expression, const CoqNames& names = {});

/// A name of a formula as a name of Coq: itself, with an underscore behind what means something else there.
[[nodiscard]] std::string coq_name(const std::string& name);

/// A number in parentheses where needed: 3, (-3), (3 / 4).
[[nodiscard]] std::string coq_number(const Rational& value);

/// The value of a term without names that is a rational number, of + − · / and powers; nothing otherwise.
[[nodiscard]] std::optional<Rational> rational_constant(const Expression& term);

}  // namespace delcert
