#include "kernel/number/filter.hpp"

#include <gtest/gtest.h>

#include <type_traits>

namespace delcert {
namespace DELCERT_THIS_FILE {

TEST(Filter, is_the_interval_under_a_rounding_guard) {
  EXPECT_TRUE(filter_is_rigorous);
  EXPECT_TRUE((std::is_same_v<Filter, Interval>));
  EXPECT_TRUE((std::is_same_v<FilterGuard, RoundingGuard>));
}

TEST(Filter, encloses_a_sum_that_is_no_double) {
  const FilterGuard guard;
  const Filter sum = Filter::exactly(1.0) + Filter::exactly(0x1p-60);
  EXPECT_LT(sum.lower(), sum.upper());
  EXPECT_EQ(is_zero(sum - Filter(1)), Verdict::undecided);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
