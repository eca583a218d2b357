#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>

#include "proofs/formal/formal_parameters.hpp"

namespace delcert {

/// What is known about proving a comparison of two terms.
struct ComparisonScript {
  /// Tactics of Coq that prove it, for all parameters; nothing if no certificate was found.
  std::optional<std::string> tactics;
  /// Parameters that should be squares of their variables for roots to become polynomials; then ask again.
  std::set<std::size_t> wanted_squares;
};

/// A polynomial that is known not to be negative: tactics that prove 0 <= P (strict: 0 < P), where P is the polynomial
/// as `polynomial_text` prints it.
struct KnownSign {
  bool strict = false;
  std::string script;
};

/// By `Polynomial::text`.
using KnownSigns = std::map<std::string, KnownSign>;

/// A certificate for a comparison: the difference of its sides as a quotient of products of polynomials, and for each
/// of these a sum of which the sign is seen (`sign_script`), or that is known. Roots and powers with symbolic exponents
/// are replaced first. Precondition: a comparison; `parameters` are all its names.
[[nodiscard]] ComparisonScript comparison_script(const ExpressionPointer& comparison,
                                                 const FormalParameters& parameters, const KnownSigns& known = {});

}  // namespace delcert
