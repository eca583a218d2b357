#pragma once

#include <concepts>

#include "kernel/number/big_interval.hpp"
#include "kernel/number/interval.hpp"
#include "kernel/number/rational.hpp"

namespace delcert {

/// What a quantity may be computed in: the rungs of the ladder share these operations, so that one template serves
/// all of them. Comparisons are verdicts. Division: see each rung for a divisor that may be 0.
template <class S>
concept Scalar = std::copyable<S> && requires(const S& a, const S& b) {
  { a + b } -> std::same_as<S>;
  { a - b } -> std::same_as<S>;
  { a* b } -> std::same_as<S>;
  { a / b } -> std::same_as<S>;
  { square(a) } -> std::same_as<S>;
  { less(a, b) } -> std::same_as<Verdict>;
  { is_zero(a) } -> std::same_as<Verdict>;
  S(1);
};

/// 2a. Exact on doubles but for overflow, so on intervals as tight as the product by 2, and cheaper.
template <Scalar S>
[[nodiscard]] S twice(const S& a) {
  return a + a;
}

/// The scalar that stands for an exactly known rational: itself, or the tightest enclosure of the rung.
/// There is no generic way to do this, hence no primary definition.
template <class S>
[[nodiscard]] S scalar_from(const Rational&) = delete;

template <>
[[nodiscard]] Interval scalar_from<Interval>(const Rational& x);
template <>
[[nodiscard]] BigInterval scalar_from<BigInterval>(const Rational& x);
template <>
[[nodiscard]] inline Rational scalar_from<Rational>(const Rational& x) {
  return x;
}

}  // namespace delcert
