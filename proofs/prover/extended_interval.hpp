#pragma once

#include <mpfr.h>

#include <optional>

#include "kernel/number/rational.hpp"
#include "kernel/number/strong.hpp"

namespace delcert {

/// A set of real numbers between two ends, which may be infinite: what the prover knows of a term on a box of
/// parameters. For each end it knows whether the end itself can be a value (then the end is *closed*), so that
/// 1/x > 1 is certain for 0 < x < 1.
///
/// Ends are of the precision given and rounded outwards; one that is rounded is open, as the exact one lies inside.
/// Values are real numbers, infinity is none: an infinite end is open, and 0·[1, ∞) is 0.
class ExtendedInterval {
 public:
  /// An end: a number of MPFR, never NaN.
  class End {
   public:
    explicit End(PrecisionBits precision) { mpfr_init2(value_, static_cast<mpfr_prec_t>(precision.value)); }
    End(const End& other);
    End(End&& other) noexcept;
    End& operator=(const End& other);
    End& operator=(End&& other) noexcept;
    ~End() { mpfr_clear(value_); }
    [[nodiscard]] mpfr_ptr raw() { return value_; }
    [[nodiscard]] mpfr_srcptr raw() const { return value_; }
    [[nodiscard]] bool is_infinite() const { return mpfr_inf_p(value_) != 0; }
    [[nodiscard]] int sign() const { return mpfr_sgn(value_); }

    bool open = false;

   private:
    mpfr_t value_;
  };

  /// All real numbers.
  explicit ExtendedInterval(PrecisionBits precision);
  ExtendedInterval(const Rational& x, PrecisionBits precision);
  /// From lower to upper, without end where there is none. Precondition: it is not empty.
  ExtendedInterval(const std::optional<Rational>& lower, bool has_lower, const std::optional<Rational>& upper,
                   bool has_upper, PrecisionBits precision);

  /// The point that is an end, whether or not the end belongs to where it comes from. Precondition: not infinite.
  [[nodiscard]] static ExtendedInterval at(const End& end);
  /// From one end to the other. Precondition: not empty.
  [[nodiscard]] static ExtendedInterval between(End lower, End upper) { return {std::move(lower), std::move(upper)}; }
  /// The smallest interval that has the values of both.
  [[nodiscard]] static ExtendedInterval hull(const ExtendedInterval& a, const ExtendedInterval& b);
  /// Without its lower (upper) end.
  [[nodiscard]] ExtendedInterval with_open_lower() const;
  [[nodiscard]] ExtendedInterval with_open_upper() const;

  [[nodiscard]] const End& lower() const { return lower_; }
  [[nodiscard]] const End& upper() const { return upper_; }
  [[nodiscard]] PrecisionBits precision() const;

  [[nodiscard]] bool contains_zero() const;
  [[nodiscard]] bool is_positive() const { return lower_.sign() > 0 || (lower_.sign() == 0 && lower_.open); }
  [[nodiscard]] bool is_negative() const { return upper_.sign() < 0 || (upper_.sign() == 0 && upper_.open); }
  [[nodiscard]] bool is_nonnegative() const { return lower_.sign() >= 0; }
  [[nodiscard]] bool is_nonpositive() const { return upper_.sign() <= 0; }
  [[nodiscard]] bool is_zero() const { return is_nonnegative() && is_nonpositive(); }
  /// Upper minus lower end as a double, infinite where an end is; without error bounds.
  [[nodiscard]] double approximate_width() const;

  friend ExtendedInterval operator+(const ExtendedInterval& a, const ExtendedInterval& b);
  friend ExtendedInterval operator-(const ExtendedInterval& a, const ExtendedInterval& b) { return a + (-b); }
  friend ExtendedInterval operator*(const ExtendedInterval& a, const ExtendedInterval& b);
  friend ExtendedInterval operator-(const ExtendedInterval& a);
  /// Nothing unless 0 is certainly no value of b.
  friend std::optional<ExtendedInterval> quotient(const ExtendedInterval& a, const ExtendedInterval& b);
  friend ExtendedInterval power(const ExtendedInterval& a, unsigned long exponent);
  /// a^b for real exponents; nothing unless all values of a are positive.
  friend std::optional<ExtendedInterval> power(const ExtendedInterval& a, const ExtendedInterval& b);
  /// Nothing unless no value is negative.
  friend std::optional<ExtendedInterval> square_root(const ExtendedInterval& a);
  /// Nothing unless all values are positive.
  friend std::optional<ExtendedInterval> binary_logarithm(const ExtendedInterval& a);
  friend ExtendedInterval absolute(const ExtendedInterval& a);
  friend ExtendedInterval minimum(const ExtendedInterval& a, const ExtendedInterval& b);
  friend ExtendedInterval maximum(const ExtendedInterval& a, const ExtendedInterval& b);

 private:
  ExtendedInterval(End lower, End upper) : lower_(std::move(lower)), upper_(std::move(upper)) {}
  End lower_;
  End upper_;
};

[[nodiscard]] std::optional<ExtendedInterval> quotient(const ExtendedInterval& a, const ExtendedInterval& b);
[[nodiscard]] ExtendedInterval power(const ExtendedInterval& a, unsigned long exponent);
[[nodiscard]] std::optional<ExtendedInterval> power(const ExtendedInterval& a, const ExtendedInterval& b);
[[nodiscard]] std::optional<ExtendedInterval> square_root(const ExtendedInterval& a);
[[nodiscard]] std::optional<ExtendedInterval> binary_logarithm(const ExtendedInterval& a);
[[nodiscard]] ExtendedInterval absolute(const ExtendedInterval& a);
[[nodiscard]] ExtendedInterval minimum(const ExtendedInterval& a, const ExtendedInterval& b);
[[nodiscard]] ExtendedInterval maximum(const ExtendedInterval& a, const ExtendedInterval& b);

}  // namespace delcert
