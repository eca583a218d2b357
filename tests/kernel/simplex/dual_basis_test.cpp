#include "kernel/simplex/dual_basis.hpp"

#include "kernel/simplex/altitude.hpp"
#include "kernel/simplex/circumsphere.hpp"
#include "kernel/simplex/independence.hpp"
#include "kernel/simplex/thickness.hpp"
#include "tests/kernel/simplex/instances.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

RC_GTEST_PROP(DualBasis, IsDualToTheEdges, ()) {
  const Points points = *any_simplex(1, 5);
  const auto basis = DualBasis::of(simplex_of(points));
  RC_ASSERT(basis.has_value() == are_affinely_independent(points));
  RC_CLASSIFY(!basis);
  if (!basis) return;
  const auto products = basis->products(points);
  RC_ASSERT(products == basis->products());
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::size_t j = 1; j < points.size(); ++j) {
      RC_ASSERT(products[i][j - 1] == Rational(i == 0 ? -1 : i == j ? 1 : 0));
    }
    RC_ASSERT(basis->squared_altitude_times_length(i) == Rational(1));
  }
}

RC_GTEST_PROP(DualBasis, HasTheLengthsOfTheElimination, ()) {
  const Points points = *any_simplex(1, 5);
  const auto gram = simplex_of(points);
  const auto lengths = squared_dual_lengths(gram);
  RC_ASSERT(DualBasis::of(gram).has_value() == lengths.has_value());
  if (!lengths) return;
  for (std::size_t i = 0; i < points.size(); ++i) {
    RC_ASSERT(DualBasis::of(gram)->squared_altitude_times_length(i) == *squared_altitude(gram, i) * (*lengths)[i]);
  }
}

RC_GTEST_PROP(DualBasis, HasTheThicknessAndTheCircumradiusOfTheElimination, ()) {
  const auto gram = simplex_of(*any_simplex(1, 5));
  const auto basis = DualBasis::of(gram);
  RC_CLASSIFY(!basis);
  if (!basis) return;
  RC_ASSERT(basis->squared_thickness() == *squared_thickness(gram));
  RC_ASSERT(basis->squared_circumradius() == *squared_circumradius(gram));
}

/// The products are those of the points that are given, not what they have to be.
TEST(DualBasis, OfOtherPointsIsNotDual) {
  const Rational third = Rational(1) / Rational(3);
  const Points points{{Rational(0), third}, {Rational(3), third}, {Rational(0), Rational(4)}};
  Points others = points;
  others[1][1] += Rational::power_of_two(-70);
  const auto products = DualBasis::of(simplex_of(points))->products(others);
  EXPECT_GT(products[1][1], Rational(0));
  EXPECT_GT(products[1][0], Rational(1));
  EXPECT_EQ(products[0][0] + products[1][0] + products[2][0], Rational(0));
}

TEST(DualBasis, OfADegenerateSimplexIsNone) {
  const auto number = [](long x) { return Rational(x); };
  EXPECT_FALSE(DualBasis::of(simplex_of({{number(0)}, {number(0)}})));
  EXPECT_FALSE(DualBasis::of(simplex_of({{number(0), number(1)}, {number(1), number(2)}, {number(3), number(4)}})));
  EXPECT_TRUE(DualBasis::of(simplex_of({{number(0), number(1)}, {number(1), number(2)}, {number(3), number(5)}})));
}

TEST(DualBasis, OfAVertexIsEmpty) {
  const auto basis = DualBasis::of(simplex_of({{Rational(3)}}));
  ASSERT_TRUE(basis);
  EXPECT_EQ(basis->dimension(), 0U);
  EXPECT_EQ(basis->squared_thickness(), Rational(1));
  EXPECT_EQ(basis->squared_circumradius(), Rational(0));
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
