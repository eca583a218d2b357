#include "proofs/checker/geometry/curved.hpp"

namespace delcert::checker {
namespace {

constexpr int terms = 13;

/// 1 / (2k + 1).
const std::array<Interval, terms>& odd_reciprocals() {
  static const std::array<Interval, terms> table = [] {
    std::array<Interval, terms> result;
    for (int k = 0; k < terms; ++k) result[static_cast<std::size_t>(k)] = Interval(1) / Interval(2 * k + 1);
    return result;
  }();
  return table;
}

Ball exactly(double x) {
  Ball result;
  arb_set_d(result.raw(), x);
  return result;
}

}  // namespace

Interval logarithm_factor(int K, const Interval& q) {
  if (K == 0) return Interval(1);
  if (!(q.upper() <= 0x1p-4)) {
    if (!(q.lower() >= 0 && q.upper() < (K > 0 ? 0x1p60 : 1)))
      return Interval::between(-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity());
    return in_balls(80, [&] {  // monotone
      return joined(logarithm_factor(K, exactly(q.lower())), logarithm_factor(K, exactly(q.upper()))).enclosure();
    });
  }
  // The sum of (-K q)^k / (2k + 1) for k < number. What is left out is at most q^number / ((2 number + 1) (1 - q)).
  const double most = q.upper();
  const std::size_t number = most <= 0x1p-14 ? 4 : most <= 0x1p-8 ? 7 : most <= 0x1p-6 ? 9 : std::size_t{terms};
  const Interval argument = K > 0 ? -q : q;
  Interval sum(0);
  for (std::size_t k = number; k-- > 0;) sum = sum * argument + odd_reciprocals()[k];
  return sum + Interval::between(-0x1p-56, 0x1p-56);
}

Ball logarithm_factor(int K, const Ball& q) {
  if (K == 0) return Ball(1);
  if (arb_is_positive(q.raw()) == 0) {
    // 1 >= arctan(x)/x >= 1 - x^2 and 1 <= artanh(x)/x <= 1/(1 - x^2).
    const Ball most = maximum(q, Ball(0));
    return joined(Ball(1), K > 0 ? Ball(1) - most : Ball(1) / (Ball(1) - most));
  }
  const Ball root = square_root(q);
  return Ball::apply(K > 0 ? arb_atan : arb_atanh, root) / root;
}

Ball tangent(int K, const Ball& r) { return K == 0 ? r : Ball::apply(K > 0 ? arb_tan : arb_tanh, r); }

Ball sine(int K, const Ball& r) { return K == 0 ? r : Ball::apply(K > 0 ? arb_sin : arb_sinh, r); }

Ball versed_sine(int K, const Ball& r) { return Ball(2) * square(sine(K, r / Ball(2))); }

Vector<Ball> exponential(int K, std::size_t m, const Vector<Ball>& v) {
  const Ball length_squared = squared(v, m);
  Vector<Ball> x{};
  x[0] = Ball(1);
  if (arb_is_zero(length_squared.raw()) != 0) return x;
  const Ball length = square_root(length_squared), factor = sine(K, length) / length;
  if (K != 0) x[0] = Ball::apply(K > 0 ? arb_cos : arb_cosh, length);
  for (std::size_t k = 0; k < m; ++k) x[k + 1] = v[k] * factor;
  return x;
}

}  // namespace delcert::checker
