#include "properties/instances/pair_distortion.hpp"

#include "tests/properties/instances/class_checks.hpp"
#include "tests/support/ratio.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

SimplexObject edge_of(const Rational& length) { return SimplexObject({{Rational(0)}, {length}}); }

TEST(PairDistortion, LengthsAreComparedExactlyAtTheBound) {
  // |√2 − √8| = √2.
  EXPECT_TRUE(lengths_differ_by_at_most(Rational(2), Rational(8), Rational(2)));
  EXPECT_TRUE(lengths_differ_by_at_most(Rational(8), Rational(2), Rational(2)));
  EXPECT_FALSE(lengths_differ_by_at_most(Rational(8), Rational(2), Rational(2) - Rational::power_of_two(-300)));
  EXPECT_TRUE(lengths_differ_by_at_most(Rational(3), Rational(3), Rational(0)));
  EXPECT_FALSE(lengths_differ_by_at_most(Rational(3), ratio(301, 100), Rational(0)));
}

TEST(PairDistortion, OfAnEdgeIsItsRelativeChange) {
  EXPECT_TRUE(is_distortion_at_most(edge_of(Rational(3)), edge_of(Rational(2)), ratio(1, 3)));
  EXPECT_FALSE(is_distortion_at_most(edge_of(Rational(3)), edge_of(Rational(2)), ratio(33333, 100000)));
  const Rational measured = measured_distortion(edge_of(Rational(3)), edge_of(Rational(2)));
  EXPECT_GE(measured, ratio(1, 3));
  EXPECT_LE(measured, ratio(1, 3) * (Rational(1) + Rational::power_of_two(-40)));
}

TEST(PairDistortion, IsMeasuredAlsoWhereItIsTiny) {
  const Rational smallest = Rational::power_of_two(-300);
  const Rational measured = measured_distortion(edge_of(Rational(1)), edge_of(Rational(1) - smallest));
  EXPECT_GE(measured, smallest);
  EXPECT_LE(measured, smallest * (Rational(1) + Rational::power_of_two(-40)));
  EXPECT_EQ(measured_distortion(edge_of(Rational(5)), edge_of(Rational(-5))), Rational(0));
}

TEST(PairDistortion, IsRelativeToTheLongestEdge) {
  const SimplexObject triangle({{Rational(0), Rational(0)}, {Rational(4), Rational(0)}, {Rational(0), Rational(3)}});
  const SimplexObject other({{Rational(0), Rational(0)}, {Rational(4), Rational(0)}, {Rational(0), Rational(4)}});
  EXPECT_EQ(squared_longest_edge_of(triangle), Rational(25));
  // The side of 3 grew by 1, that of 5 by √32 − 5 < 1.
  EXPECT_TRUE(is_distortion_at_most(triangle, other, ratio(1, 5)));
  EXPECT_FALSE(is_distortion_at_most(triangle, other, ratio(1, 5) - Rational::power_of_two(-200)));
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
