#include "kernel/simplex/matrix_norm.hpp"

#include "tests/kernel/simplex/instances.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

const Rational tiny = Rational::power_of_two(-300);

/// [[2, 1], [1, 2]] has the eigenvalues 1 and 3; negated, the norm comes from below.
SymmetricMatrix<Rational> one_and_three() {
  SymmetricMatrix<Rational> matrix(2);
  matrix(0, 0) = matrix(1, 1) = Rational(2);
  matrix(0, 1) = Rational(1);
  return matrix;
}

TEST(MatrixNorm, OfASymmetricMatrixIsItsLargestAbsoluteEigenvalue) {
  for (const auto& matrix : {one_and_three(), one_and_three().negated()}) {
    EXPECT_EQ(is_symmetric_norm_at_most(matrix, Rational(3)), Verdict::proved);
    EXPECT_EQ(is_symmetric_norm_at_most(matrix, Rational(3) - tiny), Verdict::refuted);
  }
  EXPECT_EQ(is_symmetric_norm_at_most(SymmetricMatrix<Rational>(3), Rational(0)), Verdict::proved);
}

TEST(MatrixNorm, OfARotationByThreeFourFiveIsFive) {
  const std::vector<std::vector<Rational>> columns{{Rational(3), Rational(4)}, {Rational(-4), Rational(3)}};
  EXPECT_EQ(is_norm_at_most<Rational>(columns, Rational(25)), Verdict::proved);
  EXPECT_EQ(is_norm_at_most<Rational>(columns, Rational(25) - tiny), Verdict::refuted);
}

TEST(MatrixNorm, OfATallMatrixIsTheLengthOfItsOnlyColumn) {
  const std::vector<std::vector<Rational>> columns{{Rational(1), Rational(2), Rational(2)}};
  EXPECT_EQ(is_norm_at_most<Rational>(columns, Rational(9)), Verdict::proved);
  EXPECT_EQ(is_norm_at_most<Rational>(columns, Rational(9) - tiny), Verdict::refuted);
  const RationalBounds bounds = norm_bounds(columns, 50);
  EXPECT_LE(bounds.lower, Rational(3));
  EXPECT_GE(bounds.upper, Rational(3));
}

TEST(MatrixNorm, ColumnsMustHaveOneLength) {
  const std::vector<std::vector<Rational>> ragged{{Rational(1)}, {Rational(1), Rational(2)}};
  EXPECT_THROW((void)gram_of_columns<Rational>(ragged), std::invalid_argument);
}

TEST(MatrixNorm, BoundsOfZeroAreZero) {
  EXPECT_EQ(symmetric_norm_bounds(SymmetricMatrix<Rational>(2), 10).upper, Rational(0));
  EXPECT_EQ(norm_bounds(std::vector<std::vector<Rational>>{{Rational(0)}}, 10).upper, Rational(0));
}

RC_GTEST_PROP(MatrixNorm, BoundsAreTightAndRight, ()) {
  const auto n = static_cast<std::size_t>(*rc::gen::inRange(1, 5));
  SymmetricMatrix<Rational> matrix(n);
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j <= i; ++j) matrix(i, j) = *any_coordinate();
  }
  const RationalBounds bounds = symmetric_norm_bounds(matrix, 60);
  RC_ASSERT(bounds.upper - bounds.lower <= bounds.upper * Rational::power_of_two(-60));
  RC_ASSERT(is_symmetric_norm_at_most(matrix, bounds.upper) == Verdict::proved);
  if (bounds.lower > Rational(0)) {
    RC_ASSERT(is_symmetric_norm_at_most(matrix, bounds.lower - tiny) == Verdict::refuted);
  }
  std::vector<std::vector<Rational>> columns;
  for (std::size_t i = 0; i < n; ++i) {
    columns.emplace_back();
    for (std::size_t j = 0; j < n; ++j) columns.back().push_back(matrix(j, i));
  }
  const RationalBounds again = norm_bounds(columns, 60);
  RC_ASSERT(again.lower <= bounds.upper && bounds.lower <= again.upper);
  RC_ASSERT(is_norm_at_most<Rational>(columns, square(again.upper)) == Verdict::proved);
  if (again.lower > Rational(0)) {
    RC_ASSERT(is_norm_at_most<Rational>(columns, square(again.lower - tiny)) == Verdict::refuted);
  }
}

RC_GTEST_PROP(MatrixNorm, OnIntervalsNeverContradictsTheExactVerdict, ()) {
  SymmetricMatrix<Rational> matrix = one_and_three();
  matrix(0, 1) = *any_coordinate();
  const Rational bound = absolute(*any_coordinate());
  const Verdict exact = is_symmetric_norm_at_most(matrix, bound);
  RC_ASSERT(agrees(is_symmetric_norm_at_most(matrix_from<BigInterval>(matrix), BigInterval(bound)), exact));
  const RoundingGuard guard;
  RC_ASSERT(agrees(is_symmetric_norm_at_most(matrix_from<Interval>(matrix), scalar_from<Interval>(bound)), exact));
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
