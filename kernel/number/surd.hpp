#pragma once

#include <concepts>
#include <optional>

#include "kernel/number/scalar.hpp"

namespace delcert {

/// A number factor·√radicand, exactly: what lengths are when their squares are rational. The rung on which comparisons
/// of products, quotients and commensurable sums of such lengths end without algebraic numbers.
///
/// Products, quotients and squares are always there; a sum only if the two roots are commensurable, a root only of a
/// rational number. Where there is no value the result is `unknown()`, which spreads, and every verdict about it is
/// undecided.
class Surd {
 public:
  Surd() : Surd(0) {}
  Surd(int integer) : factor_(integer) {}
  explicit Surd(Rational rational) : factor_(std::move(rational)) {}

  template <std::floating_point T>
  Surd(T) = delete;

  [[nodiscard]] static Surd unknown();
  [[nodiscard]] bool is_known() const { return known_; }
  /// The number if it is known and its root was found to be rational.
  [[nodiscard]] std::optional<Rational> rational() const;

  friend Surd operator+(const Surd& a, const Surd& b);
  friend Surd operator-(const Surd& a, const Surd& b) { return a + (-b); }
  friend Surd operator*(const Surd& a, const Surd& b);
  /// Unknown if b is 0.
  friend Surd operator/(const Surd& a, const Surd& b);
  friend Surd operator-(const Surd& a);
  Surd& operator+=(const Surd& b) { return *this = *this + b; }
  Surd& operator-=(const Surd& b) { return *this = *this - b; }
  Surd& operator*=(const Surd& b) { return *this = *this * b; }

  friend Surd square(const Surd& a);
  /// Unknown for a negative number too.
  friend Surd square_root(const Surd& a);
  friend Surd absolute(const Surd& a);
  friend Surd minimum(const Surd& a, const Surd& b);
  friend Surd maximum(const Surd& a, const Surd& b);

  friend Verdict less(const Surd& a, const Surd& b);
  friend Verdict less_equal(const Surd& a, const Surd& b) { return negation(less(b, a)); }
  friend Verdict is_zero(const Surd& a);

 private:
  Surd(Rational factor, Rational radicand) : factor_(std::move(factor)), radicand_(std::move(radicand)) {}
  [[nodiscard]] bool is_rational() const { return known_ && radicand_ == Rational(1); }

  bool known_ = true;
  Rational factor_;
  Rational radicand_ = Rational(1);  ///< above 0; 1 if the number is known to be rational
};

template <>
[[nodiscard]] inline Surd scalar_from<Surd>(const Rational& x) {
  return Surd(x);
}

}  // namespace delcert
