#pragma once

#include "kernel/number/scalar.hpp"

namespace delcert {

// Comparisons of a with sums of square roots, decided on squares: exact where a and the radicands are. A negative a
// is below any root; otherwise both sides are squared. Kleene's disjunction joins the cases, so that an undecided
// sign of a does no harm where the squares decide. Preconditions: radicands are not negative.

/// a ≤ 2√b
template <Scalar S>
[[nodiscard]] Verdict is_at_most_twice_root(const S& a, const S& b) {
  return disjunction(less_equal(a, S(0)), less_equal(square(a), S(4) * b));
}

/// a < 2√b
template <Scalar S>
[[nodiscard]] Verdict is_less_than_twice_root(const S& a, const S& b) {
  return disjunction(less(a, S(0)), less(square(a), S(4) * b));
}

/// a < 2(√b + √c)
template <Scalar S>
[[nodiscard]] Verdict is_less_than_twice_roots(const S& a, const S& b, const S& c) {
  return disjunction(less(a, S(0)), is_less_than_twice_root(S(square(a) / S(4) - b - c), S(b * c)));
}

}  // namespace delcert
