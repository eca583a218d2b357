#include "kernel/number/scalar.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "kernel/number/algebraic.hpp"
#include "kernel/number/plain_double.hpp"
#include "kernel/number/rounding_guard.hpp"
#include "tests/kernel/number/random_numbers.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

static_assert(Scalar<Interval> && Scalar<BigInterval> && Scalar<Rational> && Scalar<Algebraic>);
static_assert(!Scalar<double> && !Scalar<int> && !Scalar<Verdict>);

/// The doubles next to x on both sides, or x itself, in either rounding mode.
void expect_tightest(const Rational& x) {
  const Interval interval = scalar_from<Interval>(x);
  ASSERT_TRUE(contains(interval, x));
  const bool is_point = interval.lower() == interval.upper();
  ASSERT_TRUE(is_point ||
              std::nextafter(interval.lower(), std::numeric_limits<double>::infinity()) == interval.upper());
  if (!is_point && std::isfinite(interval.lower()) && std::isfinite(interval.upper())) {
    ASSERT_TRUE(Rational::exactly(interval.lower()) < x && x < Rational::exactly(interval.upper()));
  }
  const RoundingGuard guard;
  const Interval under_guard = scalar_from<Interval>(x);
  ASSERT_EQ(interval.lower(), under_guard.lower());
  ASSERT_EQ(interval.upper(), under_guard.upper());
}

TEST(Scalar, the_interval_of_a_rational_is_the_tightest_that_doubles_give) {
  RandomNumbers random(31);
  for (int round = 0; round < 10000; ++round) {
    const Rational x = Rational::exactly(random.hard_double());
    expect_tightest(x);
    expect_tightest(x / Rational(3));
    expect_tightest(x + Rational::power_of_two(-static_cast<long>(random.below(1200))));
  }
}

TEST(Scalar, rationals_beyond_the_doubles_have_an_infinite_or_a_subnormal_endpoint) {
  const double infinity = std::numeric_limits<double>::infinity();
  const double greatest = std::numeric_limits<double>::max();
  const double least = std::numeric_limits<double>::denorm_min();
  for (const long exponent : {1024L, 1100L, 50000L}) {
    const Rational great = Rational::power_of_two(exponent);
    expect_tightest(great);
    EXPECT_EQ(scalar_from<Interval>(great).lower(), greatest);
    EXPECT_EQ(scalar_from<Interval>(great).upper(), infinity);
    EXPECT_EQ(scalar_from<Interval>(-great).lower(), -infinity);
    EXPECT_EQ(scalar_from<Interval>(-great).upper(), -greatest);
  }
  for (const long exponent : {-1075L, -1100L, -50000L}) {
    const Rational tiny = Rational::power_of_two(exponent);
    EXPECT_EQ(scalar_from<Interval>(tiny).lower(), 0.0);
    EXPECT_EQ(scalar_from<Interval>(tiny).upper(), least);
    EXPECT_EQ(scalar_from<Interval>(-tiny).lower(), -least);
    EXPECT_EQ(scalar_from<Interval>(-tiny).upper(), 0.0);
  }
  EXPECT_EQ(is_zero(scalar_from<Interval>(Rational(0))), Verdict::proved);
}

TEST(Scalar, exact_rungs_take_a_rational_as_it_is_and_big_intervals_enclose_it) {
  const Rational x = Rational(-22) / Rational(7);
  EXPECT_TRUE(scalar_from<Rational>(x) == x);
  EXPECT_TRUE(scalar_from<Algebraic>(x).rational() == x);
  const BigInterval enclosure = scalar_from<BigInterval>(x);
  EXPECT_TRUE(enclosure.lower() < x && x < enclosure.upper());
  EXPECT_TRUE(enclosure.upper() - enclosure.lower() <= Rational::power_of_two(-126));
}

TEST(Scalar, twice_is_the_product_by_two_to_the_last_bit) {
  const RoundingGuard guard;
  RandomNumbers random(33);
  for (int round = 0; round < 1000; ++round) {
    const Rational x = Rational(static_cast<long>(random.below(2001)) - 1000) / Rational(random.below(99) + 1);
    const Rational y = x * Rational::power_of_two(static_cast<long>(random.below(2140)) - 1080);
    ASSERT_TRUE(twice(y) == Rational(2) * y);
    const Interval interval = twice(scalar_from<Interval>(y));
    ASSERT_EQ(interval.lower(), (Interval(2) * scalar_from<Interval>(y)).lower());
    ASSERT_EQ(interval.upper(), (Interval(2) * scalar_from<Interval>(y)).upper());
    const BigInterval big = twice(scalar_from<BigInterval>(y));
    ASSERT_TRUE(big.lower() == Rational(2) * scalar_from<BigInterval>(y).lower());
    ASSERT_TRUE(big.upper() == Rational(2) * scalar_from<BigInterval>(y).upper());
  }
}

/// ((a - b)^2 + a b - 3) / (1 + b^2), whose value every rung must agree on.
template <Scalar S>
S some_quantity(const Rational& x, const Rational& y) {
  const S a = scalar_from<S>(x);
  const S b = scalar_from<S>(y);
  return (square(a - b) + a * b - S(3)) / (S(1) + square(b));
}

TEST(Scalar, one_template_computed_in_every_rung_encloses_the_same_value) {
  RandomNumbers random(32);
  for (int round = 0; round < 3000; ++round) {
    const Rational x = Rational(static_cast<long>(random.below(2001)) - 1000) / Rational(random.below(99) + 1);
    const Rational y = Rational(static_cast<long>(random.below(2001)) - 1000) / Rational(random.below(99) + 1);
    const Rational exact = some_quantity<Rational>(x, y);
    ASSERT_TRUE(some_quantity<Algebraic>(x, y).rational() == exact);
    const BigInterval big = some_quantity<BigInterval>(x, y);
    ASSERT_TRUE(big.lower() <= exact && exact <= big.upper());
    Interval interval;
    {
      const RoundingGuard guard;
      interval = some_quantity<Interval>(x, y);
    }
    ASSERT_TRUE(contains(interval, exact));
    const double approximate = some_quantity<PlainDouble>(x, y).lower();
    ASSERT_TRUE(std::fabs(approximate - approximate_double(exact)) <= 0x1p-30 * (1 + std::fabs(approximate)));
  }
}

/// ± odd · 2^exponent with so many binary digits.
Rational dyadic(int digits, long exponent, int sign) {
  Integer odd = (Integer(0x9e3779b97f4a7c15U) << 64) + 0xbf58476d1ce4e5b9U;
  odd = (odd * odd) >> static_cast<unsigned>(mpz_sizeinbase(Integer(odd * odd).backend().data(), 2) -
                                             static_cast<std::size_t>(digits));
  const Rational size = Rational(Integer(odd | 1)) * Rational::power_of_two(exponent);
  return sign < 0 ? -size : size;
}

// Dyadic numbers have a way of their own; at the ends of the range they take the general one.
TEST(ScalarFrom, encloses_dyadic_numbers_of_all_sizes_tightly) {
  const RoundingGuard guard;
  for (const int digits : {1, 2, 52, 53, 54, 64, 107, 240}) {
    for (const long exponent : {-1200L, -1080L, -1022L, -1001L, -700L, -1L, 0L, 1L, 500L, 900L, 1000L, 1023L, 1100L}) {
      for (const int sign : {-1, 1}) {
        const Rational x = dyadic(digits, exponent, sign);
        const Interval enclosure = scalar_from<Interval>(x);
        const bool is_finite = std::isfinite(enclosure.lower()) && std::isfinite(enclosure.upper());
        if (std::isfinite(enclosure.lower())) {
          EXPECT_LE(Rational::exactly(enclosure.lower()), x);
        }
        if (std::isfinite(enclosure.upper())) {
          EXPECT_GE(Rational::exactly(enclosure.upper()), x);
        }
        if (!is_finite) continue;
        const bool is_double = digits <= 53 && exponent >= -1022;
        EXPECT_EQ(is_double, enclosure.lower() == enclosure.upper()) << digits << " " << exponent;
        EXPECT_LE(enclosure.upper(), std::nextafter(enclosure.lower(), HUGE_VAL));
      }
    }
  }
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
