#include "properties/instances/choices.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <set>

namespace delcert {
namespace DELCERT_THIS_FILE {

std::vector<double> first_of(std::uint64_t seed, std::uint32_t stream, std::uint64_t number) {
  RandomChoices choices(seed, stream, number);
  std::vector<double> result;
  for (int i = 0; i < 5; ++i) result.push_back(choices.unit());
  return result;
}

TEST(Choices, random_ones_depend_on_seed_stream_and_number_only) {
  EXPECT_EQ(first_of(1, 2, 3), first_of(1, 2, 3));
  constexpr std::uint64_t beyond = std::uint64_t{1} << 32U;
  std::set<std::vector<double>> different;
  for (const std::uint64_t number : {std::uint64_t{3}, std::uint64_t{4}, beyond + 3, 2 * beyond + 3}) {
    different.insert(first_of(1, 2, number));
  }
  different.insert(first_of(2, 2, 3));
  different.insert(first_of(1, 3, 3));
  EXPECT_EQ(different.size(), 6U);
}

TEST(Choices, a_number_between_two_reaches_both_and_goes_no_farther) {
  GivenChoices ends({0, 1, 0.5});
  EXPECT_EQ(ends.between(-3, 4), -3);
  EXPECT_EQ(ends.between(-3, 4), 4);
  EXPECT_EQ(ends.between(7, 7), 7);
  RandomChoices choices(1, 1, 1);
  std::set<long> seen;
  for (int i = 0; i < 1000; ++i) seen.insert(choices.between(-1, 2));
  EXPECT_EQ(seen, (std::set<long>{-1, 0, 1, 2}));
}

TEST(Choices, fractions_are_multiples_of_their_last_bit_within_their_range) {
  RandomChoices choices(1, 1, 1);
  for (int i = 0; i < 1000; ++i) {
    const Rational fraction = choices.fraction(5);
    EXPECT_EQ((fraction * Rational(32)).denominator(), 1);
    EXPECT_TRUE(Rational(0) <= fraction && fraction < Rational(1));
    const Rational symmetric = choices.symmetric(5);
    EXPECT_EQ((symmetric * Rational(32)).denominator(), 1);
    EXPECT_TRUE(Rational(-1) <= symmetric && symmetric < Rational(1));
  }
  GivenChoices ends({0, 1, 0, 1});
  EXPECT_TRUE(ends.fraction(53) == Rational(0));
  EXPECT_TRUE(ends.fraction(53) == Rational(1) - Rational::power_of_two(-53));
  EXPECT_TRUE(ends.symmetric(52) == Rational(-1));
  EXPECT_TRUE(ends.symmetric(52) == Rational(1) - Rational::power_of_two(-52));
}

TEST(Choices, given_ones_are_brought_into_the_unit_interval_and_end_in_a_half) {
  GivenChoices choices({0.25, -1, 2, std::numeric_limits<double>::quiet_NaN(), 0x1.00000000000001p-60});
  EXPECT_EQ(choices.unit(), 0.25);
  EXPECT_EQ(choices.unit(), 0);
  EXPECT_EQ(choices.unit(), 0x1.fffffffffffffp-1);
  EXPECT_EQ(choices.unit(), 0);
  EXPECT_EQ(choices.unit(), 0);
  EXPECT_EQ(choices.unit(), 0.5);
  EXPECT_EQ(choices.unit(), 0.5);
  EXPECT_EQ(choices.taken(), 7U);
}

// Values of the specification of FNV-1a.
TEST(Choices, streams_of_texts_are_those_of_fnv) {
  EXPECT_EQ(stream_of(""), 2166136261U);
  EXPECT_EQ(stream_of("a"), 0xe40c292cU);
  EXPECT_EQ(stream_of("foobar"), 0xbf9cf968U);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
