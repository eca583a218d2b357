#pragma once

#include <mpfi.h>

#include <boost/multiprecision/mpfi.hpp>
#include <concepts>
#include <utility>

#include "kernel/number/rational.hpp"
#include "kernel/number/strong.hpp"
#include "kernel/number/verdict.hpp"

namespace delcert {

/// An interval with MPFR endpoints, rounded outwards by MPFI: the second rung. The precision is that of the
/// innermost `BigInterval::Precision` alive, 128 bits if there is none. No rounding guard is needed.
class BigInterval {
 public:
  using Wrapped =
      boost::multiprecision::number<boost::multiprecision::mpfi_float_backend<0>, boost::multiprecision::et_off>;

  /// Sets the working precision while it lives, at least `bits` binary digits.
  class Precision {
   public:
    explicit Precision(PrecisionBits bits);
    ~Precision();
    Precision(const Precision&) = delete;
    Precision& operator=(const Precision&) = delete;

   private:
    unsigned previous_;
  };

  BigInterval() : BigInterval(0) {}
  BigInterval(int integer) : value_(integer) {}
  explicit BigInterval(const Rational& x);

  template <std::floating_point T>
  BigInterval(T) = delete;

  [[nodiscard]] Rational lower() const;
  [[nodiscard]] Rational upper() const;

  friend BigInterval operator+(const BigInterval& a, const BigInterval& b) {
    return BigInterval(Wrapped(a.value_ + b.value_));
  }
  friend BigInterval operator-(const BigInterval& a, const BigInterval& b) {
    return BigInterval(Wrapped(a.value_ - b.value_));
  }
  friend BigInterval operator*(const BigInterval& a, const BigInterval& b) {
    return BigInterval(Wrapped(a.value_ * b.value_));
  }
  /// Unbounded if b contains 0.
  friend BigInterval operator/(const BigInterval& a, const BigInterval& b) {
    return BigInterval(Wrapped(a.value_ / b.value_));
  }
  friend BigInterval operator-(const BigInterval& a) { return BigInterval(Wrapped(-a.value_)); }
  BigInterval& operator+=(const BigInterval& b) { return *this = *this + b; }
  BigInterval& operator-=(const BigInterval& b) { return *this = *this - b; }
  BigInterval& operator*=(const BigInterval& b) { return *this = *this * b; }

  friend BigInterval square(const BigInterval& a);
  /// Negative parts of the argument are cut off at 0.
  friend BigInterval square_root(const BigInterval& a);
  friend BigInterval absolute(const BigInterval& a);
  friend BigInterval minimum(const BigInterval& a, const BigInterval& b);
  friend BigInterval maximum(const BigInterval& a, const BigInterval& b);

  friend Verdict less(const BigInterval& a, const BigInterval& b);
  friend Verdict less_equal(const BigInterval& a, const BigInterval& b) { return negation(less(b, a)); }
  friend Verdict is_zero(const BigInterval& a);

 private:
  explicit BigInterval(Wrapped value) : value_(std::move(value)) {}
  [[nodiscard]] mpfi_srcptr raw() const { return value_.backend().data(); }
  [[nodiscard]] mpfi_ptr raw() { return value_.backend().data(); }
  Wrapped value_;
};

}  // namespace delcert
