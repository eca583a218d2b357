#pragma once

#include <mpfi.h>

#include <concepts>

#include "kernel/number/rational.hpp"
#include "kernel/number/strong.hpp"
#include "kernel/number/verdict.hpp"

namespace delcert {

/// An interval with MPFR endpoints, rounded outwards by MPFI: the second rung.
///
/// Every operation returns an enclosure of the exact result for all arguments in the operands, with endpoints of the
/// precision of the innermost `BigInterval::Precision` alive in this thread, 128 bits if there is none. No rounding
/// guard is needed; one that is alive does no harm. Endpoints are never NaN.
class BigInterval {
 public:
  /// Sets the working precision of this thread while it lives.
  class [[nodiscard]] Precision {
   public:
    /// Throws std::domain_error unless 2 <= bits <= 2^20.
    explicit Precision(PrecisionBits bits);
    ~Precision();
    Precision(const Precision&) = delete;
    Precision& operator=(const Precision&) = delete;

   private:
    PrecisionBits previous_;
  };
  [[nodiscard]] static PrecisionBits working_precision();

  BigInterval() noexcept : BigInterval(0) {}
  BigInterval(int integer) noexcept;
  /// The tightest enclosure of x at the working precision.
  explicit BigInterval(const Rational& x) noexcept;

  template <std::floating_point T>
  BigInterval(T) = delete;

  BigInterval(const BigInterval& other) noexcept;
  BigInterval(BigInterval&& other) noexcept;
  BigInterval& operator=(const BigInterval& other) noexcept;
  BigInterval& operator=(BigInterval&& other) noexcept;
  ~BigInterval();

  /// The tightest enclosure of [lower, upper]. Precondition: lower <= upper.
  [[nodiscard]] static BigInterval between(const Rational& lower, const Rational& upper);

  /// A copy, with its own precision. Precondition: no endpoint is NaN, and they are in order.
  [[nodiscard]] static BigInterval copy_of(mpfi_srcptr value);

  /// Exactly the endpoints; throw std::domain_error where unbounded.
  [[nodiscard]] Rational lower() const;
  [[nodiscard]] Rational upper() const;
  [[nodiscard]] bool is_bounded() const;
  [[nodiscard]] mpfi_srcptr mpfi() const { return value_; }

  friend BigInterval operator+(const BigInterval& a, const BigInterval& b) noexcept;
  friend BigInterval operator-(const BigInterval& a, const BigInterval& b) noexcept;
  friend BigInterval operator*(const BigInterval& a, const BigInterval& b) noexcept;
  /// Unbounded if b contains 0.
  friend BigInterval operator/(const BigInterval& a, const BigInterval& b) noexcept;
  friend BigInterval operator-(const BigInterval& a) noexcept;
  BigInterval& operator+=(const BigInterval& b) noexcept { return *this = *this + b; }
  BigInterval& operator-=(const BigInterval& b) noexcept { return *this = *this - b; }
  BigInterval& operator*=(const BigInterval& b) noexcept { return *this = *this * b; }

  friend BigInterval square(const BigInterval& a) noexcept;
  /// Negative parts of the argument are cut off at 0 (the exact argument is known not to be negative).
  friend BigInterval square_root(const BigInterval& a) noexcept;
  friend BigInterval absolute(const BigInterval& a) noexcept;
  friend BigInterval minimum(const BigInterval& a, const BigInterval& b) noexcept;
  friend BigInterval maximum(const BigInterval& a, const BigInterval& b) noexcept;

  friend Verdict less(const BigInterval& a, const BigInterval& b) noexcept;
  friend Verdict less_equal(const BigInterval& a, const BigInterval& b) noexcept { return negation(less(b, a)); }
  friend Verdict is_zero(const BigInterval& a) noexcept;

 private:
  struct Unset {};
  explicit BigInterval(Unset) noexcept;
  void release() noexcept;
  mpfi_t value_;
};

}  // namespace delcert
