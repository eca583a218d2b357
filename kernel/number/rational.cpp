#include "kernel/number/rational.hpp"

#include <cmath>
#include <stdexcept>

namespace delcert {

Rational::Rational(const Integer& numerator, const Integer& denominator) {
  if (denominator.is_zero()) throw std::domain_error("rational number with denominator 0");
  value_ = Wrapped(numerator, denominator);
}

Rational Rational::exactly(double value) {
  if (!std::isfinite(value)) throw std::domain_error("rational number from a double that is not finite");
  Rational result;
  mpq_set_d(result.value_.backend().data(), value);
  return result;
}

Rational Rational::power_of_two(long exponent) {
  Rational result(1);
  mpq_ptr raw = result.value_.backend().data();
  if (exponent >= 0) {
    mpq_mul_2exp(raw, raw, static_cast<mp_bitcnt_t>(exponent));
  } else {
    mpq_div_2exp(raw, raw, static_cast<mp_bitcnt_t>(-exponent));
  }
  return result;
}

Rational Rational::divided_by(const Rational& divisor) const {
  if (divisor.value_.is_zero()) throw std::domain_error("rational division by 0");
  return Rational(Wrapped(value_ / divisor.value_));
}

Rational power(const Rational& base, long exponent) {
  if (exponent < 0) return Rational(1) / power(base, -exponent);
  const auto raised = [exponent](const Integer& integer) {
    Integer result;
    mpz_pow_ui(result.backend().data(), integer.backend().data(), static_cast<unsigned long>(exponent));
    return result;
  };
  return Rational(raised(base.numerator()), raised(base.denominator()));
}

Integer floor_of(const Rational& x) {
  Integer result;
  mpz_fdiv_q(result.backend().data(), mpq_numref(x.gmp()), mpq_denref(x.gmp()));
  return result;
}

Integer ceiling_of(const Rational& x) { return -floor_of(-x); }

Rational rounded_down(const Rational& x, long exponent) {
  return Rational(floor_of(x * Rational::power_of_two(-exponent))) * Rational::power_of_two(exponent);
}

Rational rounded_up(const Rational& x, long exponent) { return -rounded_down(-x, exponent); }

long binary_exponent(const Rational& x) {
  const Rational size = absolute(x);
  const auto digits = [](mpz_srcptr integer) { return static_cast<long>(mpz_sizeinbase(integer, 2)); };
  const long guess = digits(mpq_numref(size.gmp())) - digits(mpq_denref(size.gmp()));
  return size < Rational::power_of_two(guess) ? guess - 1 : guess;
}

Rational square_root_lower(const Rational& x, unsigned bits) {
  if (x < Rational(0)) throw std::domain_error("square root of a negative rational");
  if (is_proved(is_zero(x))) return x;
  long exponent = binary_exponent(x) / 2 - static_cast<long>(bits) - 1;
  const Integer scaled = floor_of(x * Rational::power_of_two(-2 * exponent));
  Integer root;
  mpz_sqrt(root.backend().data(), scaled.backend().data());
  return Rational(root) * Rational::power_of_two(exponent);
}

Rational square_root_upper(const Rational& x, unsigned bits) {
  Rational lower = square_root_lower(x, bits);
  if (lower * lower == x) return lower;
  const long exponent = binary_exponent(x) / 2 - static_cast<long>(bits) - 1;
  return lower + Rational::power_of_two(exponent);
}

double approximate_double(const Rational& x) { return mpq_get_d(x.gmp()); }

}  // namespace delcert
