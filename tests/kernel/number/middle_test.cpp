#include "kernel/number/middle.hpp"

#include <gtest/gtest.h>

#include "kernel/number/rounding_guard.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

TEST(Middle, is_in_the_interval_in_both_rounding_modes) {
  const double ends[] = {-3, -1, -0x1p-1074, 0, 0x1p-1074, 0x1p-30, 1, 1 + 0x1p-52, 7};
  for (const double lower : ends) {
    for (const double upper : ends) {
      if (upper < lower) continue;
      const Interval x = Interval::between(lower, upper);
      const double nearest = middle_of(x);
      EXPECT_LE(lower, nearest);
      EXPECT_LE(nearest, upper);
      const RoundingGuard guard;
      const double upwards = middle_of(x);
      EXPECT_LE(lower, upwards);
      EXPECT_LE(upwards, upper);
    }
  }
  EXPECT_EQ(middle_of(Interval::between(-1, 3)), 1);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
