#include "proofs/constants/power_product.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <stdexcept>

namespace delcert {
namespace DELCERT_THIS_FILE {

Rational positive_rational() {
  const auto part = *rc::gen::inRange<long>(1, 1000000);
  return Rational(part) / Rational(*rc::gen::inRange<long>(1, 1000000));
}

bool contains(const Bounds& bounds, const Rational& x) { return bounds.lower <= x && x <= bounds.upper; }

TEST(PowerProduct, of_nothing_is_one) {
  EXPECT_EQ(PowerProduct().rational(), Rational(1));
  EXPECT_EQ(PowerProduct().text(), "1");
  EXPECT_EQ(PowerProduct().latex(), "1");
  EXPECT_EQ(PowerProduct(), PowerProduct(Rational(1)));
}

TEST(PowerProduct, exists_for_positive_numbers_only) {
  EXPECT_THROW(PowerProduct(Rational(0)), std::domain_error);
  EXPECT_THROW(PowerProduct(Rational(-3)), std::domain_error);
  EXPECT_THROW((void)PowerProduct::square_root_of(Rational(0)), std::domain_error);
  EXPECT_THROW((void)PowerProduct::square_root_of(Rational(-4)), std::domain_error);
}

TEST(PowerProduct, prints_its_prime_powers) {
  EXPECT_EQ(PowerProduct(Rational(360)).text(), "2^3·3^2·5");
  EXPECT_EQ(PowerProduct(Rational(1) / Rational(12)).text(), "2^(-2)·3^(-1)");
  EXPECT_EQ(PowerProduct::square_root_of(Rational(27) / Rational(2)).text(), "2^(-1/2)·3^(3/2)");
  EXPECT_EQ(PowerProduct::square_root_of(Rational(27) / Rational(2)).latex(), "2^{-1/2} \\cdot 3^{3/2}");
  EXPECT_EQ(power(PowerProduct(Rational(2)), -33).text(), "2^(-33)");
}

TEST(PowerProduct, keeps_large_factors_whole_but_takes_their_roots) {
  const Rational large = Rational(65537) * Rational(65539);
  EXPECT_EQ(PowerProduct(large).text(), "4295229443");
  EXPECT_EQ(PowerProduct(power(large, 6) * Rational(4)).text(), "2^2·4295229443^6");
}

TEST(PowerProduct, knows_rational_from_irrational) {
  EXPECT_TRUE(PowerProduct::square_root_of(Rational(9) / Rational(4)).is_rational());
  EXPECT_EQ(PowerProduct::square_root_of(Rational(9) / Rational(4)).rational(), Rational(3) / Rational(2));
  EXPECT_FALSE(PowerProduct::square_root_of(Rational(2)).is_rational());
  EXPECT_THROW((void)PowerProduct::square_root_of(Rational(2)).rational(), std::domain_error);
  EXPECT_FALSE(PowerProduct::square_root_of(Rational(1) / Rational(3)).is_rational());
}

TEST(PowerProduct, recognises_equal_numbers_with_different_large_factors) {
  const Rational p(65537);
  const Rational q(65539);
  const PowerProduct split =
      PowerProduct::square_root_of(p * q) * PowerProduct::square_root_of(p) * PowerProduct::square_root_of(q);
  EXPECT_TRUE(split.is_rational());
  EXPECT_EQ(split.rational(), p * q);
  EXPECT_EQ(split, PowerProduct(p * q));
  EXPECT_NE(split, PowerProduct(p * q + Rational(1)));
}

TEST(PowerProduct, orders_numbers_that_logarithms_cannot_tell_apart) {
  const Rational large = power(Rational(3), 400);
  const PowerProduct exact = power(PowerProduct(Rational(3)), 400);
  EXPECT_LT(exact, PowerProduct(large + Rational(1)));
  EXPECT_GT(exact, PowerProduct(large - Rational(1)));
  EXPECT_EQ(exact, PowerProduct(large));
  EXPECT_LT(PowerProduct::square_root_of(large * large - Rational(1)), exact);
}

TEST(PowerProduct, has_an_exact_logarithm_when_it_is_a_power_of_two) {
  const PowerProduct x = power(PowerProduct::square_root_of(Rational(2)), -101);
  EXPECT_EQ(x.log2().lower, Rational(-101) / Rational(2));
  EXPECT_EQ(x.log2().upper, Rational(-101) / Rational(2));
}

TEST(PowerProduct, is_enclosed_beyond_the_range_of_doubles) {
  const PowerProduct tiny = power(PowerProduct(Rational(3)), -5000);
  const Bounds bounds = tiny.bounds();
  EXPECT_TRUE(contains(bounds, power(Rational(3), -5000)));
  EXPECT_LT((bounds.upper - bounds.lower) * Rational::power_of_two(200), bounds.lower);
}

RC_GTEST_PROP(PowerProduct, multiplies_and_divides_as_the_rationals_do, ()) {
  const Rational a = positive_rational();
  const Rational b = positive_rational();
  RC_ASSERT((PowerProduct(a) * PowerProduct(b)).rational() == a * b);
  RC_ASSERT((PowerProduct(a) / PowerProduct(b)).rational() == a / b);
}

RC_GTEST_PROP(PowerProduct, is_raised_to_powers_as_the_rationals_are, ()) {
  const Rational a = positive_rational();
  const auto exponent = *rc::gen::inRange<long>(-20, 20);
  RC_ASSERT(power(PowerProduct(a), exponent).rational() == power(a, exponent));
}

RC_GTEST_PROP(PowerProduct, is_ordered_as_its_squares_are, ()) {
  const Rational a = positive_rational();
  const Rational b = *rc::gen::arbitrary<bool>() ? positive_rational() : a;
  RC_ASSERT((PowerProduct::square_root_of(a) <=> PowerProduct::square_root_of(b)) == (a <=> b));
  RC_ASSERT((PowerProduct::square_root_of(a * a) <=> PowerProduct(b)) == (a <=> b));
}

RC_GTEST_PROP(PowerProduct, lies_in_its_enclosures, ()) {
  const Rational a = positive_rational();
  const PowerProduct root = PowerProduct::square_root_of(a);
  const Bounds bounds = root.bounds();
  RC_ASSERT(square(bounds.lower) <= a);
  RC_ASSERT(a <= square(bounds.upper));
  RC_ASSERT(root.squared() == a);
  RC_ASSERT((bounds.upper - bounds.lower) * Rational::power_of_two(240) <= bounds.upper);
}

/// Bounds l <= log2 x <= u, at integers: 2^floor(l) <= x <= 2^ceil(u), sharpened by taking x to a large power.
RC_GTEST_PROP(PowerProduct, has_a_logarithm_between_its_bounds, ()) {
  const Rational a = positive_rational();
  const Bounds log2 = PowerProduct(a).log2();
  const Rational thousandth = power(a, 1000);
  const auto scaled = [](const Rational& bound) { return bound * Rational(1000); };
  RC_ASSERT(Rational::power_of_two(static_cast<long>(floor_of(scaled(log2.lower)))) <= thousandth);
  RC_ASSERT(thousandth <= Rational::power_of_two(static_cast<long>(ceiling_of(scaled(log2.upper)))));
  RC_ASSERT((log2.upper - log2.lower) * Rational::power_of_two(200) <= Rational(1));
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
