#include "proofs/drawing/manifold/motions.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace delcert {
namespace DELCERT_THIS_FILE {

Motions::Matrix turn(double angle) {
  Motions::Matrix result{};
  result[0] = 1;
  result[4] = result[8] = std::cos(angle);
  result[7] = std::sin(angle);
  result[5] = -result[7];
  return result;
}

TEST(Motions, AreAsManyAsTheGroupHas) {
  Motions motions(3);
  const double fifth = 2 * std::acos(-1.0) / 5;
  motions.add_letter(turn(fifth), turn(-fifth));
  std::uint32_t at = 0;
  for (int k = 0; k < 12; ++k) at = motions.product(at, motions.letter(1));
  EXPECT_EQ(motions.size(), 5U);
  EXPECT_EQ(at, motions.product(motions.letter(1), motions.letter(1)));
  EXPECT_EQ(motions.product(at, motions.inverse(at)), 0U);
  EXPECT_EQ(motions.inverse(motions.letter(1)), motions.letter(-1));
  const Motions::Vector x = motions.apply(motions.letter(1), {1, 1, 0});
  EXPECT_NEAR(x[1], std::cos(fifth), 1e-15);
  EXPECT_NEAR(x[2], std::sin(fifth), 1e-15);
}

TEST(Motions, ThatAreTheirOwnInversesAreKeptOnce) {
  Motions motions(3);
  const double half = std::acos(-1.0);
  motions.add_letter(turn(half), turn(-half));
  EXPECT_EQ(motions.letter(1), motions.letter(-1));
  EXPECT_EQ(motions.size(), 2U);
}

TEST(Motions, TranslateHomogeneousCoordinates) {
  Motions motions(3);
  const std::uint32_t shift = motions.translation({1, -2});
  const Motions::Vector x = motions.apply(shift, {1, 0.5, 0.25});
  EXPECT_EQ(x[1], 1.5);
  EXPECT_EQ(x[2], -1.75);
  EXPECT_EQ(motions.product(shift, shift), motions.translation({2, -4}));
  EXPECT_EQ(motions.inverse(shift), motions.translation({-1, 2}));
  EXPECT_EQ(motions.translation({0, 0}), 0U);
  EXPECT_NE(shift, motions.translation({1, 2}));
}

TEST(Motions, HaveReducedWords) {
  Motions motions(3);
  motions.add_letter(turn(1), turn(-1));
  motions.add_letter(turn(std::sqrt(2)), turn(-std::sqrt(2)));
  const std::uint32_t product = motions.product(motions.letter(1), motions.letter(-2));
  EXPECT_EQ(motions.word(product), (std::vector<std::int32_t>{1, -2}));
  EXPECT_EQ(motions.word(motions.inverse(product)), (std::vector<std::int32_t>{2, -1}));
  EXPECT_EQ(motions.product(product, motions.letter(2)), motions.letter(1));
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
