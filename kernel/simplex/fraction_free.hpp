#pragma once

#include "kernel/number/rational.hpp"

namespace delcert {

/// Fractions as integers over one denominator, so that nothing is reduced between operations.

/// `denominator` becomes a multiple of that of x, too: the least one.
inline void include_denominator(Integer& denominator, const Rational& x) {
  if (mpz_divisible_p(raw(denominator), mpq_denref(x.gmp())) != 0) return;
  mpz_lcm(raw(denominator), raw(denominator), mpq_denref(x.gmp()));
}

/// x times the denominator. Precondition: this is a multiple of the denominator of x.
[[nodiscard]] inline Integer whole_multiple(const Rational& x, const Integer& denominator) {
  Integer result;
  mpz_divexact(raw(result), raw(denominator), mpq_denref(x.gmp()));
  mpz_mul(raw(result), raw(result), mpq_numref(x.gmp()));
  return result;
}

/// A step of Bareiss' elimination: `value` becomes (pivot·value − a·b)/divisor. Precondition: this is an integer.
inline void eliminate(Integer& value, const Integer& pivot, const Integer& a, const Integer& b,
                      const Integer& divisor) {
  mpz_mul(raw(value), raw(value), raw(pivot));
  mpz_submul(raw(value), raw(a), raw(b));
  if (mpz_cmp_ui(raw(divisor), 1) != 0) mpz_divexact(raw(value), raw(value), raw(divisor));
}

}  // namespace delcert
