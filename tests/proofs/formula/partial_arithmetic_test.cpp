#include "proofs/formula/partial_arithmetic.hpp"

#include <gtest/gtest.h>

#include "kernel/number/rounding_guard.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

const Rational half(Integer(1), Integer(2));

TEST(PartialArithmetic, integers_and_fractions_become_numbers_of_each_rung) {
  EXPECT_EQ(number_from<Surd>(Rational(-7)).rational(), Rational(-7));
  EXPECT_EQ(number_from<Surd>(half).rational(), half);
  EXPECT_EQ(number_from<Algebraic>(1L << 40).rational(), Rational(1L << 40));
  const RoundingGuard guard;
  const auto third = number_from<Interval>(Rational(1) / 3);
  EXPECT_LT(Rational::exactly(third.lower()), Rational(1) / 3);
  EXPECT_GT(Rational::exactly(third.upper()), Rational(1) / 3);
  EXPECT_EQ(number_from<Interval>(-7L).lower(), -7.0);
}

TEST(PartialArithmetic, what_certainly_has_no_value_is_refuted_and_what_may_have_none_is_undecided) {
  EXPECT_TRUE(is_refuted(partial_quotient(Algebraic(1), Algebraic(0)).exists()));
  EXPECT_TRUE(is_refuted(partial_root(Algebraic(-1)).exists()));
  const RoundingGuard guard;
  const Interval around_zero = Interval::between(-1, 1);
  EXPECT_TRUE(is_refuted(partial_quotient(Interval(1), Interval(0)).exists()));
  EXPECT_TRUE(is_undecided(partial_quotient(Interval(1), around_zero).exists()));
  EXPECT_TRUE(is_undecided(partial_root(around_zero).exists()));
  EXPECT_TRUE(is_refuted(partial_root(Interval(-1)).exists()));
  EXPECT_EQ(partial_root(Interval(4))->lower(), 2.0);
  EXPECT_EQ(partial_quotient(Interval(1), Interval(4))->upper(), 0.25);
}

TEST(PartialArithmetic, powers_have_integer_and_half_integer_exponents) {
  EXPECT_EQ(partial_power(Surd(2), Rational(10))->rational(), Rational(1024));
  EXPECT_EQ(partial_power(Surd(2), Rational(-2))->rational(), half * half);
  EXPECT_EQ(partial_power(Surd(4), Rational(3) * half)->rational(), Rational(8));
  EXPECT_EQ(partial_power(Surd(0), Rational(0))->rational(), Rational(1));
  EXPECT_TRUE(is_refuted(partial_power(Surd(0), Rational(-1)).exists()));
  EXPECT_TRUE(is_refuted(partial_power(Surd(-4), half).exists()));
  EXPECT_TRUE(is_refuted(partial_power(Surd(8), Rational(1) / 3).exists()));
}

TEST(PartialArithmetic, powers_that_no_memory_could_hold_are_undecided) {
  EXPECT_TRUE(is_undecided(partial_power(Surd(2), Rational(1000001)).exists()));
  const Rational million(1000000);
  EXPECT_FALSE(is_undecided(partial_power(Surd(2), million).exists()));
  EXPECT_TRUE(is_undecided(partial_power(*partial_power(Surd(2), million), million).exists()));
  const auto root = *partial_root(Algebraic(2)) + Algebraic(1);
  EXPECT_TRUE(is_undecided(partial_power(root, Rational(257)).exists()));
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
