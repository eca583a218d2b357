#pragma once

#include <cmath>
#include <concepts>

#include "kernel/number/verdict.hpp"

namespace delcert {

/// A double in rounding to nearest with the interface of `Interval`, without error bounds, for measuring what intervals
/// cost. What differs by no more than the tolerance is undecided, as a program without intervals would have it that
/// takes ties seriously: exact ties climb the ladder, and are decided there. All else is decided, and nothing is
/// certified.
///
/// `bench/plain/kernel/number/interval.hpp` puts it in place of `Interval`.
class TolerantDouble {
 public:
  /// Much more than what a few operations on numbers of about 1 round, much less than margins of runs.
  static constexpr double tolerance = 0x1p-44;

  TolerantDouble() = default;
  TolerantDouble(int integer) : value_(integer) {}

  template <std::floating_point T>
  TolerantDouble(T) = delete;

  [[nodiscard]] static TolerantDouble exactly(double value) { return TolerantDouble(value, Unchecked{}); }
  /// The midpoint.
  [[nodiscard]] static TolerantDouble between(double lower, double upper) {
    return exactly(lower + (upper - lower) / 2);
  }

  [[nodiscard]] double lower() const { return value_; }
  [[nodiscard]] double upper() const { return value_; }

  friend TolerantDouble operator+(const TolerantDouble& a, const TolerantDouble& b) {
    return exactly(a.value_ + b.value_);
  }
  friend TolerantDouble operator-(const TolerantDouble& a, const TolerantDouble& b) {
    return exactly(a.value_ - b.value_);
  }
  friend TolerantDouble operator*(const TolerantDouble& a, const TolerantDouble& b) {
    return exactly(a.value_ * b.value_);
  }
  friend TolerantDouble operator/(const TolerantDouble& a, const TolerantDouble& b) {
    return exactly(a.value_ / b.value_);
  }
  friend TolerantDouble operator-(const TolerantDouble& a) { return exactly(-a.value_); }
  TolerantDouble& operator+=(const TolerantDouble& b) { return *this = *this + b; }
  TolerantDouble& operator-=(const TolerantDouble& b) { return *this = *this - b; }
  TolerantDouble& operator*=(const TolerantDouble& b) { return *this = *this * b; }

  friend TolerantDouble square(const TolerantDouble& a) { return exactly(a.value_ * a.value_); }
  friend TolerantDouble square_root(const TolerantDouble& a) { return exactly(a.value_ > 0 ? std::sqrt(a.value_) : 0); }
  friend TolerantDouble absolute(const TolerantDouble& a) { return exactly(std::fabs(a.value_)); }
  friend TolerantDouble minimum(const TolerantDouble& a, const TolerantDouble& b) {
    return b.value_ < a.value_ ? b : a;
  }
  friend TolerantDouble maximum(const TolerantDouble& a, const TolerantDouble& b) {
    return a.value_ < b.value_ ? b : a;
  }

  friend Verdict less(const TolerantDouble& a, const TolerantDouble& b) {
    const double difference = b.value_ - a.value_;
    if (difference > tolerance) return Verdict::proved;
    return difference < -tolerance ? Verdict::refuted : Verdict::undecided;
  }
  friend Verdict less_equal(const TolerantDouble& a, const TolerantDouble& b) { return negation(less(b, a)); }
  friend Verdict is_zero(const TolerantDouble& a) {
    return std::fabs(a.value_) > tolerance ? Verdict::refuted : Verdict::undecided;
  }

 private:
  struct Unchecked {};
  TolerantDouble(double value, Unchecked) : value_(value) {}
  double value_ = 0;
};

}  // namespace delcert
