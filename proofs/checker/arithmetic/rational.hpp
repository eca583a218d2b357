#pragma once

#include <flint/fmpq.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "proofs/checker/arithmetic/interval.hpp"

namespace delcert::checker {

/// An exact rational number (FLINT's fmpq, on GMP).
class Rational {
 public:
  Rational() { fmpq_init(value_); }
  explicit Rational(int value) : Rational() { fmpq_set_si(value_, value, 1); }
  Rational(const Rational& other) : Rational() { fmpq_set(value_, other.value_); }
  Rational(Rational&& other) noexcept : Rational() { fmpq_swap(value_, other.value_); }
  Rational& operator=(Rational other) noexcept {
    fmpq_swap(value_, other.value_);
    return *this;
  }
  ~Rational() { fmpq_clear(value_); }

  fmpq* raw() { return value_; }
  const fmpq* raw() const { return value_; }
  int sign() const { return fmpq_sgn(value_); }

  friend Rational operator+(const Rational& a, const Rational& b) { return apply(fmpq_add, a, b); }
  friend Rational operator-(const Rational& a, const Rational& b) { return apply(fmpq_sub, a, b); }
  friend Rational operator*(const Rational& a, const Rational& b) { return apply(fmpq_mul, a, b); }
  /// Precondition: b is not 0.
  friend Rational operator/(const Rational& a, const Rational& b) { return apply(fmpq_div, a, b); }
  friend Rational operator-(const Rational& a) { return Rational(0) - a; }
  friend Rational square(const Rational& a) { return a * a; }
  friend Rational maximum(const Rational& a, const Rational& b) { return fmpq_cmp(a.value_, b.value_) < 0 ? b : a; }
  /// Precondition: exponent >= 0.
  friend Rational power(const Rational& a, int exponent) {
    Rational result;
    fmpq_pow_si(result.value_, a.value_, exponent);
    return result;
  }
  friend bool operator==(const Rational& a, const Rational& b) { return fmpq_equal(a.value_, b.value_) != 0; }
  friend Verdict less(const Rational& a, const Rational& b) { return verdict(fmpq_cmp(a.value_, b.value_) < 0); }

 private:
  static Rational apply(void (*operation)(fmpq*, const fmpq*, const fmpq*), const Rational& a, const Rational& b) {
    Rational result;
    operation(result.value_, a.value_, b.value_);
    return result;
  }
  fmpq_t value_;
};

/// An enclosure of x with relative width at most 2^-51. Precondition: the thread rounds upwards.
inline Interval enclosure(const Rational& x) {
  if (x.sign() == 0) return Interval(0);
  if (x.sign() < 0) return -enclosure(-x);
  // t = floor(x 2^shift) has 52 or 53 binary digits, so that t and t + 1 are doubles.
  const auto shift =
      52 - static_cast<slong>(fmpz_bits(fmpq_numref(x.raw()))) + static_cast<slong>(fmpz_bits(fmpq_denref(x.raw())));
  fmpz_t floor, remainder, numerator, denominator;
  for (fmpz* z : {floor, remainder, numerator, denominator}) fmpz_init(z);
  fmpz_mul_2exp(numerator, fmpq_numref(x.raw()), shift > 0 ? static_cast<ulong>(shift) : 0);
  fmpz_mul_2exp(denominator, fmpq_denref(x.raw()), shift < 0 ? static_cast<ulong>(-shift) : 0);
  fmpz_fdiv_qr(floor, remainder, numerator, denominator);
  const double lower = static_cast<double>(fmpz_get_si(floor));
  const double upper = lower + (fmpz_is_zero(remainder) ? 0 : 1);
  for (fmpz* z : {floor, remainder, numerator, denominator}) fmpz_clear(z);
  // Scaling is exact, or it under- or overflows and rounds upwards.
  const auto exponent = static_cast<int>(std::clamp<slong>(-shift, -10000, 10000));
  return Interval::between(-std::ldexp(-lower, exponent), std::ldexp(upper, exponent));
}

}  // namespace delcert::checker
