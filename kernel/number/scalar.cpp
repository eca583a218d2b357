#include "kernel/number/scalar.hpp"

#include <mpfr.h>

#include <cmath>
#include <optional>

namespace delcert {

namespace {

/// The tightest enclosure of a dyadic number by its leading 53 binary digits, many times faster than by division.
/// Nothing for other numbers and near the ends of the doubles' range.
std::optional<Interval> dyadic_enclosure(mpq_srcptr x) {
  constexpr long safe_exponent = 1000;
  constexpr std::size_t digits = 53;
  mpz_srcptr numerator = mpq_numref(x);
  mpz_srcptr denominator = mpq_denref(x);
  if (mpz_sgn(numerator) == 0) return Interval(0);
  const mp_bitcnt_t shift = mpz_sizeinbase(denominator, 2) - 1;
  if (mpz_scan1(denominator, 0) != shift) return std::nullopt;
  long exponent = 0;
  const double leading = mpz_get_d_2exp(&exponent, numerator);  // cut off towards 0, of size in [1/2, 1)
  exponent -= static_cast<long>(shift);
  if (exponent < -safe_exponent || exponent > safe_exponent) return std::nullopt;
  const double nearer = std::ldexp(leading, static_cast<int>(exponent));
  if (mpz_sizeinbase(numerator, 2) - mpz_scan1(numerator, 0) <= digits) return Interval::exactly(nearer);
  // One unit in the last place more, exactly.
  const double farther = std::ldexp(leading + std::copysign(0x1p-53, leading), static_cast<int>(exponent));
  return leading > 0 ? Interval::between(nearer, farther) : Interval::between(farther, nearer);
}

double rounded(const Rational& x, mpfr_rnd_t direction) {
  mpfr_t value;
  mpfr_init2(value, 53);
  mpfr_set_q(value, x.gmp(), direction);
  const double result = mpfr_get_d(value, direction);
  mpfr_clear(value);
  return result;
}

}  // namespace

template <>
Interval scalar_from<Interval>(const Rational& x) {
  if (const auto enclosure = dyadic_enclosure(x.gmp())) return *enclosure;
  return Interval::between(rounded(x, MPFR_RNDD), rounded(x, MPFR_RNDU));
}

template <>
BigInterval scalar_from<BigInterval>(const Rational& x) {
  return BigInterval(x);
}

}  // namespace delcert
