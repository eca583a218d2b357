#include "kernel/simplex/symmetric_matrix.hpp"

#include "tests/kernel/simplex/instances.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

TEST(SymmetricMatrix, StoresBothTrianglesInOnePlace) {
  SymmetricMatrix<Rational> matrix(3);
  matrix(0, 2) = Rational(5);
  matrix(2, 1) = Rational(7);
  EXPECT_EQ(matrix(2, 0), Rational(5));
  EXPECT_EQ(matrix(1, 2), Rational(7));
  EXPECT_EQ(matrix(0, 1), Rational(0));
  EXPECT_EQ(matrix(1, 1), Rational(0));
  EXPECT_EQ(matrix.order(), 3U);
}

TEST(SymmetricMatrix, ShiftsOnlyTheDiagonal) {
  SymmetricMatrix<Rational> matrix(2);
  matrix(1, 0) = Rational(4);
  const auto shifted = matrix.shifted(ratio(1, 3));
  EXPECT_EQ(shifted(0, 0), ratio(1, 3));
  EXPECT_EQ(shifted(1, 1), ratio(1, 3));
  EXPECT_EQ(shifted(0, 1), Rational(4));
  EXPECT_EQ(SymmetricMatrix<Rational>::identity(2)(1, 1), Rational(1));
  EXPECT_EQ(SymmetricMatrix<Rational>::identity(2)(1, 0), Rational(0));
}

TEST(SymmetricMatrix, NegatesEveryEntry) {
  SymmetricMatrix<Rational> matrix(2);
  matrix(1, 0) = Rational(4);
  matrix(1, 1) = Rational(-1);
  EXPECT_EQ(matrix.negated()(0, 1), Rational(-4));
  EXPECT_EQ(matrix.negated()(1, 1), Rational(1));
}

TEST(SymmetricMatrix, OnOtherRungsContainsTheExactEntries) {
  SymmetricMatrix<Rational> matrix(2);
  matrix(1, 0) = ratio(1, 3);
  matrix(1, 1) = ratio(-1, 7);
  const auto big = matrix_from<BigInterval>(matrix);
  EXPECT_TRUE(contains(big(0, 1), ratio(1, 3)));
  EXPECT_FALSE(contains(big(0, 1), ratio(1, 3) + Rational::power_of_two(-90)));
  const RoundingGuard guard;
  const auto small = matrix_from<Interval>(matrix);
  EXPECT_TRUE(contains(small(1, 1), ratio(-1, 7)));
  EXPECT_FALSE(contains(small(1, 1), ratio(1, 7)));
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
