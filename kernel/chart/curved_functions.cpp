#include "kernel/chart/curved_functions.hpp"

#include <array>
#include <limits>

#include "kernel/number/scalar.hpp"

namespace delcert {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Σ_{k ≤ last} (−K)ᵏ c_k xᵏ widened by the bound of what was left out.
template <std::size_t last, std::size_t size>
Interval series(Curvature curvature, const std::array<Interval, size>& coefficients, const Interval& x,
                double remainder) {
  static_assert(last < size);
  const Interval step = curvature == Curvature::positive ? -x : x;
  Interval result = coefficients[last];
  for (std::size_t k = last; k > 0; --k) result = coefficients[k - 1] + step * result;
  return result + Interval::between(-remainder, remainder);
}

// Of cos √s and sin √s / √s, for s ≤ 1/16 and for s ≤ 4. The terms left out fall by more than half each, so they sum
// up to less than twice the first: 2·(1/16)⁸/16! < 2⁻⁷⁵, 2·4¹⁴/28! < 2⁻⁶⁸.
constexpr std::size_t trigonometric_terms = 14;
constexpr double few_terms_reach = 0x1p-4;
constexpr std::size_t few_terms_last = 7;
constexpr double few_terms_remainder = 0x1p-75;
constexpr double all_terms_reach = 4;
constexpr double all_terms_remainder = 0x1p-68;

/// 1/(2k + odd)! for k = 0, 1, …
std::array<Interval, trigonometric_terms> inverse_factorials(long odd) {
  std::array<Interval, trigonometric_terms> result;
  Rational factorial(1);
  for (std::size_t k = 0; k < trigonometric_terms; ++k) {
    const long n = 2 * static_cast<long>(k) + odd;
    if (k > 0) factorial *= Rational(n) * Rational(n - 1);
    result[k] = scalar_from<Interval>(Rational(1) / factorial);
  }
  return result;
}

/// Precondition: s ≤ all_terms_reach.
Interval trigonometric_series(Curvature curvature, const std::array<Interval, trigonometric_terms>& coefficients,
                              const Interval& s) {
  if (s.upper() <= few_terms_reach) return series<few_terms_last>(curvature, coefficients, s, few_terms_remainder);
  return series<trigonometric_terms - 1>(curvature, coefficients, s, all_terms_remainder);
}

// Of arctan √q / √q for q ≤ 1/64: what is left out is less than (1/64)¹⁰/21·64/63 < 2⁻⁶⁴.
constexpr std::size_t arctangent_terms = 10;
constexpr double arctangent_reach = 0x1p-6;
constexpr double arctangent_remainder = 0x1p-64;

std::array<Interval, arctangent_terms> inverse_odd_numbers() {
  std::array<Interval, arctangent_terms> result;
  for (std::size_t k = 0; k < arctangent_terms; ++k)
    result[k] = scalar_from<Interval>(Rational(1) / Rational(2 * k + 1));
  return result;
}

Interval cut_off_below_zero(const Interval& x) {
  return Interval::between(x.lower() > 0 ? x.lower() : 0, x.upper() > 0 ? x.upper() : 0);
}

BigInterval cut_off_below_zero(const BigInterval& x) { return maximum(x, BigInterval(0)); }

bool is_zero_exactly(const BigInterval& x) { return is_proved(is_zero(x)); }

bool is_infinite(const BigInterval& end) { return mpfr_inf_p(&end.mpfi()->left) != 0; }

/// The hull of the values at both ends of a monotone function.
template <class Function>
BigInterval monotone(const Function& function, const BigInterval& x) {
  return hull(function(lower_end(x)), function(upper_end(x)));
}

/// What holds of every cosine, and of sin x/x.
BigInterval from_minus_one_to_one() { return hull(BigInterval(-1), BigInterval(1)); }

}  // namespace

Interval cosine_of_root(Curvature curvature, const Interval& s) {
  if (curvature == Curvature::zero) return Interval(1);
  static const auto coefficients = inverse_factorials(0);
  const Interval argument = cut_off_below_zero(s);
  if (argument.upper() <= all_terms_reach) return trigonometric_series(curvature, coefficients, argument);
  return in_doubles(cosine_of_root(curvature, in_big(argument)));
}

Interval sine_ratio(Curvature curvature, const Interval& s) {
  if (curvature == Curvature::zero) return Interval(1);
  static const auto coefficients = inverse_factorials(1);
  const Interval argument = cut_off_below_zero(s);
  if (argument.upper() <= all_terms_reach) return trigonometric_series(curvature, coefficients, argument);
  return in_doubles(sine_ratio(curvature, in_big(argument)));
}

Interval arctangent_ratio(Curvature curvature, const Interval& q) {
  if (curvature == Curvature::zero) return Interval(1);
  static const auto coefficients = inverse_odd_numbers();
  Interval rest = cut_off_below_zero(q);
  if (rest.upper() == infinity || (curvature == Curvature::negative && rest.upper() >= 1))
    return in_doubles(arctangent_ratio(curvature, in_big(rest)));
  // tan(y/2) = tan y / (1 + √(1 + tan² y)), and so for tanh.
  Interval factor(1);
  while (rest.upper() > arctangent_reach) {
    const Interval root = Interval(1) + square_root(Interval(1) + (curvature == Curvature::positive ? rest : -rest));
    factor *= Interval(2) / root;
    rest = rest / square(root);
  }
  return factor * series<arctangent_terms - 1>(curvature, coefficients, rest, arctangent_remainder);
}

BigInterval cosine_of_root(Curvature curvature, const BigInterval& s) {
  if (curvature == Curvature::zero) return BigInterval(1);
  const BigInterval argument = cut_off_below_zero(s);
  if (curvature == Curvature::negative) return hyperbolic_cosine(square_root(argument));
  return monotone(
      [](const BigInterval& end) {
        if (!is_proved(less(end, square(half_turn())))) return from_minus_one_to_one();
        return cosine(square_root(end));
      },
      argument);
}

BigInterval sine_ratio(Curvature curvature, const BigInterval& s) {
  if (curvature == Curvature::zero) return BigInterval(1);
  const auto value = [curvature](const BigInterval& end) {
    if (is_zero_exactly(end)) return BigInterval(1);
    if (is_infinite(end)) return curvature == Curvature::positive ? from_minus_one_to_one() : end;
    if (curvature == Curvature::positive && !is_proved(less(end, square(half_turn())))) return from_minus_one_to_one();
    const BigInterval root = square_root(end);
    return (curvature == Curvature::positive ? sine(root) : hyperbolic_sine(root)) / root;
  };
  return monotone(value, cut_off_below_zero(s));
}

BigInterval arctangent_ratio(Curvature curvature, const BigInterval& q) {
  if (curvature == Curvature::zero) return BigInterval(1);
  const auto value = [curvature](const BigInterval& end) {
    if (is_zero_exactly(end)) return BigInterval(1);
    if (is_infinite(end)) return curvature == Curvature::positive ? BigInterval(0) : end;
    const BigInterval root = square_root(end);
    return (curvature == Curvature::positive ? arctangent(root) : area_tangent(root)) / root;
  };
  return monotone(value, cut_off_below_zero(q));
}

}  // namespace delcert
