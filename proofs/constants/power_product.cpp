#include "proofs/constants/power_product.hpp"

#include <mpfr.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace delcert {

namespace {

Integer integer_power(const Integer& base, unsigned long exponent) {
  Integer result;
  mpz_pow_ui(result.backend().data(), base.backend().data(), exponent);
  return result;
}

/// Writes a number without small factors as root^exponent with the largest possible exponent.
std::pair<Integer, long> as_perfect_power(const Integer& number) {
  const auto digits = static_cast<long>(mpz_sizeinbase(number.backend().data(), 2));
  // Every prime factor exceeds 2^16.
  for (long exponent = digits / 16; exponent > 1; --exponent) {
    Integer root;
    if (mpz_root(root.backend().data(), number.backend().data(), static_cast<unsigned long>(exponent)) != 0)
      return {root, exponent};
  }
  return {number, 1};
}

Rational log2_of(const Integer& base, mpfr_rnd_t direction) {
  const auto length = static_cast<mpfr_prec_t>(mpz_sizeinbase(base.backend().data(), 2));
  mpfr_t argument;
  mpfr_t logarithm;
  mpfr_init2(argument, std::max<mpfr_prec_t>(length, MPFR_PREC_MIN));
  mpfr_init2(logarithm, 256);
  mpfr_set_z(argument, base.backend().data(), direction);
  mpfr_log2(logarithm, argument, direction);
  Rational::Wrapped result;
  mpfr_get_q(result.backend().data(), logarithm);
  mpfr_clear(argument);
  mpfr_clear(logarithm);
  return Rational(std::move(result));
}

BigInterval interval_power(const Integer& base, unsigned long exponent) {
  BigInterval result(1);
  BigInterval square_of_base{Rational(base)};
  for (; exponent != 0; exponent /= 2) {
    if (exponent % 2 == 1) result *= square_of_base;
    square_of_base = square(square_of_base);
  }
  return result;
}

Rational product_of(const std::map<Integer, long>& exponents) {
  Integer numerator(1);
  Integer denominator(1);
  for (const auto& [base, exponent] : exponents) {
    if (exponent > 0) numerator *= integer_power(base, static_cast<unsigned long>(exponent));
    if (exponent < 0) denominator *= integer_power(base, static_cast<unsigned long>(-exponent));
  }
  return {numerator, denominator};
}

/// The exponent half/2 in the notation of PowerProduct::text and latex; empty for 1.
std::string exponent_text(long half, bool latex) {
  if (half == 2) return "";
  const bool whole = half % 2 == 0;
  const std::string number = whole ? std::to_string(half / 2) : std::to_string(half) + "/2";
  if (latex) return "^{" + number + "}";
  return half < 0 || !whole ? "^(" + number + ")" : "^" + number;
}

std::string joined_text(const std::map<Integer, long>& half_exponents, bool latex) {
  std::string result;
  for (const auto& [base, half] : half_exponents) {
    if (!result.empty()) result += latex ? " \\cdot " : "·";
    result += base.str() + exponent_text(half, latex);
  }
  return result.empty() ? "1" : result;
}

void require_positive(const Rational& x) {
  if (x <= Rational(0)) throw std::domain_error("product of powers from a number that is not positive");
}

}  // namespace

PowerProduct::PowerProduct(const Rational& x) {
  require_positive(x);
  multiply_by_factors_of(x.numerator(), 2);
  multiply_by_factors_of(x.denominator(), -2);
}

PowerProduct PowerProduct::square_root_of(const Rational& x) {
  require_positive(x);
  PowerProduct result;
  result.multiply_by_factors_of(x.numerator(), 1);
  result.multiply_by_factors_of(x.denominator(), -1);
  return result;
}

void PowerProduct::multiply_by(const Integer& base, long half_exponent) {
  const auto position = half_exponents_.try_emplace(base, 0).first;
  position->second += half_exponent;
  if (position->second == 0) half_exponents_.erase(position);
}

void PowerProduct::multiply_by_factors_of(Integer positive, long half_exponent) {
  constexpr unsigned long largest_divisor = 1UL << 16;
  for (unsigned long divisor = 2; divisor <= largest_divisor && positive > 1; divisor += divisor == 2 ? 1 : 2) {
    const Integer prime(divisor);
    const auto multiplicity = mpz_remove(positive.backend().data(), positive.backend().data(), prime.backend().data());
    if (multiplicity != 0) multiply_by(prime, half_exponent * static_cast<long>(multiplicity));
  }
  if (positive == 1) return;
  const auto [root, exponent] = as_perfect_power(positive);
  multiply_by(root, half_exponent * exponent);
}

PowerProduct operator*(const PowerProduct& a, const PowerProduct& b) {
  PowerProduct result = a;
  for (const auto& [base, half] : b.half_exponents_) result.multiply_by(base, half);
  return result;
}

PowerProduct power(const PowerProduct& base, long exponent) {
  if (exponent == 0) return {};
  PowerProduct result = base;
  for (auto& factor : result.half_exponents_) factor.second *= exponent;
  return result;
}

std::strong_ordering operator<=>(const PowerProduct& a, const PowerProduct& b) {
  const PowerProduct ratio = a / b;
  if (ratio.half_exponents_.empty()) return std::strong_ordering::equal;
  const Bounds logarithm = ratio.log2();
  if (logarithm.lower > Rational(0)) return std::strong_ordering::greater;
  if (logarithm.upper < Rational(0)) return std::strong_ordering::less;
  return ratio.squared() <=> Rational(1);
}

Rational PowerProduct::squared() const { return product_of(half_exponents_); }

bool PowerProduct::is_rational() const {
  std::map<Integer, long> odd_part;
  for (const auto& [base, half] : half_exponents_)
    if (half % 2 != 0) odd_part.emplace(base, half > 0 ? 1 : -1);
  const Rational square = product_of(odd_part);
  return mpz_perfect_square_p(mpq_numref(square.gmp())) != 0 && mpz_perfect_square_p(mpq_denref(square.gmp())) != 0;
}

Rational PowerProduct::rational() const {
  if (!is_rational()) throw std::domain_error(text() + " is not rational");
  const Rational square = squared();
  Integer numerator;
  Integer denominator;
  mpz_sqrt(numerator.backend().data(), mpq_numref(square.gmp()));
  mpz_sqrt(denominator.backend().data(), mpq_denref(square.gmp()));
  return {numerator, denominator};
}

BigInterval PowerProduct::enclosure() const {
  BigInterval numerator(1);
  BigInterval denominator(1);
  for (const auto& [base, half] : half_exponents_) {
    BigInterval& side = half > 0 ? numerator : denominator;
    const auto size = static_cast<unsigned long>(half > 0 ? half : -half);
    side *= interval_power(base, size / 2);
    if (size % 2 == 1) side *= square_root(BigInterval(Rational(base)));
  }
  return numerator / denominator;
}

Bounds PowerProduct::bounds() const {
  const BigInterval::Precision precision(PrecisionBits{256});
  const BigInterval value = enclosure();
  return {value.lower(), value.upper()};
}

Bounds PowerProduct::log2() const {
  Bounds result{Rational(0), Rational(0)};
  for (const auto& [base, half] : half_exponents_) {
    const Rational exponent = Rational(half) / Rational(2);
    result.lower += exponent * log2_of(base, half > 0 ? MPFR_RNDD : MPFR_RNDU);
    result.upper += exponent * log2_of(base, half > 0 ? MPFR_RNDU : MPFR_RNDD);
  }
  return result;
}

std::string PowerProduct::text() const { return joined_text(half_exponents_, false); }

std::string PowerProduct::latex() const { return joined_text(half_exponents_, true); }

}  // namespace delcert
