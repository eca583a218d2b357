#pragma once

#include <compare>
#include <map>
#include <string>

#include "kernel/number/big_interval.hpp"
#include "kernel/number/rational.hpp"

namespace delcert {

/// Rational numbers between which a real number lies; equal where it is known exactly.
struct Bounds {
  Rational lower;
  Rational upper;
};

/// An exact positive number whose square is rational, as a product of powers: integers >= 2, each to an integer or
/// half-integer power. The constants of the paper are of this form, and many lie beyond every double.
class PowerProduct {
 public:
  /// The number 1.
  PowerProduct() = default;
  /// Throws std::domain_error unless x > 0.
  explicit PowerProduct(const Rational& x);
  /// Throws std::domain_error unless x > 0.
  [[nodiscard]] static PowerProduct square_root_of(const Rational& x);

  friend PowerProduct operator*(const PowerProduct& a, const PowerProduct& b);
  friend PowerProduct operator/(const PowerProduct& a, const PowerProduct& b) { return a * power(b, -1); }
  friend PowerProduct power(const PowerProduct& base, long exponent);

  friend bool operator==(const PowerProduct& a, const PowerProduct& b) { return (a <=> b) == 0; }
  /// Exact: by logarithms where they differ by more than their error, by the expanded squares otherwise.
  friend std::strong_ordering operator<=>(const PowerProduct& a, const PowerProduct& b);

  /// The square, expanded.
  [[nodiscard]] Rational squared() const;
  [[nodiscard]] bool is_rational() const;
  /// The number, expanded. Throws std::domain_error unless is_rational().
  [[nodiscard]] Rational rational() const;
  /// An enclosure at the current precision of BigInterval; its relative width is at most the number of factors,
  /// counted with multiplicity, times a few units of the last place.
  [[nodiscard]] BigInterval enclosure() const;
  /// The same as rational bounds, from a precision of 256 bits.
  [[nodiscard]] Bounds bounds() const;
  /// Bounds of the binary logarithm whose distance is at most 2^-240 times the number of factors, counted with
  /// multiplicity, times the binary length of the longest. Equal for a power of 2.
  [[nodiscard]] Bounds log2() const;

  /// For example "2^(-151/2)·3^5"; "1" for the empty product.
  [[nodiscard]] std::string text() const;
  /// The same in LaTeX's math mode, for example "2^{-151/2} \cdot 3^{5}".
  [[nodiscard]] std::string latex() const;

 private:
  void multiply_by(const Integer& base, long half_exponent);
  void multiply_by_factors_of(Integer positive, long half_exponent);

  /// Base -> twice its exponent, never 0. Primes up to 2^16; whatever has no such factor stays whole, though never a
  /// perfect power.
  std::map<Integer, long> half_exponents_;
};

}  // namespace delcert
