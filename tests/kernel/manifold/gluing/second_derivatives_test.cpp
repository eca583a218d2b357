#include "kernel/manifold/gluing/second_derivatives.hpp"

#include <gtest/gtest.h>

#include "kernel/number/rounding_guard.hpp"
#include "tests/support/contains.hpp"
#include "tests/support/ratio.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

TEST(SecondDerivatives, enclose_those_of_all_points_and_tighter_by_more_parts) {
  const FormulaMap map({"x", "y"}, {"x^3/(1+y)", "x^4-x^3"});
  const RoundingGuard guard;
  FormulaEvaluation<Interval> evaluation(map);
  const Cell box{Interval::between(0.5, 1), Interval::between(0, 0.25), Interval(0)};
  std::array<Interval, 8> coarse;
  std::array<Interval, 8> fine;
  ASSERT_TRUE(second_derivatives<2>(evaluation, box, 1, coarse));
  ASSERT_TRUE(second_derivatives<2>(evaluation, box, 8, fine));
  for (const auto& x : {ratio(1, 2), ratio(2, 3), ratio(1, 1)}) {
    for (const auto& y : {ratio(0, 1), ratio(1, 7), ratio(1, 4)}) {
      const Rational z = Rational(1) + y;
      const std::array<Rational, 8> exact = {Rational(6) * x / z,
                                             -Rational(3) * x * x / (z * z),
                                             -Rational(3) * x * x / (z * z),
                                             Rational(2) * x * x * x / (z * z * z),
                                             Rational(12) * x * x - Rational(6) * x,
                                             Rational(0),
                                             Rational(0),
                                             Rational(0)};
      for (std::size_t k = 0; k < 8; ++k) {
        EXPECT_TRUE(contains(coarse[k], exact[k])) << k;
        EXPECT_TRUE(contains(fine[k], exact[k])) << k;
      }
    }
  }
  EXPECT_LT(fine[4].upper() - fine[4].lower(), coarse[4].upper() - coarse[4].lower());
}

TEST(SecondDerivatives, are_not_known_where_something_may_be_divided_by_zero) {
  const FormulaMap map({"x", "y", "z"}, {"1/x", "y", "z"});
  const RoundingGuard guard;
  FormulaEvaluation<Interval> evaluation(map);
  std::array<Interval, 27> found;
  const Interval side = Interval::between(-1, 1);
  EXPECT_FALSE(second_derivatives<3>(evaluation, Cell{side, side, side}, 2, found));
  EXPECT_TRUE(second_derivatives<3>(evaluation, Cell{Interval::between(1, 2), side, side}, 2, found));
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
