#pragma once

#include <cmath>
#include <concepts>

#include "kernel/number/verdict.hpp"

namespace delcert {

/// A double in rounding to nearest with the interface of `Interval`, without error bounds: nothing rests on it. What it
/// says of an order is what `Order::less` and `Order::is_zero` say of the doubles.
template <class Order>
class NearestDouble {
 public:
  NearestDouble() = default;
  NearestDouble(int integer) : value_(integer) {}

  template <std::floating_point T>
  NearestDouble(T) = delete;

  [[nodiscard]] static NearestDouble exactly(double value) { return NearestDouble(value, Unchecked{}); }
  /// The midpoint.
  [[nodiscard]] static NearestDouble between(double lower, double upper) {
    return exactly(lower + (upper - lower) / 2);
  }

  [[nodiscard]] double lower() const { return value_; }
  [[nodiscard]] double upper() const { return value_; }

  friend NearestDouble operator+(const NearestDouble& a, const NearestDouble& b) {
    return exactly(a.value_ + b.value_);
  }
  friend NearestDouble operator-(const NearestDouble& a, const NearestDouble& b) {
    return exactly(a.value_ - b.value_);
  }
  friend NearestDouble operator*(const NearestDouble& a, const NearestDouble& b) {
    return exactly(a.value_ * b.value_);
  }
  friend NearestDouble operator/(const NearestDouble& a, const NearestDouble& b) {
    return exactly(a.value_ / b.value_);
  }
  friend NearestDouble operator-(const NearestDouble& a) { return exactly(-a.value_); }
  NearestDouble& operator+=(const NearestDouble& b) { return *this = *this + b; }
  NearestDouble& operator-=(const NearestDouble& b) { return *this = *this - b; }
  NearestDouble& operator*=(const NearestDouble& b) { return *this = *this * b; }

  friend NearestDouble square(const NearestDouble& a) { return exactly(a.value_ * a.value_); }
  friend NearestDouble square_root(const NearestDouble& a) { return exactly(a.value_ > 0 ? std::sqrt(a.value_) : 0); }
  friend NearestDouble absolute(const NearestDouble& a) { return exactly(std::fabs(a.value_)); }
  friend NearestDouble minimum(const NearestDouble& a, const NearestDouble& b) { return b.value_ < a.value_ ? b : a; }
  friend NearestDouble maximum(const NearestDouble& a, const NearestDouble& b) { return a.value_ < b.value_ ? b : a; }

  friend Verdict less(const NearestDouble& a, const NearestDouble& b) { return Order::less(a.value_, b.value_); }
  friend Verdict less_equal(const NearestDouble& a, const NearestDouble& b) { return negation(less(b, a)); }
  friend Verdict is_zero(const NearestDouble& a) { return Order::is_zero(a.value_); }

 private:
  struct Unchecked {};
  NearestDouble(double value, Unchecked) : value_(value) {}
  double value_ = 0;
};

}  // namespace delcert
