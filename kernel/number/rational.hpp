#pragma once

#include <boost/multiprecision/gmp.hpp>
#include <compare>
#include <concepts>
#include <utility>

#include "kernel/number/dyadic_arithmetic.hpp"
#include "kernel/number/verdict.hpp"

namespace delcert {

using Integer = boost::multiprecision::number<boost::multiprecision::gmp_int, boost::multiprecision::et_off>;

/// What GMP's own functions take.
[[nodiscard]] inline mpz_ptr raw(Integer& integer) { return integer.backend().data(); }
[[nodiscard]] inline mpz_srcptr raw(const Integer& integer) { return integer.backend().data(); }

/// An exact rational number: the rung on which every decision about rational quantities ends.
class Rational {
 public:
  using Wrapped = boost::multiprecision::number<boost::multiprecision::gmp_rational, boost::multiprecision::et_off>;

  Rational() = default;
  template <std::integral T>
  Rational(T integer) : value_(integer) {}
  explicit Rational(const Integer& integer) : value_(integer) {}
  explicit Rational(Wrapped value) : value_(std::move(value)) {}
  /// Throws std::domain_error if the denominator is 0.
  Rational(const Integer& numerator, const Integer& denominator);

  /// No decimal literal becomes a rational by accident; see `exactly`.
  template <std::floating_point T>
  Rational(T) = delete;

  /// The rational number that the double is. Throws std::domain_error unless finite.
  [[nodiscard]] static Rational exactly(double value);
  /// 2 to the power `exponent`.
  [[nodiscard]] static Rational power_of_two(long exponent);

  [[nodiscard]] Integer numerator() const { return boost::multiprecision::numerator(value_); }
  [[nodiscard]] Integer denominator() const { return boost::multiprecision::denominator(value_); }
  [[nodiscard]] const Wrapped& wrapped() const { return value_; }
  [[nodiscard]] mpq_srcptr gmp() const { return value_.backend().data(); }

  friend Rational operator+(const Rational& a, const Rational& b) { return a.combined<add_exactly>(b); }
  friend Rational operator-(const Rational& a, const Rational& b) { return a.combined<subtract_exactly>(b); }
  friend Rational operator*(const Rational& a, const Rational& b) { return a.combined<multiply_exactly>(b); }
  /// Throws std::domain_error if b is 0.
  friend Rational operator/(const Rational& a, const Rational& b) { return a.divided_by(b); }
  friend Rational operator-(const Rational& a) { return Rational(Wrapped(-a.value_)); }
  Rational& operator+=(const Rational& b) { return *this = *this + b; }
  Rational& operator-=(const Rational& b) { return *this = *this - b; }
  Rational& operator*=(const Rational& b) { return *this = *this * b; }
  Rational& operator/=(const Rational& b) { return *this = *this / b; }

  friend bool operator==(const Rational& a, const Rational& b) { return a.value_ == b.value_; }
  friend std::strong_ordering operator<=>(const Rational& a, const Rational& b) {
    return a.value_.compare(b.value_) <=> 0;
  }

  friend Rational square(const Rational& a) { return a * a; }
  friend Rational absolute(const Rational& a) { return a < Rational(0) ? -a : a; }
  friend Rational minimum(const Rational& a, const Rational& b) { return b < a ? b : a; }
  friend Rational maximum(const Rational& a, const Rational& b) { return a < b ? b : a; }

  friend Verdict less(const Rational& a, const Rational& b) { return verdict_of(a < b); }
  friend Verdict less_equal(const Rational& a, const Rational& b) { return verdict_of(a <= b); }
  friend Verdict is_zero(const Rational& a) { return verdict_of(a.value_.is_zero()); }

 private:
  template <auto operation>
  [[nodiscard]] Rational combined(const Rational& other) const {
    Rational result;
    operation(result.value_.backend().data(), gmp(), other.gmp());
    return result;
  }
  [[nodiscard]] Rational divided_by(const Rational& divisor) const;
  Wrapped value_;
};

/// base^exponent; throws std::domain_error for 0 to a negative power.
[[nodiscard]] Rational power(const Rational& base, long exponent);
/// The largest integer not above x.
[[nodiscard]] Integer floor_of(const Rational& x);
/// The smallest integer not below x.
[[nodiscard]] Integer ceiling_of(const Rational& x);
/// The largest multiple of 2^exponent not above x, and the smallest not below.
[[nodiscard]] Rational rounded_down(const Rational& x, long exponent);
[[nodiscard]] Rational rounded_up(const Rational& x, long exponent);
/// The exponent e with 2^e <= |x| < 2^(e+1). Precondition: x is not 0.
[[nodiscard]] long binary_exponent(const Rational& x);
/// Bounds of the square root of x >= 0 with at least `bits` correct binary digits: lower^2 <= x <= upper^2.
[[nodiscard]] Rational square_root_lower(const Rational& x, unsigned bits);
[[nodiscard]] Rational square_root_upper(const Rational& x, unsigned bits);
/// Nearest double to x or one next to it, without error bounds.
[[nodiscard]] double approximate_double(const Rational& x);

}  // namespace delcert
