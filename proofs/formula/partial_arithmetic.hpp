#pragma once

#include <algorithm>
#include <concepts>
#include <utility>

#include "kernel/number/algebraic.hpp"
#include "kernel/number/surd.hpp"
#include "kernel/simplex/partial.hpp"

// Operations that some numbers do not have: division, square roots and powers, on each rung.

namespace delcert {

namespace detail {

/// Exact powers have as many digits as they have; intervals have not.
[[nodiscard]] inline bool has_large_power(const Rational& base, unsigned long exponent) {
  constexpr std::size_t most_bits = std::size_t{1} << 22U;
  const std::size_t bits = mpz_sizeinbase(mpq_numref(base.gmp()), 2) + mpz_sizeinbase(mpq_denref(base.gmp()), 2);
  return bits > most_bits / std::max(exponent, 1UL);
}
[[nodiscard]] inline bool has_large_power(const Algebraic& base, unsigned long exponent) {
  constexpr unsigned long greatest_for_irrational = 256;
  return base.degree() == 1 ? has_large_power(base.rational(), exponent) : exponent > greatest_for_irrational;
}
[[nodiscard]] inline bool has_large_power(const Surd& base, unsigned long exponent) {
  const auto squared = square(base).rational();
  return !squared || has_large_power(*squared, exponent);
}

template <class S>
[[nodiscard]] S integral_power(const S& base, unsigned long exponent) {
  if (exponent == 0) return S(1);
  if (exponent == 1) return base;
  const S half = integral_power(base, exponent / 2);
  return exponent % 2 == 0 ? S(square(half)) : S(square(half) * base);
}

}  // namespace detail

/// Most constants of formulas are small integers, for which there are faster ways than the general one.
template <class S>
[[nodiscard]] S number_from(const Rational& x) {
  if (mpz_cmp_ui(mpq_denref(x.gmp()), 1) == 0 && mpz_fits_sint_p(mpq_numref(x.gmp())) != 0) {
    return S(static_cast<int>(mpz_get_si(mpq_numref(x.gmp()))));
  }
  return scalar_from<S>(x);
}

template <class S>
[[nodiscard]] S number_from(long x) {
  return std::in_range<int>(x) ? S(static_cast<int>(x)) : scalar_from<S>(Rational(x));
}

/// Absent where the argument is negative, or may be.
template <class S>
[[nodiscard]] Partial<S> partial_root(const S& x) {
  const Verdict negative = less(x, S(0));
  return is_refuted(negative) ? Partial<S>(square_root(x)) : Partial<S>::absent(negation(negative));
}

/// Absent where the divisor is 0, or may be: an unbounded interval would pretend that there is a value.
template <class S>
[[nodiscard]] Partial<S> partial_quotient(const S& a, const S& b) {
  const Verdict zero = is_zero(b);
  return is_refuted(zero) ? Partial<S>(S(a / b)) : Partial<S>::absent(negation(zero));
}

/// x^0 is 1. Refuted where the exponent is neither an integer nor half of one, undecided where the power may be too
/// large.
template <class S>
[[nodiscard]] Partial<S> partial_power(const S& base, const Rational& exponent) {
  const Integer denominator = exponent.denominator();
  if (denominator != 1 && denominator != 2) return Partial<S>::absent(Verdict::refuted);
  constexpr long greatest = 1000000;
  if (absolute(exponent) > Rational(greatest)) return Partial<S>::absent(Verdict::undecided);
  Partial<S> radical = denominator == 2 ? partial_root(base) : Partial<S>(base);
  if (!radical) return radical;
  const auto size = static_cast<unsigned long>(absolute(exponent).numerator());
  if constexpr (std::same_as<S, Algebraic> || std::same_as<S, Surd>) {
    if (detail::has_large_power(*radical, size)) return Partial<S>::absent(Verdict::undecided);
  }
  S result = detail::integral_power(*radical, size);
  return exponent < Rational(0) ? partial_quotient(S(1), result) : Partial<S>(std::move(result));
}

}  // namespace delcert
