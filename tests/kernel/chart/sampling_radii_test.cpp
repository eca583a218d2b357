#include "kernel/chart/sampling_radii.hpp"

#include <gtest/gtest.h>

#include "tests/support/ratio.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

TEST(SamplingRadii, are_the_same_for_all_if_there_is_one) {
  const SamplingRadii radii = ratio(1, 10);
  EXPECT_FALSE(radii.vary());
  EXPECT_EQ(radii.greatest(), ratio(1, 10));
  EXPECT_EQ(radii.of(7), ratio(1, 10));
  EXPECT_EQ(middle_unit(radii.units()), 1);
}

TEST(SamplingRadii, are_a_little_less_than_lengths_in_few_digits) {
  const std::vector<double> lengths{0.1, 0.0123, 0.03};
  const SamplingRadii radii(lengths);
  EXPECT_TRUE(radii.vary());
  for (std::size_t label = 0; label < lengths.size(); ++label) {
    const Rational length = Rational::exactly(lengths[label]);
    EXPECT_LE(radii.of(label), length);
    EXPECT_GE(radii.of(label), length * (Rational(1) - Rational::power_of_two(-10)));
    EXPECT_EQ(radii.of(label), radii.greatest() * Rational::exactly(radii.units()[label]));
  }
  EXPECT_EQ(radii.of(0), radii.greatest());
  EXPECT_EQ(middle_unit(radii.units()), radii.units()[2]);
  // Equal lengths do not vary.
  EXPECT_FALSE(SamplingRadii(std::vector<double>{0.1, 0.1}).vary());
}

TEST(SamplingRadii, are_scaled_in_proportion) {
  const SamplingRadii radii(std::vector<double>{0.1, 0.025, 0.05});
  const SamplingRadii scaled = radii.scaled_to(ratio(1, 3));
  EXPECT_EQ(scaled.greatest(), ratio(1, 3));
  EXPECT_EQ(scaled.units(), radii.units());
  EXPECT_EQ(scaled.of(1), ratio(1, 12));
  EXPECT_EQ(scaled.unit_of(1), 0.25);
  EXPECT_EQ(scaled.least_unit(), 0.25);
  const SamplingRadii uniform = SamplingRadii(ratio(1, 10)).scaled_to(ratio(1, 3));
  EXPECT_FALSE(uniform.vary());
  EXPECT_EQ(uniform.of(5), ratio(1, 3));
  EXPECT_EQ(uniform.least_unit(), 1);
  EXPECT_EQ(uniform.unit_of(5), 1);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
