#include "properties/attack/directed_search.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/properties/attack/small_claims.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

/// Triangles, scored by the squared length of their first edge up to 1.
double score_of(const LimitedDraw& draw, double) {
  const NoLimits limits;
  const auto instance = draw(limits);
  if (!instance) return worthless_score;
  const auto& points = object_in<SimplexObject>(instance->bindings, "s").points();
  double result = 0;
  for (std::size_t axis = 0; axis < points[0].size(); ++axis) {
    const double x = approximate_double(points[0][axis] - points[1][axis]);
    result += x * x;
  }
  return result <= 1 ? result : worthless_score;
}

TEST(DirectedSearch, it_climbs_to_a_maximum_and_draws_it_again) {
  const Claim claim = test::wrong_claim();
  const auto found = directed_search(claim, {2, 2}, "test", score_of, 600, 1, no_progress());
  ASSERT_TRUE(found.has_value());
  EXPECT_GT(found->score, 0.999);
  EXPECT_EQ(score_of(found->draw, 0), found->score);
  EXPECT_LE(found->evaluations, 608U);
  const auto start_only = directed_search(claim, {2, 2}, "test", score_of, 4, 1, no_progress());
  EXPECT_LT(start_only ? start_only->score : 0, found->score);
}

TEST(DirectedSearch, the_stream_and_the_seed_decide) {
  const Claim claim = test::wrong_claim();
  const auto score = [&](const std::string& stream, std::uint64_t seed) {
    return directed_search(claim, {2, 2}, stream, score_of, 12, seed, no_progress()).value().score;
  };
  EXPECT_EQ(score("test", 1), score("test", 1));
  EXPECT_NE(score("test", 1), score("other", 1));
  EXPECT_NE(score("test", 1), score("test", 2));
}

TEST(DirectedSearch, nothing_is_found_where_all_is_worthless) {
  const auto worthless = [](const LimitedDraw&, double) { return worthless_score; };
  EXPECT_FALSE(directed_search(test::wrong_claim(), {2, 2}, "test", worthless, 50, 1, no_progress()).has_value());
}

TEST(DirectedSearch, structured_instances_are_drawn_where_the_class_has_them_only) {
  const auto traits = [](const std::string& class_name) {
    const Claim claim = parse_claim("name = \"a\"\ninstance = \"" + class_name + "\"\n[[show]]\nclaim = \"k >= 1\"\n",
                                    "a.toml", full_vocabulary(), all_signatures());
    return instance_class(claim.instance).has_structure({2, 2});
  };
  EXPECT_TRUE(traits("simplex-pair"));
  EXPECT_TRUE(traits("distortion-map"));
  EXPECT_FALSE(traits("simplex"));
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
