#pragma once

#include <array>
#include <cmath>
#include <cstddef>

namespace delcert {

/// What is known beforehand of a quantity that doubles compute, whatever the operands are: `largest` bounds its
/// absolute value, exact or computed, and `error` the difference of both. A formula that is written once for all types
/// of numbers and evaluated in this one tells how far the same formula in doubles may be wrong
/// (docs/rounded-spheres.md has the proof).
///
/// Holds in every rounding mode, with fused products or without, and where results underflow. Infinite if something may
/// overflow.
class RoundingBound {
 public:
  /// Nothing but 0.
  RoundingBound() = default;
  /// An integer that is a double, exactly.
  RoundingBound(int integer) : largest_(std::fabs(static_cast<double>(integer))) {}
  /// A quantity of at most this size that is known up to this error. Preconditions: both are at least 0.
  [[nodiscard]] static RoundingBound of(double largest, double error) { return {widened(largest), widened(error)}; }

  [[nodiscard]] double largest() const { return largest_; }
  [[nodiscard]] double error() const { return error_; }

  /// The same quantity, if its absolute value, exact and computed, is known to be at most this.
  [[nodiscard]] RoundingBound at_most(double largest) const { return {std::fmin(largest_, widened(largest)), error_}; }

  friend RoundingBound operator+(const RoundingBound& a, const RoundingBound& b) {
    const double largest = a.largest_ + b.largest_;
    return {widened(largest * (1 + unit)), widened(a.error_ + b.error_ + unit * largest)};
  }
  friend RoundingBound operator-(const RoundingBound& a, const RoundingBound& b) { return a + b; }
  friend RoundingBound operator-(const RoundingBound& a) { return a; }
  friend RoundingBound operator*(const RoundingBound& a, const RoundingBound& b) {
    const double largest = a.largest_ * b.largest_;
    return {widened(largest * (1 + unit)) + tiny,
            widened(a.largest_ * b.error_ + b.largest_ * a.error_ + unit * largest) + tiny};
  }
  RoundingBound& operator+=(const RoundingBound& b) { return *this = *this + b; }
  RoundingBound& operator-=(const RoundingBound& b) { return *this = *this - b; }

  friend RoundingBound absolute(const RoundingBound& a) { return a; }
  /// √(Σ aᵢ²).
  template <std::size_t n>
  friend RoundingBound norm(const std::array<RoundingBound, n>& a) {
    // The norm of the differences, and the relative error of the computed one: (1 + n)/2 units below the root, one of
    // it.
    constexpr double units = (static_cast<double>(n) + 4) * unit;
    double largest = 0;
    double error = 0;
    for (const RoundingBound& x : a) {
      largest += x.largest_;
      error += x.error_;
    }
    return {widened(largest * (1 + units)) + tiny, widened(error + units * largest) + tiny};
  }

 private:
  RoundingBound(double largest, double error) : largest_(largest), error_(error) {}

  /// How far an operation on doubles is from the exact result, relative to it, however it rounds.
  static constexpr double unit = 0x1p-52;
  /// More than what underflow loses, also below a root of squares.
  static constexpr double tiny = 0x1p-500;
  /// The few operations that computed x may have rounded it downwards.
  [[nodiscard]] static double widened(double x) { return x * (1 + 0x1p-40); }

  double largest_ = 0;
  double error_ = 0;
};

template <std::size_t n>
RoundingBound norm(const std::array<RoundingBound, n>& a);

/// √(Σ aᵢ²) of doubles. Precondition: the squares do not overflow.
template <std::size_t n>
[[nodiscard]] [[gnu::always_inline]] inline double norm(const std::array<double, n>& a) {
  double squared = a[0] * a[0];
  for (std::size_t axis = 1; axis < n; ++axis) squared += a[axis] * a[axis];
  return std::sqrt(squared);
}

[[nodiscard]] inline double absolute(double x) { return std::fabs(x); }

/// Whether to change the sign, which changes no bound.
[[nodiscard]] inline bool is_negative(double x) { return x < 0; }
[[nodiscard]] inline bool is_negative(const RoundingBound&) { return false; }

}  // namespace delcert
