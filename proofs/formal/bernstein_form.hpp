#pragma once

#include <optional>
#include <string>

#include "proofs/formal/polynomial_text.hpp"

namespace delcert {

/// A polynomial written in products of powers of x − a and b − x for the ends of the ranges (of x − a alone where there
/// is no upper end), with the coefficients of Bernstein's basis: a term of Coq that the tactic `nonneg` (strict:
/// `positive`) of certificates.v sees through.
///
/// Nothing if a coefficient is negative, if a variable without ends occurs, if there are more than 4000 terms, or if
/// strictness does not show.
[[nodiscard]] std::optional<std::string> bernstein_form(const Polynomial& polynomial, const FormalVariables& variables,
                                                        bool strict);

}  // namespace delcert
