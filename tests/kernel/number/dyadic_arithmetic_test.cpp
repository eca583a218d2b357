#include "kernel/number/dyadic_arithmetic.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "kernel/number/rational.hpp"
#include "tests/kernel/number/random_numbers.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

class Fraction {
 public:
  Fraction() { mpq_init(value_); }
  ~Fraction() { mpq_clear(value_); }
  Fraction(const Fraction&) = delete;
  Fraction& operator=(const Fraction&) = delete;
  [[nodiscard]] mpq_ptr raw() { return value_; }

 private:
  mpq_t value_;
};

/// Dyadic numbers of up to some hundred digits, whole ones, 0, and numbers that are not dyadic.
std::vector<Rational> numbers(RandomNumbers& random) {
  std::vector<Rational> result{Rational(0),
                               Rational(1),
                               Rational(-1),
                               Rational::power_of_two(-200),
                               Rational::power_of_two(200),
                               Rational(1) / Rational(3)};
  for (int i = 0; i < 40; ++i) {
    const Rational dyadic = Rational::exactly(random.hard_double());
    result.push_back(dyadic);
    result.push_back(-dyadic);
    result.push_back(dyadic / Rational(random.below(9) + 1));
    result.push_back(Rational(static_cast<long>(random.below(1000)) - 500) / Rational(64));
  }
  return result;
}

TEST(DyadicArithmetic, agrees_with_the_arithmetic_of_all_fractions) {
  RandomNumbers random(97);
  const std::vector<Rational> all = numbers(random);
  Fraction mine;
  Fraction gmp;
  for (const Rational& a : all) {
    for (const Rational& b : all) {
      add_exactly(mine.raw(), a.gmp(), b.gmp());
      mpq_add(gmp.raw(), a.gmp(), b.gmp());
      // Numerators and denominators are compared, so that a fraction that is not in lowest terms is noticed.
      ASSERT_NE(mpq_equal(mine.raw(), gmp.raw()), 0);
      subtract_exactly(mine.raw(), a.gmp(), b.gmp());
      mpq_sub(gmp.raw(), a.gmp(), b.gmp());
      ASSERT_NE(mpq_equal(mine.raw(), gmp.raw()), 0);
      multiply_exactly(mine.raw(), a.gmp(), b.gmp());
      mpq_mul(gmp.raw(), a.gmp(), b.gmp());
      ASSERT_NE(mpq_equal(mine.raw(), gmp.raw()), 0);
    }
  }
}

TEST(DyadicArithmetic, knows_which_numbers_are_dyadic) {
  EXPECT_EQ(dyadic_exponent(Rational(5).gmp()), 0U);
  EXPECT_EQ(dyadic_exponent(Rational(0).gmp()), 0U);
  EXPECT_EQ(dyadic_exponent(Rational::power_of_two(-130).gmp()), 130U);
  EXPECT_EQ(dyadic_exponent((Rational(3) / Rational(4)).gmp()), 2U);
  EXPECT_FALSE(dyadic_exponent((Rational(1) / Rational(3)).gmp()));
  EXPECT_FALSE(dyadic_exponent((Rational(1) / Rational(12)).gmp()));
  // A denominator of more than one word whose lowest word is a power of 2.
  EXPECT_FALSE(dyadic_exponent((Rational(1) / (Rational::power_of_two(70) + Rational(4))).gmp()));
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
