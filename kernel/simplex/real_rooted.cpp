#include "kernel/simplex/real_rooted.hpp"

#include <mpfr.h>

#include <algorithm>
#include <boost/multiprecision/mpfr.hpp>
#include <cmath>

#include "kernel/simplex/bisection.hpp"

namespace delcert {

namespace {

using Real =
    boost::multiprecision::number<boost::multiprecision::mpfr_float_backend<110, boost::multiprecision::allocate_stack>,
                                  boost::multiprecision::et_off>;

/// The sign at numerator·2^exponent of the polynomial with these coefficients, that of x⁰ first.
int sign_at(const std::vector<Integer>& coefficients, const Integer& numerator, long exponent) {
  // Times 2^(−exponent·degree), or not, so that everything is an integer.
  const auto down = static_cast<mp_bitcnt_t>(std::max(0L, -exponent));
  Integer x;
  mpz_mul_2exp(x.backend().data(), numerator.backend().data(), static_cast<mp_bitcnt_t>(std::max(0L, exponent)));
  const std::size_t degree = coefficients.size() - 1;
  Integer value;
  Integer term;
  for (std::size_t power = degree + 1; power-- > 0;) {
    mpz_mul_2exp(term.backend().data(), coefficients[power].backend().data(), down * (degree - power));
    value = value * x + term;
  }
  return mpz_sgn(value.backend().data());
}

/// The least root in size by Laguerre's method from 0, which converges where all roots are real; `known` are left out.
/// Until it moves by less than 2^−bits of itself; without error bounds; nothing where it does not converge.
template <class Real>
std::optional<Real> approximate_root(const std::vector<Real>& coefficients, const std::vector<Real>& known, int bits,
                                     int most_steps) {
  using std::abs;
  using std::ldexp;
  using std::sqrt;
  const Real close = ldexp(Real(1), -bits);
  const auto remaining = static_cast<int>(coefficients.size() - 1 - known.size());
  Real x(0);
  for (int step = 0; step < most_steps; ++step) {
    Real value(0);
    Real slope(0);
    Real half_bend(0);
    for (std::size_t at = coefficients.size(); at-- > 0;) {
      half_bend = half_bend * x + slope;
      slope = slope * x + value;
      value = value * x + coefficients[at];
    }
    if (value == 0) return x;
    Real first = slope / value;
    Real second = first * first - 2 * half_bend / value;
    for (const Real& root : known) {
      const Real inverse = 1 / (x - root);
      first -= inverse;
      second -= inverse * inverse;
    }
    const Real under_root = (remaining - 1) * (remaining * second - first * first);
    const Real root = under_root > 0 ? Real(sqrt(under_root)) : Real(0);
    const Real divisor = first > 0 ? Real(first + root) : Real(first - root);
    const Real change = remaining / divisor;
    if (!(change - change == 0)) return std::nullopt;  // not finite
    x -= change;
    if (abs(change) <= abs(x) * close) return x;
  }
  return std::nullopt;
}

/// The root near an approximation by Newton's method; nothing where it does not converge quickly.
std::optional<Real> polished_root(const std::vector<Real>& coefficients, Real x) {
  constexpr int most_steps = 6;
  const Real close = ldexp(Real(1), -160);  // the next step would be twice as close
  for (int step = 0; step < most_steps; ++step) {
    Real value(0);
    Real slope(0);
    for (std::size_t at = coefficients.size(); at-- > 0;) {
      slope = slope * x + value;
      value = value * x + coefficients[at];
    }
    const Real change = value / slope;
    if (!(boost::multiprecision::isfinite)(change)) return std::nullopt;
    x -= change;
    if (abs(change) <= abs(x) * close) return x;
  }
  return std::nullopt;
}

/// All roots, where they are far enough from each other to be found in machine numbers first, in any order.
/// Without error bounds.
std::optional<std::vector<Real>> roots_from_machine_numbers(const std::vector<Real>& coefficients) {
  constexpr int machine_bits = 50;
  constexpr int most_steps = 20;
  const Real apart = ldexp(Real(1), -20);
  std::vector<long double> rounded;
  for (const Real& coefficient : coefficients) rounded.push_back(mpfr_get_ld(coefficient.backend().data(), MPFR_RNDN));
  std::vector<long double> approximate;
  std::vector<Real> result;
  while (result.size() + 1 < coefficients.size()) {
    const auto near = approximate_root(rounded, approximate, machine_bits, most_steps);
    if (!near) return std::nullopt;
    approximate.push_back(*near);
    const auto root = polished_root(coefficients, Real(*near));
    if (!root) return std::nullopt;
    for (const Real& other : result) {
      if (abs(*root - other) <= abs(other) * apart) return std::nullopt;
    }
    result.push_back(*root);
  }
  return result;
}

/// All roots, in any order, without error bounds; nothing where they are not found.
std::optional<std::vector<Real>> approximate_roots(const std::vector<Real>& coefficients) {
  if (auto roots = roots_from_machine_numbers(coefficients)) return roots;
  constexpr int bits = 290;
  constexpr int most_steps = 100;
  std::vector<Real> result;
  while (result.size() + 1 < coefficients.size()) {
    const auto root = approximate_root(coefficients, result, bits, most_steps);
    if (!root || *root == 0) return std::nullopt;
    result.push_back(*root);
  }
  return result;
}

/// numerator·2^exponent
struct Dyadic {
  Integer numerator;
  long exponent = 0;
};

/// A number of any precision, for Newton's method.
class LongReal {
 public:
  explicit LongReal(long bits) { mpfr_init2(value_, bits); }
  LongReal(const LongReal&) = delete;
  LongReal& operator=(const LongReal&) = delete;
  ~LongReal() { mpfr_clear(value_); }
  [[nodiscard]] mpfr_ptr get() { return value_; }

 private:
  mpfr_t value_;
};

/// The approximation of a simple root to so many bits, by Newton's method. Without error bounds.
Dyadic refined(const std::vector<Integer>& coefficients, const Real& root, long bits) {
  constexpr long known_bits = 200;
  const long working_bits = std::max(2 * known_bits, bits + 64);
  LongReal x(working_bits);
  LongReal value(working_bits);
  LongReal slope(working_bits);
  mpfr_set(x.get(), root.backend().data(), MPFR_RNDN);
  for (long correct = known_bits; correct < bits + 16; correct *= 2) {
    mpfr_set_zero(value.get(), 1);
    mpfr_set_zero(slope.get(), 1);
    for (std::size_t at = coefficients.size(); at-- > 0;) {
      mpfr_mul(slope.get(), slope.get(), x.get(), MPFR_RNDN);
      mpfr_add(slope.get(), slope.get(), value.get(), MPFR_RNDN);
      mpfr_mul(value.get(), value.get(), x.get(), MPFR_RNDN);
      mpfr_add_z(value.get(), value.get(), coefficients[at].backend().data(), MPFR_RNDN);
    }
    if (mpfr_zero_p(slope.get()) != 0) break;
    mpfr_div(value.get(), value.get(), slope.get(), MPFR_RNDN);
    mpfr_sub(x.get(), x.get(), value.get(), MPFR_RNDN);
  }
  mpfr_prec_round(x.get(), bits, MPFR_RNDN);
  if (mpfr_regular_p(x.get()) == 0) return {};
  Dyadic result;
  result.exponent = mpfr_get_z_2exp(result.numerator.backend().data(), x.get());
  return result;
}

/// How many roots are greater than x, of a polynomial all of whose roots are real: as many as its Taylor coefficients
/// at x have changes of sign (Descartes' rule, which is exact then).
std::size_t count_above(std::vector<Integer> coefficients, const Integer& x) {
  for (std::size_t lowest = 0; lowest + 1 < coefficients.size(); ++lowest) {
    for (std::size_t at = coefficients.size() - 1; at-- > lowest;) {
      mpz_addmul(coefficients[at].backend().data(), x.backend().data(), coefficients[at + 1].backend().data());
    }
  }
  std::size_t changes = 0;
  int last = 0;
  for (const Integer& coefficient : coefficients) {
    const int sign = mpz_sgn(coefficient.backend().data());
    if (sign == 0) continue;
    if (last == -sign) ++changes;
    last = sign;
  }
  return changes;
}

}  // namespace

std::optional<std::vector<BigInterval>> separated_roots(std::vector<Integer> exact) {
  const auto bits = static_cast<long>(BigInterval::working_precision().value);
  std::vector<Real> coefficients(exact.begin(), exact.end());
  // Roots 0 are known.
  std::vector<BigInterval> result;
  while (exact.front() == 0) {
    exact.erase(exact.begin());
    coefficients.erase(coefficients.begin());
    result.emplace_back(0);
  }
  const auto approximate = approximate_roots(coefficients);
  if (!approximate) return std::nullopt;
  std::vector<RationalBounds> enclosures;
  for (const Real& root : *approximate) {
    const Dyadic near = refined(exact, root, bits);
    if (near.numerator == 0) return std::nullopt;
    bool is_proved = false;
    for (long width = 2; width < bits / 2 && !is_proved; width += bits / 8) {
      const Integer margin = Integer(1) << static_cast<unsigned>(width);
      const Integer lower = near.numerator - margin;
      const Integer upper = near.numerator + margin;
      is_proved = sign_at(exact, lower, near.exponent) * sign_at(exact, upper, near.exponent) < 0;
      if (!is_proved) continue;
      const Rational unit = Rational::power_of_two(near.exponent);
      enclosures.push_back({Rational(lower) * unit, Rational(upper) * unit});
    }
    if (!is_proved) return std::nullopt;
  }
  std::sort(enclosures.begin(), enclosures.end(),
            [](const RationalBounds& a, const RationalBounds& b) { return a.lower < b.lower; });
  for (std::size_t at = 0; at < enclosures.size(); ++at) {
    if (at > 0 && enclosures[at].lower <= enclosures[at - 1].upper) return std::nullopt;
    result.push_back(BigInterval::between(enclosures[at].lower, enclosures[at].upper));
  }
  return result;
}

std::vector<BigInterval> located_roots(const std::vector<Integer>& coefficients, const Integer& size) {
  // As many roots as the counts differ by are greater than the lower end, and not greater than the upper one.
  struct Range {
    Integer lower;
    Integer upper;
    std::size_t above_lower;
    std::size_t above_upper;
  };
  std::vector<BigInterval> result;
  std::vector<Range> ranges{{-size - 1, size, coefficients.size() - 1, 0}};
  while (!ranges.empty()) {
    const Range range = std::move(ranges.back());
    ranges.pop_back();
    const std::size_t inside = range.above_lower - range.above_upper;
    if (inside == 0) continue;
    if (range.upper - range.lower == 1) {
      result.insert(result.end(), inside, BigInterval::between(Rational(range.lower), Rational(range.upper)));
      continue;
    }
    Integer middle = range.lower + range.upper;
    mpz_fdiv_q_2exp(middle.backend().data(), middle.backend().data(), 1);
    const std::size_t above = count_above(coefficients, middle);
    ranges.push_back({range.lower, middle, range.above_lower, above});
    ranges.push_back({middle, range.upper, above, range.above_upper});
  }
  return result;
}

}  // namespace delcert
