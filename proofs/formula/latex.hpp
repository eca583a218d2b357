#pragma once

#include <string>

#include "kernel/formula/expression.hpp"
#include "proofs/formula/claim.hpp"

namespace delcert {

/// A formula in LaTeX's mathematical mode (amsmath), from the templates of the functions. Quotients are fractions, the
/// exponent 1/2 is a root, a < b and b <= c with the same b is a chain. Precondition: type-checked.
[[nodiscard]] std::string latex_of(const Expression& expression);

/// A step of a proof as LaTeX text (amsmath): for which parameters, with which abbreviations, what holds.
[[nodiscard]] std::string latex_of(const Step& step);

/// A claim as a paragraph of LaTeX text (amsmath): what is given, what follows, the steps of its proof.
[[nodiscard]] std::string latex_of(const Claim& claim);

/// A name of a formula as a symbol: mu0 is \mu_0, xi_tilde is \tilde{\xi}, k is k, and \mathrm{label} is a word.
[[nodiscard]] std::string latex_name(const std::string& name);

}  // namespace delcert
