#include "kernel/simplex/cayley_menger.hpp"

#include "kernel/simplex/gram_elimination.hpp"
#include "kernel/simplex/realisability.hpp"
#include "tests/kernel/simplex/instances.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

TEST(CayleyMenger, DeterminantByExpansionOfSmallMatrices) {
  EXPECT_EQ(determinant_by_expansion(SymmetricMatrix<Rational>(0)), Rational(1));
  SymmetricMatrix<Rational> matrix(3);
  int entry = 1;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j <= i; ++j) matrix(i, j) = Rational(entry++);
  }
  // 1·(3·6 − 5·5) − 2·(2·6 − 5·4) + 4·(2·5 − 3·4)
  EXPECT_EQ(determinant_by_expansion(matrix), Rational(1));
  SymmetricMatrix<Rational> swap(2);
  swap(0, 1) = Rational(3);
  EXPECT_EQ(determinant_by_expansion(swap), Rational(-9));
}

TEST(CayleyMenger, VolumesOfRightCorners) {
  long factorial = 1;
  for (std::size_t k = 1; k <= 6; ++k) {
    factorial *= static_cast<long>(k);
    EXPECT_EQ(squared_volume(simplex_of(right_corner(k))), ratio(1, factorial * factorial));
  }
  EXPECT_EQ(squared_volume(simplex_of({{Rational(4)}})), Rational(1));
}

TEST(CayleyMenger, VolumeOfTheRegularSimplex) {
  EXPECT_EQ(squared_volume(simplex_of(regular_simplex(2))), ratio(3, 4));
  EXPECT_EQ(squared_volume(simplex_of(regular_simplex(3))), ratio(1, 9));
}

TEST(CayleyMenger, QuotientsNeedANonDegenerateDivisor) {
  const auto collinear =
      simplex_of({{Rational(0), Rational(0)}, {Rational(1), Rational(1)}, {Rational(3), Rational(3)}});
  EXPECT_EQ(cayley_menger_determinant(collinear), Rational(0));
  EXPECT_FALSE(squared_circumradius_by_volumes(collinear));
  const auto right = simplex_of({{Rational(0), Rational(0)}, {Rational(3), Rational(0)}, {Rational(0), Rational(4)}});
  EXPECT_EQ(squared_circumradius_by_volumes(right), Rational(25) / Rational(4));
  EXPECT_EQ(squared_volume(right), Rational(36));
  EXPECT_EQ(squared_altitude_by_volumes(right, 0), Rational(144) / Rational(25));
  EXPECT_EQ(squared_altitude_by_volumes(collinear, 0), Rational(0));
  EXPECT_THROW((void)squared_altitude_by_volumes(simplex_of({{Rational(1)}}), 0), std::invalid_argument);
  const auto doubled = simplex_of({{Rational(1)}, {Rational(0)}, {Rational(0)}});
  EXPECT_FALSE(squared_altitude_by_volumes(doubled, 0));
}

RC_GTEST_PROP(CayleyMenger, DeterminantIsThatOfTheGramMatrixUpToItsFactor, ()) {
  const auto simplex = simplex_of(*any_simplex(0, 5));
  const auto k = static_cast<long>(simplex.dimension());
  const Rational factor = Rational::power_of_two(k) * Rational(k % 2 == 0 ? -1 : 1);
  RC_ASSERT(cayley_menger_determinant(simplex) == factor * determinant_by_expansion(simplex.gram()));
  const GramElimination<Rational> elimination(simplex.gram());
  RC_ASSERT((cayley_menger_determinant(simplex) == Rational(0)) == is_refuted(elimination.definite()));
}

RC_GTEST_PROP(CayleyMenger, OnIntervalsContainsTheExactValues, ()) {
  const Points points = *any_simplex(1, 5);
  const auto exact = simplex_of(points);
  const auto radius = squared_circumradius_by_volumes(exact);
  const auto altitude = squared_altitude_by_volumes(exact, 0);
  const RoundingGuard guard;
  const auto enclosed = simplex_on<Interval>(points);
  RC_ASSERT(contains(squared_volume(enclosed), squared_volume(exact)));
  if (const auto found = squared_circumradius_by_volumes(enclosed)) RC_ASSERT(contains(*found, *radius));
  if (const auto found = squared_altitude_by_volumes(enclosed, 0)) RC_ASSERT(contains(*found, *altitude));
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
