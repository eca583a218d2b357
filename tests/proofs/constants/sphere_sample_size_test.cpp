#include "proofs/constants/sphere_sample_size.hpp"

#include <gtest/gtest.h>

namespace delcert {
namespace DELCERT_THIS_FILE {

const PowerProduct tenth{Rational(1) / Rational(10)};
const Rational pi_lower = Rational(333) / Rational(106);
const Rational pi_upper = Rational(355) / Rational(113);

void expect_multiple_of_pi(const Bounds& bounds, const Rational& factor) {
  EXPECT_GT(bounds.lower, factor * pi_lower);
  EXPECT_LT(bounds.upper, factor * pi_upper);
  EXPECT_LT(bounds.lower, bounds.upper);
}

TEST(SphereSampleSize, is_at_least_pi_over_the_radius_on_the_circle) {
  const SphereSampleSize size = sphere_sample_size(Dimension{1}, tenth);
  expect_multiple_of_pi(size.at_least, Rational(10));
  EXPECT_FALSE(size.measured_estimate.has_value());
}

TEST(SphereSampleSize, is_at_least_four_over_the_squared_radius_on_the_sphere) {
  const SphereSampleSize size = sphere_sample_size(Dimension{2}, tenth);
  EXPECT_LE(size.at_least.lower, Rational(400));
  EXPECT_GE(size.at_least.upper, Rational(400));
  EXPECT_LT(size.at_least.upper - size.at_least.lower, Rational::power_of_two(-200));
  ASSERT_TRUE(size.measured_estimate.has_value());
  expect_multiple_of_pi(*size.measured_estimate, Rational(697) * Rational(4) / Rational(10));
  EXPECT_GT(size.measured_estimate->lower, size.at_least.upper);
}

TEST(SphereSampleSize, follows_the_volumes_of_spheres_and_balls_in_dimension_three_and_four) {
  const SphereSampleSize three = sphere_sample_size(Dimension{3}, tenth);
  expect_multiple_of_pi(three.at_least, Rational(3) / Rational(2) * Rational(1000));
  ASSERT_TRUE(three.measured_estimate.has_value());
  // 2π² · 0.743 · 1000 = 14666.5…
  EXPECT_GT(three.measured_estimate->lower, Rational(14666));
  EXPECT_LT(three.measured_estimate->upper, Rational(14667));

  // (8π²/3) / (π²/2) = 16/3
  const SphereSampleSize four = sphere_sample_size(Dimension{4}, PowerProduct());
  EXPECT_LE(four.at_least.lower, Rational(16) / Rational(3));
  EXPECT_GE(four.at_least.upper, Rational(16) / Rational(3));
  EXPECT_FALSE(four.measured_estimate.has_value());
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
