#include "proofs/replay/product.hpp"

#include <gtest/gtest.h>

#include <map>

namespace delcert::replay {
namespace DELCERT_THIS_FILE {

/// The sign of constant·Π factor^exponent; factors that are not in `signs` have an unknown sign.
Sign sign(long constant, const std::vector<std::pair<std::size_t, long>>& powers,
          const std::map<std::size_t, int>& signs, const std::vector<std::size_t>& divisors = {}) {
  return sign_of({Number(constant), powers, divisors}, [&](std::size_t factor) -> Sign {
    const auto found = signs.find(factor);
    return found == signs.end() ? Sign() : Sign(found->second);
  });
}

TEST(SignOfAProduct, is_that_of_its_factors) {
  EXPECT_EQ(sign(1, {}, {}), 2);
  EXPECT_EQ(sign(-3, {}, {}), -2);
  EXPECT_EQ(sign(1, {{0, 1}, {1, 1}}, {{0, -2}, {1, -2}}), 2);
  EXPECT_EQ(sign(1, {{0, 1}, {1, 3}}, {{0, 2}, {1, -2}}), -2);
  EXPECT_EQ(sign(-1, {{0, 1}, {1, 1}}, {{0, 1}, {1, 2}}), -1);
  EXPECT_EQ(sign(1, {{0, 1}}, {}), std::nullopt);
}

TEST(SignOfAProduct, knows_even_powers_to_be_not_negative) {
  EXPECT_EQ(sign(1, {{0, 2}}, {}), 1);
  EXPECT_EQ(sign(-1, {{0, 2}}, {}), -1);
  EXPECT_EQ(sign(1, {{0, 2}}, {{0, -2}}), 2);
  EXPECT_EQ(sign(1, {{0, 3}}, {{0, -1}}), -1);
}

TEST(SignOfAProduct, is_zero_where_a_factor_is_whatever_the_others_are) {
  EXPECT_EQ(sign(0, {{0, 1}}, {}), 0);
  EXPECT_EQ(sign(1, {{0, 1}, {1, 1}}, {{0, 0}}), 0);
}

TEST(SignOfAProduct, is_unknown_where_a_divisor_may_vanish) {
  EXPECT_EQ(sign(1, {}, {}, {0}), std::nullopt);
  EXPECT_EQ(sign(1, {}, {{0, 1}}, {0}), std::nullopt);
  EXPECT_EQ(sign(1, {}, {{0, -2}}, {0}), 2);
  EXPECT_EQ(sign(1, {{0, -1}}, {{0, -1}}), std::nullopt);
  EXPECT_EQ(sign(1, {{0, -2}}, {}), std::nullopt);
  EXPECT_EQ(sign(1, {{0, -1}}, {{0, -2}}), -2);
  EXPECT_EQ(sign(0, {{0, -1}}, {{0, 1}}), std::nullopt);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::replay
