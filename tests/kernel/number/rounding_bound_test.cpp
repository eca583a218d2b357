#include "kernel/number/rounding_bound.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <random>

#include "kernel/number/rational.hpp"
#include "kernel/number/rounding_guard.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

/// A formula with every operation, on any type of numbers; the value is a polynomial.
template <class S>
S formula(const S& a, const S& b, const S& c) {
  S result = a * b - c * c;
  result += S(3) * (a - b) * (b + c);
  result -= -a;
  return result * absolute(b);
}

Rational absolute_of(const Rational& x) { return x < Rational(0) ? -x : x; }

/// How far doubles are from the exact value for doubles that stand for exact numbers near them.
struct Worst {
  double error = 0;    // relative to its bound
  double largest = 0;  // likewise
};

Worst worst_of(double size, double input_error, int samples, const RoundingBound& bound) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> coordinate(-size, size);
  Worst result;
  for (int sample = 0; sample < samples; ++sample) {
    std::array<double, 3> rounded{};
    std::array<Rational, 3> exact{Rational(0), Rational(0), Rational(0)};
    for (std::size_t at = 0; at < 3; ++at) {
      rounded[at] = sample % 3 == 0 ? std::copysign(size, coordinate(random)) : coordinate(random);
      const Rational step = Rational::exactly(input_error) * Rational(random() % 2 == 0 ? 1 : -1);
      exact[at] = Rational::exactly(rounded[at]) + step;
      if (absolute_of(exact[at]) > Rational::exactly(size)) exact[at] = Rational::exactly(rounded[at]);
    }
    const double computed = formula(rounded[0], rounded[1], rounded[2]);
    const Rational truth = [&] {
      const auto& [a, b, c] = exact;
      return (a * b - c * c + Rational(3) * (a - b) * (b + c) + a) * absolute_of(b);
    }();
    const double error = approximate_double(absolute_of(Rational::exactly(computed) - truth));
    result.error = std::max(result.error, error / bound.error());
    result.largest = std::max(result.largest, std::abs(computed) / bound.largest());
  }
  return result;
}

TEST(RoundingBound, holds_for_a_formula_in_every_rounding_mode) {
  for (const double size : {1.0, 3e-7, 5e9}) {
    for (const double relative : {0.0, 0x1p-52, 0x1p-20}) {
      const RoundingBound x = RoundingBound::of(size, relative * size);
      const RoundingBound bound = formula(x, x, x);
      const Worst nearest = worst_of(size, relative * size, 3000, bound);
      EXPECT_LE(nearest.error, 1);
      EXPECT_LE(nearest.largest, 1);
      EXPECT_GT(nearest.largest, 0.2) << "a bound that says little";
      EXPECT_GT(nearest.error, 1e-3) << "a bound that says little";
    }
  }
  const RoundingBound x = RoundingBound::of(1, 0);
  const RoundingBound bound = formula(x, x, x);
  const RoundingGuard upward;
  EXPECT_LE(worst_of(1, 0, 3000, bound).error, 1);
}

/// The twin: what is not counted shows.
TEST(RoundingBound, without_the_errors_of_the_operands_does_not_hold) {
  const RoundingBound x = RoundingBound::of(1, 0);
  EXPECT_GT(worst_of(1, 0x1p-40, 1000, formula(x, x, x)).error, 1);
}

TEST(RoundingBound, of_a_norm_holds) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> coordinate(-1, 1);
  const RoundingBound x = RoundingBound::of(1, 0x1p-30);
  const RoundingBound bound = norm(std::array<RoundingBound, 3>{x, x, x});
  EXPECT_GE(bound.largest(), std::sqrt(3.0));
  EXPECT_LE(bound.error(), 0x1p-28);
  for (int sample = 0; sample < 1000; ++sample) {
    const std::array<double, 3> a{coordinate(random), coordinate(random), coordinate(random)};
    Rational squared(0);
    for (const double coordinate_of_a : a) {
      const Rational near = Rational::exactly(coordinate_of_a) + Rational::power_of_two(-30);
      squared += near * near;
    }
    // |computed − √squared| ≤ error.
    const Rational computed = Rational::exactly(norm(a));
    const Rational error = Rational::exactly(bound.error());
    EXPECT_LE(square(maximum(computed - error, Rational(0))), squared);
    EXPECT_GE(square(computed + error), squared);
  }
}

TEST(RoundingBound, counts_what_underflows_and_gives_up_where_something_may_overflow) {
  const RoundingBound small = RoundingBound::of(1e-200, 0);
  EXPECT_GE((small * small).error(), 1e-400L);
  EXPECT_GT((small * small).error(), 0);
  const RoundingBound large = RoundingBound::of(1e200, 1);
  EXPECT_FALSE((large * large).error() < std::numeric_limits<double>::infinity());
  EXPECT_FALSE((large * large - large * large).error() < std::numeric_limits<double>::infinity());
}

TEST(RoundingBound, of_what_is_exact_is_exact) {
  EXPECT_EQ(RoundingBound().error(), 0);
  EXPECT_EQ(RoundingBound(-3).largest(), 3);
  EXPECT_EQ(RoundingBound(-3).error(), 0);
  EXPECT_EQ((-RoundingBound(3)).largest(), 3);
  EXPECT_LT(RoundingBound::of(8, 1).at_most(2).largest(), 2.001);
  EXPECT_LT(RoundingBound::of(1, 1).at_most(2).largest(), 1.001);
  EXPECT_TRUE(is_negative(-1.0));
  EXPECT_FALSE(is_negative(1.0));
  EXPECT_FALSE(is_negative(RoundingBound(-3)));
  EXPECT_EQ(absolute(-2.0), 2);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
