#include "kernel/number/plain_double.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace delcert {
namespace DELCERT_THIS_FILE {

static_assert(Scalar<PlainDouble>);

TEST(PlainDouble, every_operation_is_the_one_of_doubles_in_rounding_to_nearest) {
  const double a = -0x1.999999999999ap-4;
  const double b = 0x1.5555555555555p+3;
  const PlainDouble x = PlainDouble::exactly(a);
  const PlainDouble y = PlainDouble::exactly(b);
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
  EXPECT_EQ(PlainDouble::between(a, b).lower(), PlainDouble::between(a, b).upper());
  EXPECT_EQ(PlainDouble::between(1.0, 2.0).lower(), 1.5);
  EXPECT_EQ(PlainDouble(7).lower(), 7.0);
  EXPECT_EQ(scalar_from<PlainDouble>(Rational(1) / 4).lower(), 0.25);
  PlainDouble z = x;
  z += y;
  z -= x;
  z *= y;
  EXPECT_EQ(z.lower(), (a + b - a) * b);
}

TEST(PlainDouble, verdicts_are_never_undecided_even_where_they_are_wrong) {
  // 1 + 2^-60 = 1 to nearest.
  const PlainDouble one = 1;
  const PlainDouble more = one + PlainDouble::exactly(0x1p-60);
  EXPECT_EQ(less(one, more), Verdict::refuted);
  EXPECT_EQ(is_zero(more - one), Verdict::proved);
  EXPECT_EQ(less_equal(one, more), Verdict::proved);
  const PlainDouble unordered = PlainDouble::exactly(std::numeric_limits<double>::quiet_NaN());
  EXPECT_EQ(less(one, unordered), Verdict::refuted);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
