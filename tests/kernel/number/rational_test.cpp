#include "kernel/number/rational.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>

#include "kernel/number/rounding_guard.hpp"
#include "kernel/number/scalar.hpp"
#include "tests/kernel/number/random_numbers.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

static_assert(Scalar<Rational>);

Rational fraction(long numerator, long denominator) { return Rational(numerator) / Rational(denominator); }

TEST(Rational, is_in_lowest_terms_with_a_positive_denominator) {
  EXPECT_TRUE(fraction(6, -4).numerator() == -3);
  EXPECT_TRUE(fraction(6, -4).denominator() == 2);
  EXPECT_TRUE(Rational(Integer(6), Integer(-4)) == fraction(-3, 2));
  EXPECT_TRUE(Rational(Integer(0), Integer(-4)).denominator() == 1);
}

TEST(Rational, satisfies_the_laws_of_a_field_and_of_its_order) {
  RandomNumbers random(41);
  for (int round = 0; round < 5000; ++round) {
    const Rational a = Rational::exactly(random.hard_double()) / Rational(random.below(9) + 1);
    const Rational b = Rational::exactly(random.hard_double()) / Rational(random.below(9) + 1);
    const Rational c = Rational::exactly(random.hard_double());
    ASSERT_TRUE((a + b) + c == a + (b + c));
    ASSERT_TRUE((a * b) * c == a * (b * c));
    ASSERT_TRUE(a * (b + c) == a * b + a * c);
    ASSERT_TRUE(a - b == -(b - a));
    ASSERT_TRUE(a - a == Rational(0));
    ASSERT_TRUE(b == Rational(0) || a / b * b == a);
    ASSERT_TRUE(square(a + b) == square(a) + Rational(2) * a * b + square(b));
    ASSERT_TRUE(minimum(a, b) + maximum(a, b) == a + b);
    ASSERT_TRUE(absolute(a) == maximum(a, -a));
    ASSERT_EQ(a < b, a - b < Rational(0));
    ASSERT_EQ(less(a, b), verdict_of(a < b));
    ASSERT_EQ(less_equal(a, b), negation(less(b, a)));
    ASSERT_EQ(is_zero(a - b), verdict_of(a == b));
    Rational sum = a;
    sum += b;
    sum -= c;
    sum *= b;
    ASSERT_TRUE(sum == (a + b - c) * b);
  }
}

TEST(Rational, is_the_double_that_it_was_made_of) {
  RandomNumbers random(42);
  for (int round = 0; round < 20000; ++round) {
    const double x = random.hard_double();
    ASSERT_EQ(approximate_double(Rational::exactly(x)), x);
  }
  EXPECT_TRUE(Rational::exactly(0x1p-1074) == Rational::power_of_two(-1074));
  EXPECT_TRUE(Rational::exactly(-0.0) == Rational(0));
  EXPECT_THROW(static_cast<void>(Rational::exactly(std::numeric_limits<double>::infinity())), std::domain_error);
  EXPECT_THROW(static_cast<void>(Rational::exactly(std::numeric_limits<double>::quiet_NaN())), std::domain_error);
}

TEST(Rational, refuses_to_divide_by_zero) {
  EXPECT_THROW(static_cast<void>(Rational(1) / Rational(0)), std::domain_error);
  EXPECT_THROW(Rational(Integer(1), Integer(0)), std::domain_error);
  EXPECT_THROW(static_cast<void>(power(Rational(0), -1)), std::domain_error);
  Rational x(1);
  EXPECT_THROW(x /= Rational(0), std::domain_error);
  EXPECT_TRUE(x == Rational(1));
}

TEST(Rational, powers_multiply) {
  const Rational x = fraction(-3, 7);
  Rational product(1);
  for (long exponent = 0; exponent < 12; ++exponent) {
    EXPECT_TRUE(power(x, exponent) == product) << exponent;
    EXPECT_TRUE(power(x, -exponent) * product == Rational(1)) << exponent;
    product *= x;
  }
  EXPECT_TRUE(power(Rational(0), 0) == Rational(1));
  EXPECT_TRUE(power(Rational(0), 3) == Rational(0));
  EXPECT_TRUE(power(Rational(2), -70) == Rational::power_of_two(-70));
}

TEST(Rational, floors_and_ceilings_are_the_integers_around) {
  for (long numerator = -40; numerator <= 40; ++numerator) {
    for (long denominator = 1; denominator <= 7; ++denominator) {
      const Rational x = fraction(numerator, denominator);
      const Rational below(floor_of(x));
      const Rational above(ceiling_of(x));
      EXPECT_TRUE(below <= x && x < below + Rational(1));
      EXPECT_TRUE(x <= above && above - Rational(1) < x);
    }
  }
}

TEST(Rational, rounding_to_a_grid_goes_in_the_direction_of_its_name_and_less_than_a_step) {
  RandomNumbers random(43);
  for (int round = 0; round < 5000; ++round) {
    const Rational x = Rational::exactly(random.hard_double()) / Rational(3);
    const long exponent = static_cast<long>(random.below(200)) - 100;
    const Rational step = Rational::power_of_two(exponent);
    const Rational below = rounded_down(x, exponent);
    const Rational above = rounded_up(x, exponent);
    ASSERT_TRUE(below <= x && x < below + step);
    ASSERT_TRUE(x <= above && above - step < x);
    ASSERT_TRUE((below / step).denominator() == 1 && (above / step).denominator() == 1);
    ASSERT_TRUE(rounded_down(below, exponent) == below && rounded_up(above, exponent) == above);
  }
}

TEST(Rational, the_binary_exponent_brackets_the_size) {
  RandomNumbers random(44);
  for (int round = 0; round < 5000; ++round) {
    const Rational x = Rational::exactly(random.hard_double()) / Rational(random.below(9) + 1);
    if (x == Rational(0)) continue;
    const long exponent = binary_exponent(x);
    ASSERT_TRUE(Rational::power_of_two(exponent) <= absolute(x));
    ASSERT_TRUE(absolute(x) < Rational::power_of_two(exponent + 1));
  }
  EXPECT_EQ(binary_exponent(Rational(1)), 0);
  EXPECT_EQ(binary_exponent(fraction(-1, 2)), -1);
  EXPECT_EQ(binary_exponent(fraction(1, 3)), -2);
}

TEST(Rational, bounds_of_square_roots_enclose_and_are_as_close_as_asked) {
  RandomNumbers random(45);
  for (int round = 0; round < 5000; ++round) {
    const Rational x = absolute(Rational::exactly(random.hard_double())) / Rational(random.below(9) + 1);
    const unsigned bits = 1 + static_cast<unsigned>(random.below(200));
    const Rational lower = square_root_lower(x, bits);
    const Rational upper = square_root_upper(x, bits);
    ASSERT_TRUE(Rational(0) <= lower && square(lower) <= x && x <= square(upper));
    ASSERT_TRUE(upper - lower <= upper * Rational::power_of_two(-static_cast<long>(bits)));
  }
  EXPECT_TRUE(square_root_lower(Rational(0), 5) == Rational(0));
  EXPECT_TRUE(square_root_upper(Rational(0), 5) == Rational(0));
  EXPECT_TRUE(square_root_upper(fraction(9, 16), 20) == fraction(3, 4));
  EXPECT_THROW(static_cast<void>(square_root_lower(Rational(-1), 20)), std::domain_error);
  EXPECT_THROW(static_cast<void>(square_root_upper(Rational(-1), 20)), std::domain_error);
}

TEST(Rational, a_rounding_guard_around_it_changes_nothing) {
  const RoundingGuard guard;
  EXPECT_TRUE(Rational::exactly(0x1.999999999999ap-4) == Rational(Integer(0xccccccccccccdL), Integer(1L << 55)));
  EXPECT_TRUE(fraction(1, 3) + fraction(1, 6) == fraction(1, 2));
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
