#pragma once

#include <optional>
#include <string>

#include "proofs/formal/polynomial_text.hpp"

namespace delcert {

/// Tactics of Coq that prove the goal 0 <= P (strict: 0 < P), where P is the polynomial as `polynomial_text` prints it:
/// by `domination`, by `bernstein_form`, or by cutting the range of a variable in two, up to 32 parts.
/// Nothing if none is found.
[[nodiscard]] std::optional<std::string> sign_script(const Polynomial& polynomial, const FormalVariables& variables,
                                                     bool strict);

/// The sign of the polynomial at some point inside the ranges: −1, 0 or 1, a guess of its sign everywhere.
[[nodiscard]] int sign_at_some_point(const Polynomial& polynomial, const FormalVariables& variables);

}  // namespace delcert
