#include "proofs/certificate/stability_claim.hpp"

#include <gtest/gtest.h>

#include "proofs/certificate/stated_bounds.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

StarStability stable_within(double reach) {
  StarStability result;
  result.stars = 0;
  result.pairs = 12;
  result.differing = 0;
  result.margins.reach = reach;
  return result;
}

const auto always = [](const Rational&) { return true; };
const auto never = [](const Rational&) { return false; };

TEST(StabilityClaim, is_the_greater_reach) {
  std::vector<std::string> reasons;
  EXPECT_EQ(derive_reach(stable_within(0.5), 0.25, always, reasons), stated_above(0.5));
  EXPECT_EQ(derive_reach(stable_within(0.5), 0.75, always, reasons), stated_above(0.75));
  EXPECT_TRUE(reasons.empty());
}

TEST(StabilityClaim, is_not_made_of_stars_that_differ) {
  StarStability stability = stable_within(0.5);
  stability.stars = 2;
  stability.differing = 3;
  std::vector<std::string> reasons;
  EXPECT_FALSE(derive_reach(stability, 0.25, always, reasons));
  EXPECT_EQ(reasons, std::vector<std::string>{
                         "level 2s: 2 stars are not certified to be the same in all charts (3 of 12 pairs)"});
}

TEST(StabilityClaim, is_not_made_where_stars_do_not_fit) {
  std::vector<std::string> reasons;
  EXPECT_FALSE(derive_reach(stable_within(0.5), 0.25, never, reasons));
  EXPECT_EQ(reasons, std::vector<std::string>{"level 2s: a star does not fit into the patches of its vertices"});
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
