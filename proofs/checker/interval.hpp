#pragma once

#include <cmath>
#include <limits>

namespace delcert::checker {

/// The outcome of a comparison. There is no conversion to bool: whoever asks says what undecided means.
enum class Verdict { refuted, undecided, proved };

constexpr Verdict verdict(bool truth) { return truth ? Verdict::proved : Verdict::refuted; }
constexpr Verdict conjunction(Verdict a, Verdict b) { return a < b ? a : b; }
constexpr Verdict disjunction(Verdict a, Verdict b) { return a < b ? b : a; }
constexpr Verdict negation(Verdict v) {
  return v == Verdict::undecided ? v : v == Verdict::proved ? Verdict::refuted : Verdict::proved;
}

/// A closed interval of real numbers with double endpoints, which may be infinite: the filter.
///
/// Precondition of every operation: the thread rounds upwards (FE_UPWARD). The lower endpoint is kept negated, so that
/// rounding upwards moves both endpoints outwards. The result contains every exact result for arguments in the
/// operands. Invariant: neither field is NaN or minus infinity.
class Interval {
 public:
  Interval() = default;
  explicit Interval(int value) : minus_lower_(-value), upper_(value) {}

  /// Precondition: lower <= upper.
  static Interval between(double lower, double upper) { return {-lower, upper}; }

  double lower() const { return -minus_lower_; }
  double upper() const { return upper_; }

  friend Interval operator+(const Interval& a, const Interval& b) {
    return {a.minus_lower_ + b.minus_lower_, a.upper_ + b.upper_};
  }
  friend Interval operator-(const Interval& a, const Interval& b) {
    return {a.minus_lower_ + b.upper_, a.upper_ + b.minus_lower_};
  }
  friend Interval operator-(const Interval& a) { return {a.upper_, a.minus_lower_}; }

  /// The extreme products are among those of the endpoints. The whole line if an endpoint is infinite (or nearly), so
  /// that no product is NaN.
  friend Interval operator*(const Interval& a, const Interval& b) {
    if (!(a.minus_lower_ + a.upper_ + b.minus_lower_ + b.upper_ < infinity)) return {infinity, infinity};
    return {larger(larger(a.minus_lower_ * -b.minus_lower_, a.minus_lower_ * b.upper_),
                   larger(a.upper_ * b.minus_lower_, -a.upper_ * b.upper_)),
            larger(larger(a.minus_lower_ * b.minus_lower_, -a.minus_lower_ * b.upper_),
                   larger(a.upper_ * -b.minus_lower_, a.upper_ * b.upper_))};
  }

  /// The whole line if b contains 0.
  friend Interval operator/(const Interval& a, const Interval& b) {
    if (b.minus_lower_ >= 0 && b.upper_ >= 0) return {infinity, infinity};
    return a * Interval{-1 / b.upper_, -1 / b.minus_lower_};
  }

  friend Interval square(const Interval& a) {
    const double outer = larger(a.minus_lower_, a.upper_);
    if (a.minus_lower_ >= 0 && a.upper_ >= 0) return {0, outer * outer};
    const double inner = a.minus_lower_ < 0 ? a.minus_lower_ : a.upper_;
    return {-inner * inner, outer * outer};
  }

  friend Interval maximum(const Interval& a, const Interval& b) {
    return {a.minus_lower_ < b.minus_lower_ ? a.minus_lower_ : b.minus_lower_, larger(a.upper_, b.upper_)};
  }

  friend Verdict less(const Interval& a, const Interval& b) {
    if (a.upper_ < -b.minus_lower_) return Verdict::proved;
    return -a.minus_lower_ >= b.upper_ ? Verdict::refuted : Verdict::undecided;
  }

  /// Negative parts of the argument are known not to occur.
  friend Interval square_root(const Interval& a) {
    const double above = -a.minus_lower_ > 0 ? std::sqrt(-a.minus_lower_) : 0;  // rounded upwards: x / above <= sqrt x
    return {above > 0 ? a.minus_lower_ / above : 0, upper_root(a)};
  }

  /// An upper bound of the square root; negative parts of the argument are known not to occur.
  friend double upper_root(const Interval& a) { return a.upper_ > 0 ? std::sqrt(a.upper_) : 0; }

 private:
  static constexpr double infinity = std::numeric_limits<double>::infinity();
  Interval(double minus_lower, double upper) : minus_lower_(minus_lower), upper_(upper) {}
  static double larger(double a, double b) { return a > b ? a : b; }

  double minus_lower_ = 0;
  double upper_ = 0;
};

}  // namespace delcert::checker
