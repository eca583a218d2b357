#include "properties/attack/refutations.hpp"

#include <gtest/gtest.h>

#include <set>

#include "properties/attack/twins.hpp"
#include "tests/properties/attack/small_claims.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

TEST(Refutations, are_one_for_each_conclusion_in_the_first_shape_where_it_is_violated) {
  CampaignPlan plan;
  plan.targets = {
      {test::right_claim(), {1, 2}, 40}, {test::wrong_claim(), {2, 2}, 40}, {test::wrong_claim(), {2, 3}, 40}};
  plan.seed = 3;
  const auto tallies = run_campaign(plan, no_progress()).tallies;
  std::size_t tried = 0;
  const auto found = refutations_in(plan.targets, tallies, plan.seed,
                                    [&tried](std::string_view, std::size_t, std::size_t) { ++tried; });
  ASSERT_FALSE(found.empty());
  EXPECT_GT(tried, 0U);
  std::set<std::size_t> conclusions;
  for (const FoundRefutation& one : found) {
    EXPECT_EQ(one.target, 1U);
    EXPECT_TRUE(conclusions.insert(one.conclusion).second);
    EXPECT_TRUE(is_refuted(decide_witness(plan.targets[one.target].claim, one.witness)));
    EXPECT_EQ(one.sample, tallies[one.target].conclusions[one.conclusion].first_violation);
  }
}

TEST(Refutations, of_what_nothing_violates_are_none) {
  CampaignPlan plan;
  plan.targets = {{test::right_claim(), {1, 2}, 40}};
  EXPECT_TRUE(refutations_in(plan.targets, run_campaign(plan, no_progress()).tallies, 0, no_progress()).empty());
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
