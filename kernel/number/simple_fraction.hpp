#pragma once

#include "kernel/number/rational.hpp"

namespace delcert {

/// A fraction that people can read, in [x − x/64, x): the one with the least denominator. For advice: a decimal would
/// be refused as input, and may be above x. Precondition: x > 0.
[[nodiscard]] Rational simple_fraction_below(const Rational& x);
/// x itself if its denominator is no larger than that of the fraction below it, which it is otherwise.
[[nodiscard]] Rational simple_fraction_at_most(const Rational& x);

}  // namespace delcert
