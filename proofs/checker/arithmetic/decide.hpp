#pragma once

#include <cstdint>
#include <cstdio>
#include <stdexcept>
#include <string>
#include <type_traits>

#include "proofs/checker/arithmetic/decimal.hpp"
#include "proofs/checker/report/budget.hpp"

namespace delcert::checker {

/// Names a number type to a generic predicate.
template <class N>
struct In {};

/// An exactly known number with its enclosure.
struct Quantity {
  Rational exact;
  Interval filter;

  Quantity() = default;
  explicit Quantity(Rational x) : exact(std::move(x)), filter(enclosure(exact)) {}

  template <class N>
  decltype(auto) as() const {
    if constexpr (std::is_same_v<N, Interval>) {
      return (filter);
    } else if constexpr (std::is_same_v<N, Rational>) {
      return (exact);
    } else {
      return N(exact);
    }
  }
};

/// How many decisions each arithmetic has made.
struct Decisions {
  std::uint64_t filtered = 0;
  std::uint64_t exact = 0;
  std::uint64_t enclosed = 0;  // by balls
};
inline Decisions decisions;

/// Whether the predicate holds: by the filter if that decides, otherwise in rational arithmetic, which always does
/// (and consists of integer operations, which no rounding mode touches). The predicate takes In<N> and returns a
/// Verdict computed in N alone.
template <class Predicate>
bool decide(const Predicate& predicate) {
  Budget::spend(1);
  const Verdict filtered = predicate(In<Interval>{});
  if (filtered != Verdict::undecided) {
    ++decisions.filtered;
    return filtered == Verdict::proved;
  }
  ++decisions.exact;
  Budget::spend(1000);
  const Verdict exact = predicate(In<Rational>{});
  if (exact == Verdict::undecided) throw std::logic_error("rational arithmetic left a question open");
  return exact == Verdict::proved;
}

/// Counts a decision if bounds in doubles have made it.
inline bool is_decided(bool is_made) {
  Budget::spend(1);
  if (is_made) ++decisions.filtered;
  return is_made;
}

/// The number in decimal, approximately: for messages about what no one states. Bounds that are stated are printed by
/// rounded_down and rounded_up.
inline std::string about(const Interval& x) {
  char text[64];
  std::snprintf(text, sizeof text, "%.6g", x.lower() / 2 + x.upper() / 2);
  return text;
}

template <class N>
Verdict less_equal(const N& a, const N& b) {
  return negation(less(b, a));
}

/// a < sqrt(b), for b known not to be negative: a is negative or a^2 < b.
template <class N>
Verdict less_than_root(const N& a, const N& b) {
  return disjunction(less(a, N(0)), less(square(a), b));
}

/// a <= sqrt(b), for b known not to be negative.
template <class N>
Verdict at_most_root(const N& a, const N& b) {
  return disjunction(less_equal(a, N(0)), less_equal(square(a), b));
}

}  // namespace delcert::checker
