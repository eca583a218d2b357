#pragma once

#if __has_include(<flint/arb.h>)  // FLINT 3
#include <flint/arb.h>
#else
#include <arb.h>
#endif

#include <cfenv>

#include "proofs/checker/arithmetic/decide.hpp"
#include "proofs/checker/report/report.hpp"

namespace delcert::checker {

/// An enclosure of a real number by a midpoint and a radius (Arb), with `precision` bits: the rung above the filter
/// where quantities are not rational. Every operation encloses all exact results.
class Ball {
 public:
  static inline slong precision = 128;

  Ball() { arb_init(value_); }
  explicit Ball(int value) : Ball() { arb_set_si(value_, value); }
  explicit Ball(const Rational& x) : Ball() { arb_set_fmpq(value_, x.raw(), precision); }
  Ball(const Ball& other) : Ball() { arb_set(value_, other.value_); }
  Ball(Ball&& other) noexcept : Ball() { arb_swap(value_, other.value_); }
  Ball& operator=(Ball other) noexcept {
    arb_swap(value_, other.value_);
    return *this;
  }
  ~Ball() { arb_clear(value_); }

  arb_ptr raw() { return value_; }
  arb_srcptr raw() const { return value_; }

  friend Ball operator+(const Ball& a, const Ball& b) { return apply(arb_add, a, b); }
  friend Ball operator-(const Ball& a, const Ball& b) { return apply(arb_sub, a, b); }
  friend Ball operator*(const Ball& a, const Ball& b) { return apply(arb_mul, a, b); }
  friend Ball operator/(const Ball& a, const Ball& b) { return apply(arb_div, a, b); }
  friend Ball operator-(const Ball& a) { return Ball(0) - a; }
  friend Ball square(const Ball& a) { return apply(arb_sqr, a); }
  friend Ball square_root(const Ball& a) { return apply(arb_sqrt, a); }
  friend Ball maximum(const Ball& a, const Ball& b) { return apply(arb_max, a, b); }
  /// The least ball around both.
  friend Ball joined(const Ball& a, const Ball& b) { return apply(arb_union, a, b); }
  friend Verdict less(const Ball& a, const Ball& b) {
    if (arb_lt(a.value_, b.value_) != 0) return Verdict::proved;
    return arb_ge(a.value_, b.value_) != 0 ? Verdict::refuted : Verdict::undecided;
  }

  static Ball apply(void (*operation)(arb_t, const arb_t, slong), const Ball& a) {
    Ball result;
    operation(result.value_, a.value_, precision);
    return result;
  }

  Interval enclosure() const {
    arf_t lower, upper;
    arf_init(lower);
    arf_init(upper);
    arb_get_lbound_arf(lower, value_, 64);
    arb_get_ubound_arf(upper, value_, 64);
    const double low = arf_get_d(lower, ARF_RND_FLOOR), high = arf_get_d(upper, ARF_RND_CEIL);
    arf_clear(lower);
    arf_clear(upper);
    constexpr double infinity = std::numeric_limits<double>::infinity();
    return low <= high ? Interval::between(low, high) : Interval::between(-infinity, infinity);
  }

 private:
  static Ball apply(void (*operation)(arb_t, const arb_t, const arb_t, slong), const Ball& a, const Ball& b) {
    Ball result;
    operation(result.value_, a.value_, b.value_, precision);
    return result;
  }
  arb_t value_;
};

/// Rounds to nearest while it lives, as libraries expect, and as before after it; the precision of balls is restored.
/// Only in_balls makes one.
class BallScope {
 public:
  explicit BallScope(slong precision) : before_(Ball::precision), rounding_(std::fegetround()) {
    std::fesetround(FE_TONEAREST);
    Ball::precision = precision;
  }
  ~BallScope() {
    std::fesetround(rounding_);
    Ball::precision = before_;
  }
  BallScope(const BallScope&) = delete;
  BallScope& operator=(const BallScope&) = delete;

 private:
  slong before_;
  int rounding_;
};

// The compiler knows nothing of the mode of rounding: it may move arithmetic of doubles across a change of it, within a
// function (HACKING.md, "Flags matter"). So the function that changes it has none, and neither it nor what it calls is
// merged with, or specialised for, its callers.
#if defined(__clang__)
#define DELCERT_CHECK_OPAQUE [[gnu::noinline]]
#else
#define DELCERT_CHECK_OPAQUE [[gnu::noipa]]
#endif

template <class F>
DELCERT_CHECK_OPAQUE auto call_opaquely(const F& f) {
  return f();
}

/// f(), with rounding to nearest and balls of this precision. Around the call, and in the function that switches, there
/// is no arithmetic of doubles that the switch concerns.
template <class F>
DELCERT_CHECK_OPAQUE auto in_balls(slong precision, const F& f) {
  const BallScope scope(precision);
  return call_opaquely(f);
}

/// Whether the predicate holds: by the filter, or by balls of more and more bits. Throws Undecided if 1024 are too few,
/// as in a tie of numbers that are not rational. The predicate takes In<N> and returns a Verdict computed in N alone.
template <class Predicate>
bool decide_enclosed(const Predicate& predicate) {
  Budget::spend(1);
  const Verdict filtered = predicate(In<Interval>{});
  if (filtered != Verdict::undecided) {
    ++decisions.filtered;
    return filtered == Verdict::proved;
  }
  ++decisions.enclosed;
  Budget::spend(1000);
  for (slong precision = 128; precision <= 1024; precision *= 2) {
    const Verdict refined = in_balls(precision, [&] { return predicate(In<Ball>{}); });
    if (refined != Verdict::undecided) return refined == Verdict::proved;
  }
  throw Undecided("a comparison is left open by enclosures of 1024 bits");
}

/// Decides with balls alone.
template <class Predicate>
bool decide_with_balls(const Predicate& predicate) {
  return decide_enclosed([&]<class N>(In<N>) {
    if constexpr (std::is_same_v<N, Ball>) {
      return predicate();
    } else {
      return Verdict::undecided;
    }
  });
}

}  // namespace delcert::checker
