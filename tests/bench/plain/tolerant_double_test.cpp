#include "bench/plain/tolerant_double.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace delcert {
namespace DELCERT_THIS_FILE {

TEST(TolerantDouble, every_operation_is_the_one_of_doubles_in_rounding_to_nearest) {
  const double a = -0x1.999999999999ap-4;
  const double b = 0x1.5555555555555p+3;
  const TolerantDouble x = TolerantDouble::exactly(a);
  const TolerantDouble y = TolerantDouble::exactly(b);
  EXPECT_EQ((x + y).lower(), a + b);
  EXPECT_EQ((x - y).upper(), a - b);
  EXPECT_EQ((x * y).lower(), a * b);
  EXPECT_EQ((x / y).lower(), a / b);
  EXPECT_EQ((-x).lower(), -a);
  EXPECT_EQ(square(x).lower(), a * a);
  EXPECT_EQ(square_root(y).lower(), std::sqrt(b));
  EXPECT_EQ(square_root(x).lower(), 0.0);
  EXPECT_EQ(absolute(x).lower(), -a);
  EXPECT_EQ(minimum(x, y).lower(), a);
  EXPECT_EQ(maximum(x, y).lower(), b);
  EXPECT_EQ(TolerantDouble::between(1.0, 2.0).lower(), 1.5);
  EXPECT_EQ(TolerantDouble(7).upper(), 7.0);
  TolerantDouble z = x;
  z += y;
  z -= x;
  z *= y;
  EXPECT_EQ(z.lower(), (a + b - a) * b);
}

TEST(TolerantDouble, what_differs_by_the_tolerance_is_undecided_and_what_differs_by_more_is_not) {
  const TolerantDouble one = 1;
  for (const double sign : {-1.0, 1.0}) {
    const TolerantDouble tie = one + TolerantDouble::exactly(sign * TolerantDouble::tolerance);
    EXPECT_EQ(less(one, tie), Verdict::undecided);
    EXPECT_EQ(less_equal(tie, one), Verdict::undecided);
    EXPECT_EQ(is_zero(tie - one), Verdict::undecided);
    const TolerantDouble other = one + TolerantDouble::exactly(sign * 2 * TolerantDouble::tolerance);
    EXPECT_EQ(less(one, other), verdict_of(sign > 0));
    EXPECT_EQ(less_equal(other, one), verdict_of(sign < 0));
    EXPECT_EQ(is_zero(other - one), Verdict::refuted);
  }
  EXPECT_EQ(is_zero(TolerantDouble(0)), Verdict::undecided);
  EXPECT_EQ(less(one, TolerantDouble::exactly(std::numeric_limits<double>::infinity())), Verdict::proved);
  EXPECT_EQ(less(one, TolerantDouble::exactly(std::numeric_limits<double>::quiet_NaN())), Verdict::undecided);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
