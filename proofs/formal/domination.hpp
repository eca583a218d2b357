#pragma once

#include <optional>
#include <string>

#include "proofs/formal/polynomial_text.hpp"

namespace delcert {

/// A polynomial written as a sum of which one sees that it is not negative: each negative term taken together with
/// positive ones that are at least as large, as x^4 <= x^2·y in the unit square, or x <= x^2 for x >= 1. Few terms
/// whatever the degree, and exact where the terms tie.
///
/// The sum as a term of Coq that the tactic `nonneg` (strict: `positive`) of certificates.v sees through; nothing if
/// the terms cannot be matched so, which does not mean that the polynomial is negative somewhere.
[[nodiscard]] std::optional<std::string> domination(const Polynomial& polynomial, const FormalVariables& variables,
                                                    bool strict);

}  // namespace delcert
