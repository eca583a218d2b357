#pragma once

#include <CGAL/Interval_nt.h>

#include <concepts>
#include <limits>

#include "kernel/number/verdict.hpp"

namespace delcert {

/// A closed interval with double endpoints: the filter, the first rung of the ladder.
///
/// Every operation returns an enclosure of the exact result for all arguments in the operands, rounded outwards
/// (to infinity on overflow, over the subnormals on underflow). Precondition of every operation: a `RoundingGuard`
/// is alive in this thread. Endpoints are never NaN.
class Interval {
 public:
  Interval() : value_(0) {}
  Interval(int integer) : value_(integer) {}

  /// No decimal literal becomes an enclosure by accident.
  template <std::floating_point T>
  Interval(T) = delete;

  /// The degenerate interval [value, value]. Precondition: value is finite.
  [[nodiscard]] static Interval exactly(double value) { return Interval(Wrapped(value)); }
  /// Precondition: lower <= upper, neither is NaN.
  [[nodiscard]] static Interval between(double lower, double upper) { return Interval(Wrapped(lower, upper)); }

  [[nodiscard]] double lower() const { return value_.inf(); }
  [[nodiscard]] double upper() const { return value_.sup(); }

  friend Interval operator+(const Interval& a, const Interval& b) { return Interval(a.value_ + b.value_); }
  friend Interval operator-(const Interval& a, const Interval& b) { return Interval(a.value_ - b.value_); }
  friend Interval operator*(const Interval& a, const Interval& b) {
#if defined(CGAL_USE_SSE2) && (defined(__SSE4_1__) || defined(__AVX__))
    // Compiled for these processors, CGAL 5.5.1 takes [-2, 0] * [1, infinity] for [-infinity, -2], and [-0, 3] *
    // [2, infinity] for [6, infinity]: of 0 * infinity it forgets the 0.
    if (some_is_unbounded(a, b)) [[unlikely]]
      return Interval(Wrapped::largest());
#endif
    return Interval(a.value_ * b.value_);
  }
  /// Unbounded if b contains 0.
  friend Interval operator/(const Interval& a, const Interval& b) { return Interval(a.value_ / b.value_); }
  friend Interval operator-(const Interval& a) { return Interval(-a.value_); }
  Interval& operator+=(const Interval& b) { return *this = *this + b; }
  Interval& operator-=(const Interval& b) { return *this = *this - b; }
  Interval& operator*=(const Interval& b) { return *this = *this * b; }

  friend Interval square(const Interval& a) { return Interval(CGAL::square(a.value_)); }
  /// Negative parts of the argument are cut off at 0 (the exact argument is known not to be negative).
  friend Interval square_root(const Interval& a) {
    return Interval(CGAL::sqrt(Wrapped(a.lower() > 0 ? a.lower() : 0, a.upper() > 0 ? a.upper() : 0)));
  }
  friend Interval absolute(const Interval& a) { return Interval(CGAL::abs(a.value_)); }
  friend Interval minimum(const Interval& a, const Interval& b) { return Interval((CGAL::min)(a.value_, b.value_)); }
  friend Interval maximum(const Interval& a, const Interval& b) { return Interval((CGAL::max)(a.value_, b.value_)); }

  friend Verdict less(const Interval& a, const Interval& b) {
    if (a.upper() < b.lower()) return Verdict::proved;
    if (a.lower() >= b.upper()) return Verdict::refuted;
    return Verdict::undecided;
  }
  friend Verdict less_equal(const Interval& a, const Interval& b) { return negation(less(b, a)); }
  friend Verdict is_zero(const Interval& a) {
    if (a.lower() > 0 || a.upper() < 0) return Verdict::refuted;
    return a.lower() == 0 && a.upper() == 0 ? Verdict::proved : Verdict::undecided;
  }

 private:
  using Wrapped = CGAL::Interval_nt<false>;
  explicit Interval(const Wrapped& value) : value_(value) {}

#ifdef CGAL_USE_SSE2
  // The pair (-lower, upper): unbounded where a component is infinity.
  static bool some_is_unbounded(const Interval& a, const Interval& b) {
    const __m128d infinity = _mm_set1_pd(std::numeric_limits<double>::infinity());
    return _mm_movemask_pd(_mm_cmpeq_pd(_mm_max_pd(a.value_.simd(), b.value_.simd()), infinity)) != 0;
  }
#endif

  Wrapped value_;
};

}  // namespace delcert
