#pragma once

#include <cmath>
#include <limits>

#ifdef __SSE2__
#include <emmintrin.h>
#endif

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
  explicit Interval(int value) : ends_{static_cast<double>(-value), static_cast<double>(value)} {}

  /// Precondition: lower <= upper.
  static Interval between(double lower, double upper) { return Interval(Pair{-lower, upper}); }

  double lower() const { return -ends_[0]; }
  double upper() const { return ends_[1]; }

  friend Interval operator+(const Interval& a, const Interval& b) { return Interval(a.ends_ + b.ends_); }
  friend Interval operator-(const Interval& a, const Interval& b) { return Interval(a.ends_ + exchanged(b.ends_)); }
  friend Interval operator-(const Interval& a) { return Interval(exchanged(a.ends_)); }

  /// The extreme products are among those of the endpoints: with a = [-p, q] and b = [-r, s] the greatest ones of
  /// (ps, pr), (qr, qs), (-pr, -ps) and (-qs, -qr) are minus the lower and the upper endpoint. The whole line if an
  /// endpoint is infinite (or nearly), so that no product is NaN.
  friend Interval operator*(const Interval& a, const Interval& b) {
    const Pair sums = a.ends_ + b.ends_;
    if (!(sums[0] + sums[1] < infinity)) return whole_line();
    const Pair p = twice(a.ends_[0]), q = twice(a.ends_[1]), other = exchanged(b.ends_);
    return Interval(greater(greater(p * other, q * b.ends_), greater(-p * b.ends_, -q * other)));
  }

  /// The whole line if b contains 0.
  friend Interval operator/(const Interval& a, const Interval& b) {
    if (b.ends_[0] >= 0 && b.ends_[1] >= 0) return whole_line();
    return a * Interval(Pair{-1 / b.ends_[1], -1 / b.ends_[0]});
  }

  friend Interval square(const Interval& a) {
    const double outer = larger(a.ends_[0], a.ends_[1]);
    if (a.ends_[0] >= 0 && a.ends_[1] >= 0) return Interval(Pair{0, outer * outer});
    const double inner = a.ends_[0] < 0 ? a.ends_[0] : a.ends_[1];
    return Interval(Pair{-inner * inner, outer * outer});
  }

  friend Interval maximum(const Interval& a, const Interval& b) {
    return Interval(Pair{a.ends_[0] < b.ends_[0] ? a.ends_[0] : b.ends_[0], larger(a.ends_[1], b.ends_[1])});
  }

  friend Verdict less(const Interval& a, const Interval& b) {
    if (a.upper() < b.lower()) return Verdict::proved;
    return a.lower() >= b.upper() ? Verdict::refuted : Verdict::undecided;
  }

  /// Negative parts of the argument are known not to occur.
  friend Interval square_root(const Interval& a) {
    const double above = a.lower() > 0 ? std::sqrt(a.lower()) : 0;  // rounded upwards: x / above <= sqrt x
    return Interval(Pair{above > 0 ? a.ends_[0] / above : 0, upper_root(a)});
  }

  /// An upper bound of the square root; negative parts of the argument are known not to occur.
  friend double upper_root(const Interval& a) { return a.upper() > 0 ? std::sqrt(a.upper()) : 0; }

 private:
  /// Two doubles in one register (an extension of GCC and clang): operations work on each.
  using Pair [[gnu::vector_size(16)]] = double;
  explicit Interval(Pair ends) : ends_(ends) {}

  static constexpr double infinity = std::numeric_limits<double>::infinity();
  static Interval whole_line() { return Interval(Pair{infinity, infinity}); }
  static Pair exchanged(Pair a) { return Pair{a[1], a[0]}; }
  static Pair twice(double x) { return Pair{x, x}; }
  static double larger(double a, double b) { return a > b ? a : b; }
  static Pair greater(Pair a, Pair b) {
#ifdef __SSE2__
    return _mm_max_pd(a, b);
#else
    return Pair{larger(a[0], b[0]), larger(a[1], b[1])};
#endif
  }

  Pair ends_{0, 0};  // minus the lower endpoint, the upper endpoint
};

}  // namespace delcert::checker
