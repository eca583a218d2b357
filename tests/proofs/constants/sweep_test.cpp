#include "proofs/constants/sweep.hpp"

#include <gtest/gtest.h>

#include "support/error.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

Rational fraction(long numerator, long denominator) { return Rational(numerator) / Rational(denominator); }

Sweep sweep_of(std::vector<Dimension> dimensions, std::vector<Rational> separations,
               std::vector<Rational> perturbations = {}) {
  return {std::move(dimensions), std::move(separations), std::move(perturbations), Rational(0), Rational(0)};
}

std::string message_of(const Sweep& sweep) {
  try {
    (void)ledgers_of(sweep);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(Sweep, combines_every_dimension_with_every_separation) {
  const SweptLedgers swept = ledgers_of(sweep_of({Dimension{3}, Dimension{2}}, {fraction(1, 2), Rational(1)}));
  ASSERT_EQ(swept.ledgers.size(), 4U);
  EXPECT_TRUE(swept.left_out.empty());
  EXPECT_EQ(swept.ledgers[0].dimension, Dimension{3});
  EXPECT_EQ(swept.ledgers[0].separation, fraction(1, 2));
  EXPECT_EQ(swept.ledgers[0].perturbation, fraction(1, 8));
  EXPECT_EQ(swept.ledgers[3].dimension, Dimension{2});
  EXPECT_EQ(swept.ledgers[3].perturbation, fraction(1, 4));
  EXPECT_EQ(swept.ledgers[3].distortion_bound,
            constants_for(Dimension{2}, Rational(1), fraction(1, 4)).distortion_bound);
}

TEST(Sweep, takes_the_largest_perturbation_if_none_is_given) {
  Sweep sweep = sweep_of({Dimension{2}}, {Rational(1)});
  sweep.radius_variation = fraction(1, 4);
  sweep.distortion = fraction(1, 3);
  const SweptLedgers swept = ledgers_of(sweep);
  ASSERT_EQ(swept.ledgers.size(), 1U);
  EXPECT_EQ(swept.ledgers[0].perturbation, fraction(3, 20));
  EXPECT_EQ(swept.ledgers[0].perturbation_tilde, swept.ledgers[0].perturbation_tilde_bound);
}

TEST(Sweep, leaves_out_combinations_out_of_range_and_says_why) {
  const SweptLedgers swept =
      ledgers_of(sweep_of({Dimension{2}}, {fraction(1, 4), Rational(1)}, {fraction(1, 16), fraction(1, 4)}));
  EXPECT_EQ(swept.ledgers.size(), 3U);
  ASSERT_EQ(swept.left_out.size(), 1U);
  EXPECT_EQ(swept.left_out[0].separation, fraction(1, 4));
  EXPECT_EQ(swept.left_out[0].perturbation, fraction(1, 4));
  EXPECT_EQ(swept.left_out[0].reason.rfind("perturbation is 1/4; allowed: above 0 and at most 1/16", 0), 0U);
}

TEST(Sweep, refuses_a_value_that_fits_nothing) {
  const Dimension two{2};
  EXPECT_EQ(message_of(sweep_of({two, Dimension{17}}, {Rational(1)})), "dimension is 17; allowed: 1 to 16");
  EXPECT_EQ(message_of(sweep_of({two}, {Rational(1), Rational(0)})).rfind("separation is 0", 0), 0U);
  EXPECT_EQ(
      message_of(sweep_of({two}, {Rational(1)}, {fraction(1, 5), fraction(1, 3)})).rfind("perturbation is 1/3", 0), 0U);
  EXPECT_EQ(message_of(sweep_of({two}, {Rational(1)}, {fraction(1, 5)})), "");
  Sweep sweep = sweep_of({two}, {Rational(1)});
  sweep.distortion = Rational(-1);
  EXPECT_EQ(message_of(sweep).rfind("distortion is -1", 0), 0U);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
