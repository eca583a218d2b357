#include "kernel/number/filter.hpp"

#include <gtest/gtest.h>

#include <type_traits>

namespace delcert {
namespace DELCERT_THIS_FILE {

TEST(Filter, is_the_interval_under_a_rounding_guard_unless_the_benchmark_build_says_otherwise) {
#ifdef DELCERT_PLAIN_DOUBLES
  EXPECT_FALSE(filter_is_rigorous);
  EXPECT_TRUE((std::is_same_v<Filter, PlainDouble>));
#else
  EXPECT_TRUE(filter_is_rigorous);
  EXPECT_TRUE((std::is_same_v<Filter, Interval>));
  EXPECT_TRUE((std::is_same_v<FilterGuard, RoundingGuard>));
#endif
}

TEST(Filter, encloses_a_sum_that_no_double_is_exactly_when_it_is_rigorous) {
  const FilterGuard guard;
  const Filter sum = Filter::exactly(1.0) + Filter::exactly(0x1p-60);
  EXPECT_EQ(sum.lower() < sum.upper(), filter_is_rigorous);
  EXPECT_EQ(is_undecided(is_zero(sum - Filter(1))), filter_is_rigorous);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
