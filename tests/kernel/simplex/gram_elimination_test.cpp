#include "kernel/simplex/gram_elimination.hpp"

#include "kernel/simplex/cayley_menger.hpp"
#include "kernel/simplex/matrix_norm.hpp"
#include "kernel/simplex/normal_space.hpp"
#include "tests/kernel/simplex/instances.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

SymmetricMatrix<Rational> two_by_two(const Rational& a, const Rational& b, const Rational& c) {
  SymmetricMatrix<Rational> result(2);
  result(0, 0) = a;
  result(0, 1) = b;
  result(1, 1) = c;
  return result;
}

TEST(GramElimination, DecidesTwoByTwoMatricesByTheirMinors) {
  for (int a = -2; a <= 2; ++a) {
    for (int b = -2; b <= 2; ++b) {
      for (int c = -2; c <= 2; ++c) {
        const GramElimination<Rational> elimination(two_by_two(Rational(a), Rational(b), Rational(c)));
        EXPECT_EQ(elimination.semidefinite(), verdict_of(a >= 0 && c >= 0 && a * c >= b * b)) << a << b << c;
        EXPECT_EQ(elimination.definite(), verdict_of(a > 0 && a * c > b * b)) << a << b << c;
      }
    }
  }
}

TEST(GramElimination, ZeroPivotBesideANonZeroEntryIsIndefinite) {
  EXPECT_EQ(
      GramElimination<Rational>(two_by_two(Rational(0), Rational::power_of_two(-300), Rational(1))).semidefinite(),
      Verdict::refuted);
  const GramElimination<Rational> zero(SymmetricMatrix<Rational>(3));
  EXPECT_EQ(zero.semidefinite(), Verdict::proved);
  EXPECT_EQ(zero.definite(), Verdict::refuted);
  EXPECT_EQ(zero.pivot_count(), 0U);
}

TEST(GramElimination, EmptyMatrixIsDefinite) {
  const GramElimination<Rational> empty(SymmetricMatrix<Rational>(0));
  EXPECT_EQ(empty.definite(), Verdict::proved);
  EXPECT_EQ(empty.determinant(), Rational(1));
  EXPECT_EQ(empty.solve({})->energy, Rational(0));
}

TEST(GramElimination, SingularSystemHasASolutionOnlyIfConsistent) {
  const GramElimination<Rational> elimination(two_by_two(Rational(1), Rational(2), Rational(4)));
  const auto solution = elimination.solve({Rational(3), Rational(6)});
  ASSERT_TRUE(solution);
  EXPECT_EQ(solution->x[0] + Rational(2) * solution->x[1], Rational(3));
  EXPECT_EQ(solution->energy, Rational(9));
  EXPECT_EQ(elimination.solve({Rational(3), Rational(5)}).exists(), Verdict::refuted);
}

TEST(GramElimination, OnIntervalsAPivotThatContainsZeroIsUndecided) {
  SymmetricMatrix<Rational> singular = two_by_two(ratio(1, 9), ratio(1, 3), Rational(1));
  const RoundingGuard guard;
  const GramElimination<Interval> elimination(matrix_from<Interval>(singular));
  EXPECT_EQ(elimination.semidefinite(), Verdict::undecided);
  EXPECT_EQ(elimination.definite(), Verdict::undecided);
  EXPECT_EQ(elimination.solve({Interval(1), Interval(1)}).exists(), Verdict::undecided);
}

TEST(GramElimination, OnIntervalsExactZeroesAreSeen) {
  const RoundingGuard guard;
  const GramElimination<Interval> elimination(matrix_from<Interval>(two_by_two(Rational(1), Rational(1), Rational(1))));
  EXPECT_EQ(elimination.semidefinite(), Verdict::proved);
  EXPECT_EQ(elimination.definite(), Verdict::refuted);
}

TEST(GramElimination, OnIntervalsAnUnknownEntryBetweenZeroPivotsIsUndecided) {
  const RoundingGuard guard;
  SymmetricMatrix<Interval> matrix(2);
  matrix(0, 1) = Interval::between(-1, 1);
  EXPECT_EQ(GramElimination<Interval>(matrix).semidefinite(), Verdict::undecided);
  matrix(0, 1) = Interval::between(1, 2);
  EXPECT_EQ(GramElimination<Interval>(matrix).semidefinite(), Verdict::refuted);
}

RC_GTEST_PROP(GramElimination, GramMatricesAreSemidefiniteOfTheRankOfTheirColumns, ()) {
  const Points points = *any_simplex(0, 6);
  const auto gram = gram_of_columns<Rational>(points);
  const GramElimination<Rational> elimination(gram);
  RC_ASSERT(elimination.semidefinite() == Verdict::proved);
  const std::size_t nullity = detail::kernel_basis<Rational>(points, points[0].size())->size();
  RC_ASSERT(elimination.pivot_count() == points[0].size() - nullity);
  RC_ASSERT(elimination.definite() == verdict_of(elimination.pivot_count() == points.size()));
}

RC_GTEST_PROP(GramElimination, DeterminantAgreesWithTheExpansion, ()) {
  const auto gram = gram_of_columns<Rational>(*any_simplex(0, 5));
  const GramElimination<Rational> elimination(gram);
  const Rational expanded = determinant_by_expansion(gram);
  RC_ASSERT(elimination.definite() == verdict_of(expanded > Rational(0)));
  if (is_proved(elimination.definite())) RC_ASSERT(elimination.determinant() == expanded);
}

RC_GTEST_PROP(GramElimination, AnyLoweringOfASingularMatrixIsIndefinite, ()) {
  auto gram = gram_of_columns<Rational>(*any_simplex(1, 5));
  RC_PRE(is_refuted(GramElimination<Rational>(gram).definite()));
  const Rational drop = Rational::power_of_two(-*rc::gen::inRange(1, 200));
  RC_ASSERT(GramElimination<Rational>(gram.shifted(-drop)).semidefinite() == Verdict::refuted);
  RC_ASSERT(GramElimination<Rational>(gram.shifted(drop)).definite() == Verdict::proved);
}

RC_GTEST_PROP(GramElimination, SolutionsSolve, ()) {
  const Points points = *any_simplex(1, 5);
  const auto gram = gram_of_columns<Rational>(points);
  std::vector<Rational> b;
  for (std::size_t i = 0; i < gram.order(); ++i) b.push_back(gram(i, 0) - gram(i, gram.order() - 1));  // in the range
  const auto solution = GramElimination<Rational>(gram).solve(b);
  RC_ASSERT(solution.has_value());
  Rational energy(0);
  for (std::size_t i = 0; i < gram.order(); ++i) {
    Rational image(0);
    for (std::size_t j = 0; j < gram.order(); ++j) image += gram(i, j) * solution->x[j];
    RC_ASSERT(image == b[i]);
    energy += b[i] * solution->x[i];
  }
  RC_ASSERT(energy == solution->energy);
}

RC_GTEST_PROP(GramElimination, TheEnergyAloneIsThatOfTheSolutionOnEveryRung, ()) {
  const auto gram = gram_of_columns<Rational>(*any_simplex(1, 5));
  std::vector<Rational> b;
  for (std::size_t i = 0; i < gram.order(); ++i) b.push_back(gram(i, 0) / Rational(3));
  const GramElimination<Rational> exact(gram);
  const Rational energy = exact.solve(b)->energy;
  RC_ASSERT(energy == gram(0, 0) / Rational(9));
  RC_ASSERT(*exact.energy(b) == energy);

  const auto on = [&]<class S>() {
    std::vector<S> right;
    for (const Rational& entry : b) right.push_back(scalar_from<S>(entry));
    return GramElimination<S>(matrix_from<S>(gram)).energy(std::move(right));
  };
  const auto in_surds = on.operator()<Surd>();
  RC_ASSERT(in_surds.has_value());
  RC_ASSERT(in_surds->rational() == energy);
  const auto enclosed = on.operator()<BigInterval>();
  RC_ASSERT((!enclosed || contains(*enclosed, energy)));
  bool contained = true;
  {
    const RoundingGuard guard;
    const auto filtered = on.operator()<Interval>();
    contained = !filtered || contains(*filtered, energy);
  }
  RC_ASSERT(contained);
}

TEST(GramElimination, ThereIsNoEnergyWithoutASolution) {
  const GramElimination<Rational> elimination(two_by_two(Rational(1), Rational(2), Rational(4)));
  EXPECT_EQ(*elimination.energy({ratio(1, 3), ratio(2, 3)}), ratio(1, 9));
  EXPECT_EQ(elimination.energy({Rational(3), Rational(5)}).exists(), Verdict::refuted);
  const GramElimination<Rational> indefinite(two_by_two(Rational(1), Rational(2), Rational(3)));
  EXPECT_EQ(indefinite.energy({Rational(1), Rational(1)}).exists(), Verdict::refuted);
}

TEST(GramElimination, SurdsAreEliminatedWhereTheyAreRational) {
  SymmetricMatrix<Surd> matrix(2);
  matrix(0, 0) = Surd(ratio(1, 2));
  matrix(1, 1) = Surd(3);
  const GramElimination<Surd> rational(matrix);
  EXPECT_EQ(rational.definite(), Verdict::proved);
  EXPECT_EQ(rational.pivot_count(), 2U);
  EXPECT_EQ(rational.determinant().rational(), ratio(3, 2));
  const auto solution = rational.solve({Surd(1), Surd(1)});
  ASSERT_TRUE(solution);
  EXPECT_EQ(solution->x[0].rational(), Rational(2));
  EXPECT_EQ(solution->x[1].rational(), ratio(1, 3));
  EXPECT_EQ(solution->energy.rational(), ratio(7, 3));
  EXPECT_EQ(rational.solve({square_root(Surd(2)), Surd(1)}).exists(), Verdict::undecided);
  matrix(0, 1) = square_root(Surd(2));
  const GramElimination<Surd> irrational(matrix);
  EXPECT_EQ(irrational.semidefinite(), Verdict::undecided);
  EXPECT_EQ(irrational.definite(), Verdict::undecided);
  EXPECT_EQ(irrational.energy({Surd(1), Surd(1)}).exists(), Verdict::undecided);
}

RC_GTEST_PROP(GramElimination, OnIntervalsNeverContradictsTheExactVerdict, ()) {
  const auto gram = gram_of_columns<Rational>(*any_simplex(0, 5));
  const Rational shift = *rc::gen::element(-1, 0, 1) * Rational::power_of_two(-*rc::gen::inRange(0, 100));
  const auto matrix = gram.shifted(shift);
  const GramElimination<Rational> exact(matrix);
  {
    const GramElimination<BigInterval> enclosed(matrix_from<BigInterval>(matrix));
    RC_ASSERT(agrees(enclosed.semidefinite(), exact.semidefinite()));
    RC_ASSERT(agrees(enclosed.definite(), exact.definite()));
  }
  Verdict semidefinite = Verdict::undecided;
  Verdict definite = Verdict::undecided;
  bool contained = true;
  {
    const RoundingGuard guard;
    const GramElimination<Interval> enclosed(matrix_from<Interval>(matrix));
    semidefinite = enclosed.semidefinite();
    definite = enclosed.definite();
    if (is_proved(definite)) contained = contains(enclosed.determinant(), exact.determinant());
  }
  RC_CLASSIFY(is_undecided(definite), "undecided on intervals");
  RC_ASSERT(agrees(semidefinite, exact.semidefinite()));
  RC_ASSERT(agrees(definite, exact.definite()));
  RC_ASSERT(contained);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
