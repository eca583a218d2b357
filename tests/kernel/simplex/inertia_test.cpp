#include "kernel/simplex/inertia.hpp"

#include "kernel/number/algebraic.hpp"
#include "tests/kernel/simplex/instances.hpp"

namespace delcert::test {

inline std::ostream& operator<<(std::ostream& stream, const Inertia& signs) {
  return stream << signs.negative << '/' << signs.zero << '/' << signs.positive;
}

namespace DELCERT_THIS_FILE {

using Columns = std::vector<std::vector<Rational>>;

SymmetricMatrix<Rational> any_symmetric(std::size_t order) {
  SymmetricMatrix<Rational> result(order);
  for (std::size_t i = 0; i < order; ++i) {
    for (std::size_t j = 0; j <= i; ++j) result(i, j) = Rational(*rc::gen::inRange(-2, 3));
  }
  return result;
}

/// All eigenvalues are real, so Descartes' rule counts the positive and the negative roots of the characteristic
/// polynomial exactly; its coefficients by Faddeev and LeVerrier.
Inertia by_descartes(const SymmetricMatrix<Rational>& a) {
  const std::size_t n = a.order();
  std::vector<Rational> coefficients{Rational(1)};  // of λⁿ, λⁿ⁻¹, …
  Columns power(n, std::vector<Rational>(n));
  for (std::size_t step = 1; step <= n; ++step) {
    Columns next(n, std::vector<Rational>(n));
    Rational trace(0);
    for (std::size_t i = 0; i < n; ++i) power[i][i] += coefficients.back();
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = 0; j < n; ++j) {
        for (std::size_t l = 0; l < n; ++l) next[i][j] += a(i, l) * power[l][j];
      }
      trace += next[i][i];
    }
    coefficients.push_back(-trace / Rational(static_cast<int>(step)));
    power = next;
  }
  const auto sign_changes = [&](bool mirrored) {
    std::size_t changes = 0;
    int last = 0;
    for (std::size_t i = 0; i <= n; ++i) {
      int sign = coefficients[i] > Rational(0) ? 1 : coefficients[i] < Rational(0) ? -1 : 0;
      if (mirrored && i % 2 == 1) sign = -sign;
      if (sign == 0) continue;
      if (last != 0 && sign != last) ++changes;
      last = sign;
    }
    return changes;
  };
  Inertia result{sign_changes(true), 0, sign_changes(false)};
  result.zero = n - result.negative - result.positive;
  return result;
}

TEST(Inertia, OfDiagonalMatricesCountsSigns) {
  SymmetricMatrix<Rational> matrix(4);
  matrix(0, 0) = Rational(-1);
  matrix(2, 2) = ratio(1, 7);
  matrix(3, 3) = Rational(-9);
  EXPECT_EQ(*inertia(matrix), (Inertia{2, 1, 1}));
  EXPECT_EQ(*inertia(SymmetricMatrix<Rational>(0)), (Inertia{0, 0, 0}));
}

TEST(Inertia, WithoutADiagonalTakesPivotsOfOrderTwo) {
  SymmetricMatrix<Rational> swap(2);
  swap(0, 1) = Rational(1);
  EXPECT_EQ(*inertia(swap), (Inertia{1, 0, 1}));
  SymmetricMatrix<Rational> bordered(3);  // Cayley–Menger of an edge of length 1
  bordered(0, 1) = bordered(0, 2) = bordered(1, 2) = Rational(1);
  EXPECT_EQ(*inertia(bordered), (Inertia{2, 0, 1}));
}

TEST(Inertia, OnIntervalsAPivotPairNeedsOnlyANegativeDeterminant) {
  const RoundingGuard guard;
  SymmetricMatrix<Interval> matrix(2);
  matrix(0, 0) = matrix(1, 1) = Interval::between(-0.25, 0.25);
  matrix(0, 1) = Interval(1);
  EXPECT_EQ(*inertia(matrix), (Inertia{1, 0, 1}));
  matrix(0, 1) = Interval::between(0.125, 1);
  EXPECT_EQ(inertia(matrix).exists(), Verdict::undecided);
}

TEST(Inertia, OnIntervalsIsUndecidedAtAnEigenvalue) {
  SymmetricMatrix<Rational> singular(2);
  singular(0, 0) = ratio(1, 9);
  singular(0, 1) = ratio(1, 3);
  singular(1, 1) = Rational(1);
  EXPECT_EQ(*inertia(singular), (Inertia{0, 1, 1}));
  const RoundingGuard guard;
  EXPECT_EQ(inertia(matrix_from<Interval>(singular)).exists(), Verdict::undecided);
}

RC_GTEST_PROP(Inertia, AgreesWithDescartesRuleOnTheCharacteristicPolynomial, ()) {
  const auto matrix = any_symmetric(static_cast<std::size_t>(*rc::gen::inRange(0, 7)));
  const auto found = inertia(matrix);
  RC_CLASSIFY(found->zero > 0, "singular");
  RC_ASSERT(*found == by_descartes(matrix));
}

RC_GTEST_PROP(Inertia, OnIntervalsIsTheExactOneOrNone, ()) {
  const auto matrix = any_symmetric(static_cast<std::size_t>(*rc::gen::inRange(0, 7)))
                          .shifted(*rc::gen::element(Rational(0), ratio(1, 3), Rational::power_of_two(-70)));
  const Inertia exact = *inertia(matrix);
  if (const auto enclosed = inertia(matrix_from<BigInterval>(matrix))) RC_ASSERT(*enclosed == exact);
  const RoundingGuard guard;
  if (const auto enclosed = inertia(matrix_from<Interval>(matrix))) RC_ASSERT(*enclosed == exact);
}

TEST(Inertia, OnAlgebraicNumbersSeesAnIrrationalEigenvalue) {
  SymmetricMatrix<Algebraic> matrix(2);  // eigenvalues 1 ± √2
  matrix(0, 0) = Algebraic(2);
  matrix(0, 1) = Algebraic(1);
  const Algebraic eigenvalue = Algebraic(1) + square_root(Algebraic(2));
  EXPECT_EQ(*inertia(matrix.shifted(-eigenvalue)), (Inertia{1, 1, 0}));
  EXPECT_EQ(*inertia(matrix.shifted(-eigenvalue + Algebraic(Rational::power_of_two(-100)))), (Inertia{1, 0, 1}));
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
