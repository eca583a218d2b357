#pragma once

#include <string>

#include "proofs/checker/arithmetic/rational.hpp"

namespace delcert::checker {

// Bounds as they are printed: six significant digits, as of printf's %g, on the safe side of the exact number.

/// A decimal number that is at most x, for lower bounds; x itself if six digits are enough.
std::string rounded_down(const Rational& x);
/// A decimal number that is at least x, for upper bounds.
std::string rounded_up(const Rational& x);

}  // namespace delcert::checker
