#include "kernel/simplex/independence.hpp"

#include "kernel/simplex/realisability.hpp"
#include "tests/kernel/simplex/instances.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

RC_GTEST_PROP(Independence, IsThatOfTheGramMatrix, ()) {
  const Points points = *any_points(static_cast<std::size_t>(*rc::gen::inRange(1, 6)), 4);
  RC_CLASSIFY(!are_affinely_independent(points));
  RC_ASSERT(are_affinely_independent(points) == is_proved(is_non_degenerate(simplex_of(points))));
}

RC_GTEST_PROP(Independence, EndsWhenAPointMovesIntoTheHullOfTheOthers, ()) {
  Points points = *any_simplex(2, 5);
  RC_ASSERT(are_affinely_independent(points) == is_proved(is_non_degenerate(simplex_of(points))));
  const Rational third = Rational(1) / Rational(3);
  for (std::size_t axis = 0; axis < points[0].size(); ++axis) {
    points[0][axis] = third * points[1][axis] + (Rational(1) - third) * points[2][axis];
  }
  RC_ASSERT(!are_affinely_independent(points));
}

TEST(Independence, OfFractionsAndTheirNeighbours) {
  const Rational third = Rational(1) / Rational(3);
  const Rational least = Rational::power_of_two(-300);
  EXPECT_FALSE(are_affinely_independent({{third, third}, {2 * third, 2 * third}, {Rational(7), Rational(7)}}));
  EXPECT_TRUE(are_affinely_independent({{third, third}, {2 * third, 2 * third}, {Rational(7), Rational(7) + least}}));
}

TEST(Independence, DoesNotDependOnThePrime) {
  const Rational prime = Rational::power_of_two(61) - Rational(1);
  EXPECT_TRUE(are_affinely_independent({{Rational(0)}, {prime}}));
  EXPECT_TRUE(are_affinely_independent({{Rational(0)}, {Rational(1) / prime}}));
  EXPECT_FALSE(are_affinely_independent({{prime}, {prime}}));
}

/// The first edge begins with a 0, the second has one below its pivot, and the third is their sum.
TEST(Independence, OfEdgesWithZeros) {
  const auto number = [](long x) { return Rational(x); };
  const Points points{{number(0), number(0), number(0)},
                      {number(0), number(2), number(2)},
                      {number(1), number(0), number(1)},
                      {number(1), number(2), number(3)}};
  EXPECT_FALSE(are_affinely_independent(points));
  Points others = points;
  others[3][2] = number(4);
  EXPECT_TRUE(are_affinely_independent(others));
}

TEST(Independence, NeedsPointsOfOneDimension) {
  EXPECT_TRUE(are_affinely_independent({{Rational(3)}}));
  EXPECT_FALSE(are_affinely_independent({{Rational(1)}, {Rational(2)}, {Rational(3)}}));
  EXPECT_THROW((void)are_affinely_independent({}), std::invalid_argument);
  EXPECT_THROW((void)are_affinely_independent({{Rational(1)}, {Rational(1), Rational(2)}}), std::invalid_argument);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
