#include "kernel/simplex/root_comparison.hpp"

#include "tests/kernel/simplex/instances.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

TEST(RootComparison, IsRightOnAllSmallPerfectSquares) {
  for (int a = -20; a <= 20; ++a) {
    for (int s = 0; s <= 5; ++s) {
      EXPECT_EQ(is_at_most_twice_root(Rational(a), Rational(s * s)), verdict_of(a <= 2 * s));
      EXPECT_EQ(is_less_than_twice_root(Rational(a), Rational(s * s)), verdict_of(a < 2 * s));
      for (int t = 0; t <= 5; ++t) {
        EXPECT_EQ(is_less_than_twice_roots(Rational(a), Rational(s * s), Rational(t * t)), verdict_of(a < 2 * (s + t)))
            << a << " < 2(" << s << " + " << t << ")";
      }
    }
  }
}

// 2(√2 + √3) lies between these two.
TEST(RootComparison, SeparatesASumOfRootsFromItsNeighbours) {
  const Rational below = Rational(2) * (square_root_lower(Rational(2), 200) + square_root_lower(Rational(3), 200));
  const Rational above = Rational(2) * (square_root_upper(Rational(2), 200) + square_root_upper(Rational(3), 200));
  EXPECT_EQ(is_less_than_twice_roots(below, Rational(2), Rational(3)), Verdict::proved);
  EXPECT_EQ(is_less_than_twice_roots(above, Rational(2), Rational(3)), Verdict::refuted);
}

TEST(RootComparison, DecidesOnIntervalsWhereTheSignIsUnknownButTheSquareIsSmall) {
  const RoundingGuard guard;
  const Interval around_zero = Interval::between(-1, 1);
  EXPECT_EQ(is_at_most_twice_root(around_zero, Interval(1)), Verdict::proved);
  EXPECT_EQ(is_less_than_twice_root(around_zero, Interval(1)), Verdict::proved);
  EXPECT_EQ(is_at_most_twice_root(around_zero, Interval(0)), Verdict::undecided);
}

RC_GTEST_PROP(RootComparison, OnIntervalsNeverContradictsTheExactAnswer, ()) {
  const Rational a = *any_coordinate();
  const Rational b = absolute(*any_coordinate());
  const Rational c = absolute(*any_coordinate());
  const Verdict exact = is_less_than_twice_roots(a, b, c);
  const RoundingGuard guard;
  RC_ASSERT(agrees(
      is_less_than_twice_roots(scalar_from<Interval>(a), scalar_from<Interval>(b), scalar_from<Interval>(c)), exact));
}

RC_GTEST_PROP(RootComparison, AgreesWithEnclosuresOfTheRoots, ()) {
  const Rational a = *any_coordinate();
  const Rational b = absolute(*any_coordinate());
  const Rational c = absolute(*any_coordinate());
  const BigInterval sum = BigInterval(2) * (square_root(BigInterval(b)) + square_root(BigInterval(c)));
  RC_ASSERT(agrees(less(BigInterval(a), sum), is_less_than_twice_roots(a, b, c)));
  const BigInterval root = BigInterval(2) * square_root(BigInterval(b));
  RC_ASSERT(agrees(less_equal(BigInterval(a), root), is_at_most_twice_root(a, b)));
  RC_ASSERT(agrees(less(BigInterval(a), root), is_less_than_twice_root(a, b)));
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
