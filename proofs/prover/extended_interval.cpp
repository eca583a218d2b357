#include "proofs/prover/extended_interval.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace delcert {

namespace {

using End = ExtendedInterval::End;

PrecisionBits precision_of(const End& end) { return PrecisionBits{static_cast<unsigned>(mpfr_get_prec(end.raw()))}; }

/// Sets the end by an operation of MPFR that takes the place of the result and the rounding mode, outwards.
template <class Operation>
End rounded(PrecisionBits precision, bool is_lower, bool open, const Operation& operation) {
  End result(precision);
  const int inexact = operation(result.raw(), is_lower ? MPFR_RNDD : MPFR_RNDU);
  // A negative zero has powers of its own.
  if (mpfr_zero_p(result.raw()) != 0) mpfr_set_zero(result.raw(), 1);
  result.open = open || inexact != 0 || result.is_infinite();
  return result;
}

/// The product of two ends, a corner of the product of two sets: 0 times an infinite end stands for 0 times numbers.
End corner(const End& a, const End& b, bool is_lower) {
  const auto precision = precision_of(a);
  if (a.sign() == 0 || b.sign() == 0) {
    const bool attained = (a.sign() == 0 && !a.open) || (b.sign() == 0 && !b.open);
    return rounded(precision, is_lower, !attained, [](mpfr_ptr to, mpfr_rnd_t) { return mpfr_set_zero(to, 1), 0; });
  }
  return rounded(precision, is_lower, a.open || b.open,
                 [&](mpfr_ptr to, mpfr_rnd_t mode) { return mpfr_mul(to, a.raw(), b.raw(), mode); });
}

/// The lesser of two lower ends or the greater of two upper ones: of equal ends the closed one.
End outer(End a, End b, bool is_lower) {
  const int order = mpfr_cmp(a.raw(), b.raw());
  if (order == 0) {
    a.open = a.open && b.open;
    return a;
  }
  return (order < 0) == is_lower ? a : b;
}

/// The other one of the two.
End inner(End a, End b, bool is_lower) {
  const int order = mpfr_cmp(a.raw(), b.raw());
  if (order == 0) {
    a.open = a.open || b.open;
    return a;
  }
  return (order < 0) == is_lower ? b : a;
}

/// a^b for an end a of positive numbers (0 or infinite if it is open) and an end b of exponents. In (log a, b) this is
/// the corner of a product, so 1^∞ stands for powers of 1, a^0 for 0th powers.
End power_corner(const End& a, const End& b, bool is_lower) {
  const auto precision = precision_of(a);
  const bool is_base_one = mpfr_cmp_ui(a.raw(), 1) == 0;
  if (is_base_one || b.sign() == 0) {
    const bool attained = (is_base_one && !a.open) || (b.sign() == 0 && !b.open);
    return rounded(precision, is_lower, !attained,
                   [](mpfr_ptr to, mpfr_rnd_t mode) { return mpfr_set_ui(to, 1, mode); });
  }
  return rounded(precision, is_lower, a.open || b.open,
                 [&](mpfr_ptr to, mpfr_rnd_t mode) { return mpfr_pow(to, a.raw(), b.raw(), mode); });
}

End negated(const End& a) {
  End result = a;
  if (a.sign() != 0) mpfr_neg(result.raw(), a.raw(), MPFR_RNDN);
  return result;
}

End infinite(PrecisionBits precision, int sign) {
  End result(precision);
  mpfr_set_inf(result.raw(), sign);
  result.open = true;
  return result;
}

End end_at(const std::optional<Rational>& x, bool has, bool is_lower, PrecisionBits precision) {
  if (!x) return infinite(precision, is_lower ? -1 : 1);
  return rounded(precision, is_lower, !has,
                 [&](mpfr_ptr to, mpfr_rnd_t mode) { return mpfr_set_q(to, x->gmp(), mode); });
}

End root(const End& a, bool is_lower) {
  return rounded(precision_of(a), is_lower, a.open,
                 [&](mpfr_ptr to, mpfr_rnd_t mode) { return mpfr_sqrt(to, a.raw(), mode); });
}

End logarithm(const End& a, bool is_lower) {
  if (a.sign() == 0) return infinite(precision_of(a), -1);
  return rounded(precision_of(a), is_lower, a.open,
                 [&](mpfr_ptr to, mpfr_rnd_t mode) { return mpfr_log2(to, a.raw(), mode); });
}

/// The power of an end that is not negative.
End integer_power(const End& a, unsigned long exponent, bool is_lower) {
  return rounded(precision_of(a), is_lower, a.open,
                 [&](mpfr_ptr to, mpfr_rnd_t mode) { return mpfr_pow_ui(to, a.raw(), exponent, mode); });
}

End inverse(const End& a, bool is_lower) {
  if (a.sign() == 0) return infinite(precision_of(a), is_lower ? -1 : 1);
  return rounded(precision_of(a), is_lower, a.open,
                 [&](mpfr_ptr to, mpfr_rnd_t mode) { return mpfr_ui_div(to, 1, a.raw(), mode); });
}

}  // namespace

ExtendedInterval::End::End(const End& other) : open(other.open) {
  mpfr_init2(value_, mpfr_get_prec(other.value_));
  mpfr_set(value_, other.value_, MPFR_RNDN);
}

ExtendedInterval::End::End(End&& other) noexcept : open(other.open) {
  mpfr_init2(value_, mpfr_get_prec(other.value_));
  mpfr_swap(value_, other.value_);
}

ExtendedInterval::End& ExtendedInterval::End::operator=(const End& other) {
  if (this != &other) {
    mpfr_set_prec(value_, mpfr_get_prec(other.value_));
    mpfr_set(value_, other.value_, MPFR_RNDN);
    open = other.open;
  }
  return *this;
}

ExtendedInterval::End& ExtendedInterval::End::operator=(End&& other) noexcept {
  mpfr_swap(value_, other.value_);
  open = other.open;
  return *this;
}

ExtendedInterval::ExtendedInterval(PrecisionBits precision)
    : lower_(infinite(precision, -1)), upper_(infinite(precision, 1)) {}

ExtendedInterval::ExtendedInterval(const Rational& x, PrecisionBits precision)
    : ExtendedInterval(x, true, x, true, precision) {}

ExtendedInterval::ExtendedInterval(const std::optional<Rational>& lower, bool has_lower,
                                   const std::optional<Rational>& upper, bool has_upper, PrecisionBits precision)
    : lower_(end_at(lower, has_lower, true, precision)), upper_(end_at(upper, has_upper, false, precision)) {}

ExtendedInterval ExtendedInterval::at(const End& end) {
  End point = end;
  point.open = false;
  return {point, point};
}

ExtendedInterval ExtendedInterval::hull(const ExtendedInterval& a, const ExtendedInterval& b) {
  return {outer(a.lower_, b.lower_, true), outer(a.upper_, b.upper_, false)};
}

ExtendedInterval ExtendedInterval::with_open_lower() const {
  ExtendedInterval result = *this;
  result.lower_.open = true;
  return result;
}

ExtendedInterval ExtendedInterval::with_open_upper() const {
  ExtendedInterval result = *this;
  result.upper_.open = true;
  return result;
}

PrecisionBits ExtendedInterval::precision() const { return precision_of(lower_); }

bool ExtendedInterval::contains_zero() const { return !is_positive() && !is_negative(); }

double ExtendedInterval::approximate_width() const {
  return mpfr_get_d(upper_.raw(), MPFR_RNDN) - mpfr_get_d(lower_.raw(), MPFR_RNDN);
}

ExtendedInterval operator+(const ExtendedInterval& a, const ExtendedInterval& b) {
  const auto sum = [](const End& x, const End& y, bool is_lower) {
    return rounded(precision_of(x), is_lower, x.open || y.open,
                   [&](mpfr_ptr to, mpfr_rnd_t mode) { return mpfr_add(to, x.raw(), y.raw(), mode); });
  };
  return {sum(a.lower_, b.lower_, true), sum(a.upper_, b.upper_, false)};
}

ExtendedInterval operator-(const ExtendedInterval& a) { return {negated(a.upper_), negated(a.lower_)}; }

ExtendedInterval operator*(const ExtendedInterval& a, const ExtendedInterval& b) {
  const auto extreme = [&](bool is_lower) {
    End best = corner(a.lower_, b.lower_, is_lower);
    best = outer(std::move(best), corner(a.lower_, b.upper_, is_lower), is_lower);
    best = outer(std::move(best), corner(a.upper_, b.lower_, is_lower), is_lower);
    return outer(std::move(best), corner(a.upper_, b.upper_, is_lower), is_lower);
  };
  return {extreme(true), extreme(false)};
}

std::optional<ExtendedInterval> quotient(const ExtendedInterval& a, const ExtendedInterval& b) {
  if (b.contains_zero()) return std::nullopt;
  return a * ExtendedInterval(inverse(b.upper_, true), inverse(b.lower_, false));
}

ExtendedInterval power(const ExtendedInterval& a, unsigned long exponent) {
  if (exponent == 0) return ExtendedInterval(Rational(1), a.precision());
  if (a.is_nonnegative()) {
    return {integer_power(a.lower_, exponent, true), integer_power(a.upper_, exponent, false)};
  }
  if (exponent % 2 == 1) {
    return {integer_power(a.lower_, exponent, true), integer_power(a.upper_, exponent, false)};
  }
  return power(absolute(a), exponent);
}

std::optional<ExtendedInterval> power(const ExtendedInterval& a, const ExtendedInterval& b) {
  if (!a.is_positive()) return std::nullopt;
  const auto extreme = [&](bool is_lower) {
    End best = power_corner(a.lower_, b.lower_, is_lower);
    best = outer(std::move(best), power_corner(a.lower_, b.upper_, is_lower), is_lower);
    best = outer(std::move(best), power_corner(a.upper_, b.lower_, is_lower), is_lower);
    return outer(std::move(best), power_corner(a.upper_, b.upper_, is_lower), is_lower);
  };
  return ExtendedInterval(extreme(true), extreme(false));
}

std::optional<ExtendedInterval> square_root(const ExtendedInterval& a) {
  if (!a.is_nonnegative()) return std::nullopt;
  return ExtendedInterval(root(a.lower_, true), root(a.upper_, false));
}

std::optional<ExtendedInterval> binary_logarithm(const ExtendedInterval& a) {
  if (!a.is_positive()) return std::nullopt;
  return ExtendedInterval(logarithm(a.lower_, true), logarithm(a.upper_, false));
}

ExtendedInterval absolute(const ExtendedInterval& a) {
  if (a.is_nonnegative()) return a;
  if (a.is_nonpositive()) return -a;
  End zero(a.precision());
  mpfr_set_zero(zero.raw(), 1);
  return {std::move(zero), outer(negated(a.lower_), a.upper_, false)};
}

ExtendedInterval minimum(const ExtendedInterval& a, const ExtendedInterval& b) {
  return {outer(a.lower_, b.lower_, true), inner(a.upper_, b.upper_, false)};
}

ExtendedInterval maximum(const ExtendedInterval& a, const ExtendedInterval& b) {
  return {inner(a.lower_, b.lower_, true), outer(a.upper_, b.upper_, false)};
}

}  // namespace delcert
