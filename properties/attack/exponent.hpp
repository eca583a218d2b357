#pragma once

#include <optional>

#include "kernel/formula/expression.hpp"
#include "proofs/formula/vocabulary.hpp"

namespace delcert {

/// The exponent e of a quantity in a term that is a product of powers: the term is quantity^e times what does not
/// contain it. 0 where the quantity does not occur. Nothing where it occurs in another way: in some of the terms of a
/// sum, in an exponent, in the argument of a function other than sqrt. `integers` has what exponents are made of, such
/// as k and m. Precondition: type-checked, without definitions (`without_definitions`).
[[nodiscard]] std::optional<Rational> exponent_of(const Expression& quantity, const Expression& term,
                                                  const Bindings& integers);

}  // namespace delcert
