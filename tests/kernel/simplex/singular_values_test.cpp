#include "kernel/simplex/singular_values.hpp"

#include "kernel/number/algebraic.hpp"
#include "kernel/simplex/realisability.hpp"
#include "kernel/simplex/thickness.hpp"
#include "tests/kernel/simplex/instances.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

const Rational tiny = Rational::power_of_two(-300);

/// P = diag(4, 3, 1).
const Points box_corner{{Rational(0), Rational(0), Rational(0)},
                        {Rational(4), Rational(0), Rational(0)},
                        {Rational(0), Rational(3), Rational(0)},
                        {Rational(0), Rational(0), Rational(1)}};

TEST(SingularValues, OfADiagonalMatrixAreSharp) {
  const auto simplex = simplex_of(box_corner);
  EXPECT_EQ(is_smallest_singular_value_at_least(simplex, Rational(1)), Verdict::proved);
  EXPECT_EQ(is_smallest_singular_value_at_least(simplex, Rational(1) + tiny), Verdict::refuted);
  EXPECT_EQ(is_largest_singular_value_at_most(simplex, Rational(16)), Verdict::proved);
  EXPECT_EQ(is_largest_singular_value_at_most(simplex, Rational(16) - tiny), Verdict::refuted);
  const int expected[] = {4, 3, 1};
  for (std::size_t index = 1; index <= 3; ++index) {
    const Rational squared(expected[index - 1] * expected[index - 1]);
    EXPECT_EQ(is_singular_value_at_least(simplex, index, squared), Verdict::proved);
    EXPECT_EQ(is_singular_value_at_least(simplex, index, squared + tiny), Verdict::refuted);
  }
}

// The edge vectors (1, −1, 0), (1, 0, −1) from one vertex of the regular triangle: PᵀP has the eigenvalues 1 and 3.
TEST(SingularValues, OfTheRegularTriangle) {
  const auto simplex = simplex_of(regular_simplex(2));
  EXPECT_EQ(is_singular_value_at_least(simplex, 1, Rational(3)), Verdict::proved);
  EXPECT_EQ(is_singular_value_at_least(simplex, 1, Rational(3) + tiny), Verdict::refuted);
  const RationalBounds bounds = singular_value_bounds(simplex, 1, 100);
  EXPECT_LE(square(bounds.lower), Rational(3));
  EXPECT_GE(square(bounds.upper), Rational(3));
  EXPECT_LE(bounds.upper - bounds.lower, bounds.upper * Rational::power_of_two(-100));
}

TEST(SingularValues, OfADegenerateSimplexEndWithZero) {
  const auto simplex = simplex_of({{Rational(0), Rational(0)}, {Rational(1), Rational(1)}, {Rational(3), Rational(3)}});
  EXPECT_EQ(is_smallest_singular_value_at_least(simplex, Rational(0)), Verdict::proved);
  EXPECT_EQ(is_smallest_singular_value_at_least(simplex, tiny), Verdict::refuted);
  EXPECT_EQ(singular_value_bounds(simplex, 2, 10).upper, Rational(0));
  EXPECT_GT(singular_value_bounds(simplex, 1, 10).lower, Rational(0));
}

TEST(SingularValues, AreOnesOnlyFromOneToTheDimension) {
  EXPECT_THROW((void)singular_value_bounds(simplex_of(box_corner), 0, 10), std::invalid_argument);
  EXPECT_THROW((void)singular_value_bounds(simplex_of(box_corner), 4, 10), std::invalid_argument);
  EXPECT_EQ(is_smallest_singular_value_at_least(simplex_of({{Rational(3)}}), Rational(9)), Verdict::proved);
}

TEST(SingularValues, AreFoundDownToTwoToTheMinusHundred) {
  const Points thin{
      {Rational(0), Rational(0)}, {Rational(1), Rational(0)}, {Rational(0), Rational::power_of_two(-100)}};
  const RationalBounds bounds = singular_value_bounds(simplex_of(thin), 2, 30);
  EXPECT_LE(bounds.lower, Rational::power_of_two(-100));
  EXPECT_GE(bounds.upper, Rational::power_of_two(-100));
  EXPECT_LE(bounds.upper, Rational::power_of_two(-99));
}

// lem:bound.skP and ‖P‖ ≤ √k Δ.
RC_GTEST_PROP(SingularValues, AreBoundedByThicknessAndLongestEdge, ()) {
  const auto simplex = simplex_of(*any_simplex(1, 6));
  const Rational k(static_cast<int>(simplex.dimension()));
  const Rational longest = squared_longest_edge(simplex);
  RC_ASSERT(is_largest_singular_value_at_most(simplex, k * longest) == Verdict::proved);
  RC_PRE(is_proved(is_non_degenerate(simplex)));
  RC_ASSERT(is_smallest_singular_value_at_least(simplex, k * *squared_thickness(simplex) * longest) == Verdict::proved);
}

RC_GTEST_PROP(SingularValues, BoundsAreInOrderAndAgreeWithTheDeterminant, ()) {
  const auto simplex = simplex_of(*any_simplex(1, 4));
  RC_PRE(is_proved(is_non_degenerate(simplex)));
  Rational lower(1);
  Rational upper(1);
  RationalBounds last{Rational(0), Rational::power_of_two(40)};
  for (std::size_t index = 1; index <= simplex.dimension(); ++index) {
    const RationalBounds bounds = singular_value_bounds(simplex, index, 40);
    RC_ASSERT(bounds.lower <= last.upper);
    RC_ASSERT(is_singular_value_at_least(simplex, index, square(bounds.lower)) == Verdict::proved);
    RC_ASSERT(is_singular_value_at_least(simplex, index, square(bounds.upper) + tiny) == Verdict::refuted);
    lower *= square(bounds.lower);
    upper *= square(bounds.upper);
    last = bounds;
  }
  const Rational determinant = GramElimination<Rational>(simplex.gram()).determinant();
  RC_ASSERT(lower <= determinant);
  RC_ASSERT(determinant <= upper);
}

RC_GTEST_PROP(SingularValues, OnIntervalsNeverContradictTheExactVerdict, ()) {
  const Points points = *any_simplex(1, 5);
  const auto exact = simplex_of(points);
  const auto index = static_cast<std::size_t>(*rc::gen::inRange(1, static_cast<int>(points.size())));
  const Rational bound = square(*any_coordinate());
  const auto check = [&]<class S>(const EdgeGram<S>& simplex) {
    const S t = scalar_from<S>(bound);
    return agrees(is_smallest_singular_value_at_least(simplex, t), is_smallest_singular_value_at_least(exact, bound)) &&
           agrees(is_largest_singular_value_at_most(simplex, t), is_largest_singular_value_at_most(exact, bound)) &&
           agrees(is_singular_value_at_least(simplex, index, t), is_singular_value_at_least(exact, index, bound));
  };
  RC_ASSERT(check(simplex_on<BigInterval>(points)));
  const RoundingGuard guard;
  RC_ASSERT(check(simplex_on<Interval>(points)));
}

// The edge vectors (1, 0), (1, 1): PᵀP has the eigenvalues (3 ± √5)/2.
TEST(SingularValues, OnAlgebraicNumbersAreSharpAtIrrationalValues) {
  const Points triangle{{Rational(0), Rational(0)}, {Rational(1), Rational(0)}, {Rational(1), Rational(1)}};
  const auto simplex = edge_gram_from_points(points_on<Algebraic>(triangle));
  const Algebraic small = (Algebraic(3) - square_root(Algebraic(5))) / Algebraic(2);
  const Algebraic large = (Algebraic(3) + square_root(Algebraic(5))) / Algebraic(2);
  const Algebraic step(Rational::power_of_two(-100));
  EXPECT_EQ(is_smallest_singular_value_at_least(simplex, small), Verdict::proved);
  EXPECT_EQ(is_smallest_singular_value_at_least(simplex, small + step), Verdict::refuted);
  EXPECT_EQ(is_largest_singular_value_at_most(simplex, large), Verdict::proved);
  EXPECT_EQ(is_largest_singular_value_at_most(simplex, large - step), Verdict::refuted);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
