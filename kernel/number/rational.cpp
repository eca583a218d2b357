#include "kernel/number/rational.hpp"

#include <cmath>
#include <stdexcept>
#include <utility>

#include "kernel/number/dyadic_arithmetic.hpp"

namespace delcert {

Rational::Rational() noexcept = default;
Rational::Rational(const Rational& other) noexcept = default;
Rational::Rational(Rational&& other) noexcept = default;
Rational& Rational::operator=(const Rational& other) noexcept = default;
Rational& Rational::operator=(Rational&& other) noexcept = default;
Rational::~Rational() = default;

Rational::Rational(std::int64_t integer, Signed) : value_(integer) {}
Rational::Rational(std::uint64_t integer, Unsigned) : value_(integer) {}
Rational::Rational(const Integer& integer) : value_(integer) {}

Rational::Rational(Wrapped value) noexcept : value_(std::move(value)) {}

Rational::Rational(const Integer& numerator, const Integer& denominator) {
  if (denominator.is_zero()) throw std::domain_error("rational number with denominator 0");
  value_ = Wrapped(numerator, denominator);
}

Integer Rational::numerator() const { return boost::multiprecision::numerator(value_); }
Integer Rational::denominator() const { return boost::multiprecision::denominator(value_); }

template <auto operation>
Rational Rational::combined(const Rational& a, const Rational& b) {
  Rational result;
  operation(result.value_.backend().data(), a.gmp(), b.gmp());
  return result;
}

Rational operator+(const Rational& a, const Rational& b) noexcept { return Rational::combined<add_exactly>(a, b); }
Rational operator-(const Rational& a, const Rational& b) noexcept { return Rational::combined<subtract_exactly>(a, b); }
Rational operator*(const Rational& a, const Rational& b) noexcept { return Rational::combined<multiply_exactly>(a, b); }

Rational operator/(const Rational& a, const Rational& b) {
  if (b.value_.is_zero()) throw std::domain_error("rational division by 0");
  return Rational(Rational::Wrapped(a.value_ / b.value_));
}

Rational operator-(const Rational& a) noexcept { return Rational(Rational::Wrapped(-a.value_)); }

Rational& Rational::operator+=(const Rational& b) noexcept { return *this = *this + b; }
Rational& Rational::operator-=(const Rational& b) noexcept { return *this = *this - b; }
Rational& Rational::operator*=(const Rational& b) noexcept { return *this = *this * b; }
Rational& Rational::operator/=(const Rational& b) { return *this = *this / b; }

bool operator==(const Rational& a, const Rational& b) noexcept { return a.value_ == b.value_; }
std::strong_ordering operator<=>(const Rational& a, const Rational& b) noexcept {
  return a.value_.compare(b.value_) <=> 0;
}

Rational square(const Rational& a) noexcept { return a * a; }
Rational absolute(const Rational& a) noexcept { return a < Rational(0) ? -a : a; }
Rational minimum(const Rational& a, const Rational& b) noexcept { return b < a ? b : a; }
Rational maximum(const Rational& a, const Rational& b) noexcept { return a < b ? b : a; }

Verdict less(const Rational& a, const Rational& b) noexcept { return verdict_of(a < b); }
Verdict less_equal(const Rational& a, const Rational& b) noexcept { return verdict_of(a <= b); }
Verdict is_zero(const Rational& a) noexcept { return verdict_of(a.value_.is_zero()); }

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
