#pragma once

#include <boost/multiprecision/gmp.hpp>
#include <compare>
#include <concepts>
#include <cstdint>

#include "kernel/number/verdict.hpp"

namespace delcert {

using Integer = boost::multiprecision::number<boost::multiprecision::gmp_int, boost::multiprecision::et_off>;

/// What GMP's own functions take.
[[nodiscard]] inline mpz_ptr raw(Integer& integer) { return integer.backend().data(); }
[[nodiscard]] inline mpz_srcptr raw(const Integer& integer) { return integer.backend().data(); }

/// An exact rational number: the rung on which every decision about rational quantities ends.
///
/// What GMP does takes longer than a call, so nothing of it is inline: it would be compiled again wherever a template
/// is instantiated for this rung.
class Rational {
 public:
  using Wrapped = boost::multiprecision::number<boost::multiprecision::gmp_rational, boost::multiprecision::et_off>;

  Rational() noexcept;
  template <std::signed_integral T>
  Rational(T integer) : Rational(static_cast<std::int64_t>(integer), Signed{}) {}
  template <std::unsigned_integral T>
  Rational(T integer) : Rational(static_cast<std::uint64_t>(integer), Unsigned{}) {}
  explicit Rational(const Integer& integer);
  explicit Rational(Wrapped value) noexcept;
  /// Throws std::domain_error if the denominator is 0.
  Rational(const Integer& numerator, const Integer& denominator);

  Rational(const Rational& other) noexcept;
  Rational(Rational&& other) noexcept;
  Rational& operator=(const Rational& other) noexcept;
  Rational& operator=(Rational&& other) noexcept;
  ~Rational();

  /// No decimal literal becomes a rational by accident; see `exactly`.
  template <std::floating_point T>
  Rational(T) = delete;

  /// The rational number that the double is. Throws std::domain_error unless finite.
  [[nodiscard]] static Rational exactly(double value);
  /// 2 to the power `exponent`.
  [[nodiscard]] static Rational power_of_two(long exponent);

  [[nodiscard]] Integer numerator() const;
  [[nodiscard]] Integer denominator() const;
  [[nodiscard]] const Wrapped& wrapped() const { return value_; }
  [[nodiscard]] mpq_srcptr gmp() const { return value_.backend().data(); }

  friend Rational operator+(const Rational& a, const Rational& b) noexcept;
  friend Rational operator-(const Rational& a, const Rational& b) noexcept;
  friend Rational operator*(const Rational& a, const Rational& b) noexcept;
  /// Throws std::domain_error if b is 0.
  friend Rational operator/(const Rational& a, const Rational& b);
  friend Rational operator-(const Rational& a) noexcept;
  Rational& operator+=(const Rational& b) noexcept;
  Rational& operator-=(const Rational& b) noexcept;
  Rational& operator*=(const Rational& b) noexcept;
  Rational& operator/=(const Rational& b);

  friend bool operator==(const Rational& a, const Rational& b) noexcept;
  friend std::strong_ordering operator<=>(const Rational& a, const Rational& b) noexcept;

  friend Rational square(const Rational& a) noexcept;
  friend Rational absolute(const Rational& a) noexcept;
  friend Rational minimum(const Rational& a, const Rational& b) noexcept;
  friend Rational maximum(const Rational& a, const Rational& b) noexcept;

  friend Verdict less(const Rational& a, const Rational& b) noexcept;
  friend Verdict less_equal(const Rational& a, const Rational& b) noexcept;
  friend Verdict is_zero(const Rational& a) noexcept;

 private:
  struct Signed {};
  struct Unsigned {};
  Rational(std::int64_t integer, Signed);
  Rational(std::uint64_t integer, Unsigned);
  template <auto operation>
  [[nodiscard]] static Rational combined(const Rational& a, const Rational& b);
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
