#pragma once

#include <cmath>
#include <concepts>

#include "kernel/number/scalar.hpp"

namespace delcert {

/// A double in rounding to nearest with the interface of `Interval`, without error bounds: its verdicts are always
/// proved or refuted, and may be wrong. For what is proposed or chosen by, on which nothing rests.
class PlainDouble {
 public:
  PlainDouble() = default;
  PlainDouble(int integer) : value_(integer) {}

  template <std::floating_point T>
  PlainDouble(T) = delete;

  [[nodiscard]] static PlainDouble exactly(double value) { return PlainDouble(value, Unchecked{}); }
  /// The midpoint.
  [[nodiscard]] static PlainDouble between(double lower, double upper) {
    return PlainDouble(lower + (upper - lower) / 2, Unchecked{});
  }

  [[nodiscard]] double lower() const { return value_; }
  [[nodiscard]] double upper() const { return value_; }

  friend PlainDouble operator+(const PlainDouble& a, const PlainDouble& b) { return exactly(a.value_ + b.value_); }
  friend PlainDouble operator-(const PlainDouble& a, const PlainDouble& b) { return exactly(a.value_ - b.value_); }
  friend PlainDouble operator*(const PlainDouble& a, const PlainDouble& b) { return exactly(a.value_ * b.value_); }
  friend PlainDouble operator/(const PlainDouble& a, const PlainDouble& b) { return exactly(a.value_ / b.value_); }
  friend PlainDouble operator-(const PlainDouble& a) { return exactly(-a.value_); }
  PlainDouble& operator+=(const PlainDouble& b) { return *this = *this + b; }
  PlainDouble& operator-=(const PlainDouble& b) { return *this = *this - b; }
  PlainDouble& operator*=(const PlainDouble& b) { return *this = *this * b; }

  friend PlainDouble square(const PlainDouble& a) { return exactly(a.value_ * a.value_); }
  friend PlainDouble square_root(const PlainDouble& a) { return exactly(a.value_ > 0 ? std::sqrt(a.value_) : 0); }
  friend PlainDouble absolute(const PlainDouble& a) { return exactly(std::fabs(a.value_)); }
  friend PlainDouble minimum(const PlainDouble& a, const PlainDouble& b) { return b.value_ < a.value_ ? b : a; }
  friend PlainDouble maximum(const PlainDouble& a, const PlainDouble& b) { return a.value_ < b.value_ ? b : a; }

  friend Verdict less(const PlainDouble& a, const PlainDouble& b) { return verdict_of(a.value_ < b.value_); }
  friend Verdict less_equal(const PlainDouble& a, const PlainDouble& b) { return negation(less(b, a)); }
  friend Verdict is_zero(const PlainDouble& a) { return verdict_of(a.value_ == 0); }

 private:
  struct Unchecked {};
  PlainDouble(double value, Unchecked) : value_(value) {}
  double value_ = 0;
};

/// A double next to x.
template <>
[[nodiscard]] inline PlainDouble scalar_from<PlainDouble>(const Rational& x) {
  return PlainDouble::exactly(approximate_double(x));
}

}  // namespace delcert
