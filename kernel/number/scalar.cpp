#include "kernel/number/scalar.hpp"

#include <mpfr.h>

#include <bit>
#include <cstdint>
#include <optional>

namespace delcert {

namespace {

constexpr int digits = 53;
static_assert(GMP_NUMB_BITS == 64);

/// The leading 64 binary digits of an integer that is not 0, the first of them 1.
std::uint64_t leading_digits(mpz_srcptr integer) {
  const std::size_t size = mpz_size(integer);
  const std::uint64_t top = mpz_getlimbn(integer, static_cast<mp_size_t>(size) - 1);
  const int missing = std::countl_zero(top);
  if (missing == 0 || size == 1) return top << missing;
  return top << missing | mpz_getlimbn(integer, static_cast<mp_size_t>(size) - 2) >> (64 - missing);
}

/// The tightest enclosure of a dyadic number by its leading 53 binary digits, many times faster than by division.
/// Nothing for other numbers and near the ends of the doubles' range.
std::optional<Interval> dyadic_enclosure(mpq_srcptr x) {
  constexpr long safe_exponent = 1000 - digits;
  constexpr int spare_digits = 64 - digits;
  constexpr long exponent_bias = 1023;
  mpz_srcptr numerator = mpq_numref(x);
  mpz_srcptr denominator = mpq_denref(x);
  if (mpz_sgn(numerator) == 0) return Interval(0);
  const auto shift = static_cast<long>(mpz_sizeinbase(denominator, 2)) - 1;
  if (mpz_scan1(denominator, 0) != static_cast<mp_bitcnt_t>(shift)) return std::nullopt;
  const auto length = static_cast<long>(mpz_sizeinbase(numerator, 2));
  const long exponent = length - digits - shift;
  if (exponent < -safe_exponent || exponent > safe_exponent) return std::nullopt;
  // Nothing below is rounded: both factors of a product are doubles, and the first has 53 digits at most.
  const auto unit = std::bit_cast<double>(static_cast<std::uint64_t>(exponent_bias + exponent) << (digits - 1));
  const std::uint64_t window = leading_digits(numerator);
  const std::uint64_t leading = window >> spare_digits;
  const double nearer = static_cast<double>(leading) * unit;
  const bool is_cut_off = window << digits != 0 || static_cast<long>(mpz_scan1(numerator, 0)) < length - digits;
  const double farther = is_cut_off ? static_cast<double>(leading + 1) * unit : nearer;
  return mpz_sgn(numerator) > 0 ? Interval::between(nearer, farther) : Interval::between(-farther, -nearer);
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
