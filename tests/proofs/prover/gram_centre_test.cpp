#include "proofs/prover/gram_centre.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace delcert {
namespace DELCERT_THIS_FILE {

/// [1 y; y 1] and (2 − 3y): semidefinite for −1 ≤ y ≤ 2/3.
TEST(GramCentre, lies_inside) {
  const auto centre = approximate_centre({{2, {1, 0, 0, 1}, {{0, 1, 1, 0}}}, {1, {2}, {{-3}}}});
  ASSERT_TRUE(centre.is_found);
  EXPECT_TRUE(centre.is_inside);
  ASSERT_EQ(centre.y.size(), 1U);
  EXPECT_LT(-1, centre.y[0]);
  EXPECT_LT(centre.y[0], 2.0 / 3);
}

/// [1 y; y 1] and (y − 1): only y = 1, where (1, −1) is sent to 0, and so is the second block.
TEST(GramCentre, tells_what_is_sent_to_zero) {
  const auto centre = approximate_centre({{2, {1, 0, 0, 1}, {{0, 1, 1, 0}}}, {1, {-1}, {{1}}}});
  ASSERT_TRUE(centre.is_found);
  EXPECT_FALSE(centre.is_inside);
  EXPECT_NEAR(centre.y[0], 1, 1e-3);
  ASSERT_EQ(centre.null_vectors.size(), 2U);
  ASSERT_EQ(centre.null_vectors[0].size(), 1U);
  EXPECT_NEAR(centre.null_vectors[0][0][0] + centre.null_vectors[0][0][1], 0, 1e-3);
  EXPECT_EQ(centre.null_vectors[1].size(), 1U);
}

/// [1 y; y 1] and (y − 2).
TEST(GramCentre, says_where_there_is_none) {
  EXPECT_FALSE(approximate_centre({{2, {1, 0, 0, 1}, {{0, 1, 1, 0}}}, {1, {-2}, {{1}}}}).is_found);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
