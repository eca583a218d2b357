#include "kernel/chart/net_grid.hpp"

#include <gtest/gtest.h>

namespace delcert {
namespace DELCERT_THIS_FILE {

TEST(NetGrid, is_near_and_exact_after_translation) {
  for (const double x : {0.1, -0.7, 1 / 3.0, 0x1p-60, 0.0, 5.25}) {
    const double there = on_net_grid(x);
    EXPECT_LE(std::fabs(there - x), net_grid_step / 2) << x;
    EXPECT_EQ(on_net_grid(there), there) << x;
    for (const double shift : {1.0, -3.0, 8.0}) EXPECT_EQ((there + shift) - shift, there) << x;
  }
}

TEST(NetGrid, matters) { EXPECT_NE((0.1 + 8.0) - 8.0, 0.1); }

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
