#include "kernel/number/plain_double.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace delcert {
namespace DELCERT_THIS_FILE {

static_assert(Scalar<PlainDouble>);

TEST(PlainDouble, a_fraction_becomes_a_double_next_to_it) {
  EXPECT_EQ(scalar_from<PlainDouble>(Rational(1) / 4).lower(), 0.25);
  EXPECT_LE(std::fabs(scalar_from<PlainDouble>(Rational(1) / 3).lower() - 1.0 / 3), 0x1p-54);
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
