#include "proofs/formula/decision.hpp"

#include <gtest/gtest.h>

#include "tests/proofs/formula/triangle_scene.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

using namespace triangle_scene;

/// The rung that settles a statement.
Rung rung_of(std::string_view text) {
  const LadderStatistics before = ladder_statistics();
  EXPECT_FALSE(is_undecided(decided(text))) << text;
  const LadderStatistics used = ladder_statistics() - before;
  for (std::size_t rung = 0; rung < rung_count; ++rung) {
    if (used.settled.at(rung) > 0) return static_cast<Rung>(rung);
  }
  ADD_FAILURE() << text << " was settled by no rung";
  return Rung::interval;
}

TEST(Decision, ties_are_decided) {
  EXPECT_TRUE(is_proved(decided("sqrt(2)*sqrt(2) = 2")));
  EXPECT_TRUE(is_proved(decided("sqrt(2)*sqrt(3) = sqrt(6)")));
  EXPECT_TRUE(is_refuted(decided("sqrt(2)*sqrt(2) < 2")));
  EXPECT_TRUE(is_proved(decided("sqrt(2)*sqrt(2) <= 2")));
  EXPECT_TRUE(is_proved(decided("sqrt(5 + 2*sqrt(6)) = sqrt(2) + sqrt(3)")));
  EXPECT_TRUE(is_refuted(decided("sqrt(5 + 2*sqrt(6)) < sqrt(2) + sqrt(3)")));
  EXPECT_TRUE(is_proved(decided("log2(8) = 3")));
  EXPECT_TRUE(is_proved(decided("log2(1/4) = -2")));
  EXPECT_TRUE(is_proved(decided("x = 1/3")));
}

TEST(Decision, each_statement_ends_on_the_cheapest_rung_that_can_tell) {
  EXPECT_EQ(rung_of("sqrt(2) < 3/2"), Rung::interval);
  EXPECT_EQ(rung_of("sqrt(2) < 141421356237309504880168872421/10^29"), Rung::big_interval);
  EXPECT_EQ(rung_of("sqrt(2)*sqrt(2) = 2"), Rung::rational);
  EXPECT_EQ(rung_of("sqrt(5 + 2*sqrt(6)) = sqrt(2) + sqrt(3)"), Rung::algebraic);
  // sqrt(2) + sqrt(3) < 3.1462643699419724 by about 2·10⁻¹⁶, and so on to any precision.
  EXPECT_EQ(rung_of("sqrt(2) + sqrt(3) < 31462643699419723424/10^19"), Rung::big_interval);
}

TEST(Ratio, is_the_smaller_side_over_the_larger) {
  const auto bounds = [](std::string_view text) {
    Scene scene(bindings());
    return ratio_bounds(*typed(text, types::truth), scene, true);
  };
  const auto is_about = [&](std::string_view text, const Rational& expected) {
    const auto found = bounds(text);
    ASSERT_TRUE(found) << text;
    EXPECT_LE(Rational::exactly(found->lower), expected) << text;
    EXPECT_GE(Rational::exactly(found->upper), expected) << text;
    EXPECT_LE(Rational::exactly(found->upper) - Rational::exactly(found->lower), Rational::power_of_two(-48)) << text;
  };
  is_about("1 <= 4", Rational(Integer(1), Integer(4)));
  is_about("4 >= 1", Rational(Integer(1), Integer(4)));
  is_about("3 < x", Rational(9));
  is_about("1 <= 4 and 1 <= 2", Rational(Integer(1), Integer(2)));
  is_about("1 <= 4 or 1 <= 2", Rational(Integer(1), Integer(4)));
  is_about("forall i in 1..3: i <= 6", Rational(Integer(1), Integer(2)));
  is_about("exists i in 1..3: i <= 6", Rational(Integer(1), Integer(6)));
  is_about("1 < 2 implies 1 <= 4", Rational(Integer(1), Integer(4)));
  for (const char* text :
       {"0 <= 0", "1 <= -1", "2 < 1 implies 1 <= 4", "is_good(s, 1)", "1/zero <= 1", "forall i in 1..0: i <= 6"}) {
    EXPECT_FALSE(bounds(text)) << text;
  }
}

TEST(LowerBounds, are_below_the_value_and_near_it) {
  Scene scene(bindings());
  const auto bound = [&](std::string_view text) { return lower_bound(*typed(text, types::number), scene, 60); };
  const auto root = bound("sqrt(2)");
  ASSERT_TRUE(root);
  EXPECT_LT(square(*root), Rational(2));
  EXPECT_GT(square(*root * (Rational(1) + Rational::power_of_two(-59))), Rational(2));
  EXPECT_EQ(bound("zero"), Rational(0));
  EXPECT_EQ(bound("1/zero"), std::nullopt);
  EXPECT_EQ(bound("sqrt(n)"), std::nullopt);
  EXPECT_EQ(bound("(3^1000000)^1000000"), std::nullopt) << "no memory could hold it";
  EXPECT_EQ(bound("(3^-1000000)^1000000"), std::nullopt);
}

TEST(ExactValues, exist_for_rational_terms_only) {
  EXPECT_EQ(exactly("x + 1/6"), Rational(Integer(1), Integer(2)));
  EXPECT_EQ(exactly("sqrt(2)*sqrt(8)"), Rational(4));
  EXPECT_EQ(exactly("sqrt(2)"), std::nullopt);
  EXPECT_EQ(exactly("circumradius(s)"), Rational(Integer(5), Integer(2)));
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
