#include "bench/plain/tolerant_double.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace delcert {
namespace DELCERT_THIS_FILE {

TEST(TolerantDouble, what_differs_by_the_tolerance_is_undecided_and_what_differs_by_more_is_not) {
  const TolerantDouble one = 1;
  for (const double sign : {-1.0, 1.0}) {
    const TolerantDouble tie = one + TolerantDouble::exactly(sign * OrderWithTolerance::tolerance);
    EXPECT_EQ(less(one, tie), Verdict::undecided);
    EXPECT_EQ(less_equal(tie, one), Verdict::undecided);
    EXPECT_EQ(is_zero(tie - one), Verdict::undecided);
    const TolerantDouble other = one + TolerantDouble::exactly(sign * 2 * OrderWithTolerance::tolerance);
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
