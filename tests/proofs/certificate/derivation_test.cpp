#include "proofs/certificate/derivation.hpp"

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

/// Where what is within `patch` of a centre is in its patch, and level 2 is reached.
struct Sample {
  LevelSelection selection = all_levels();
  std::vector<std::string> reasons;
  Rational patch{1};
  Derivation derivation{selection, reasons, [this](const Rational& reach) { return reach < patch; },
                        Rational(1) / Rational(4)};

  Sample() { derivation.claims.manifold.emplace(); }
  std::optional<Rational> reach(const StarStability& stability, double own_reach) {
    derivation.derive_stability(stability, own_reach);
    return derivation.claims.stable_stars ? derivation.claims.stable_stars->reach : std::nullopt;
  }
};

TEST(Derivation, of_stable_stars_states_the_greater_reach) {
  EXPECT_EQ(Sample().reach(stable_within(0.5), 0.25), stated_above(0.5));
  EXPECT_EQ(Sample().reach(stable_within(0.5), 0.75), stated_above(0.75));
}

TEST(Derivation, of_stable_stars_refuses_those_that_differ) {
  StarStability stability = stable_within(0.5);
  stability.stars = 2;
  stability.differing = 3;
  Sample sample;
  EXPECT_FALSE(sample.reach(stability, 0.25));
  EXPECT_EQ(sample.reasons, std::vector<std::string>{
                                "level 2s: 2 stars are not certified to be the same in all charts (3 of 12 pairs)"});
}

TEST(Derivation, of_stable_stars_says_how_many_certainly_differ) {
  StarStability stability = stable_within(0.5);
  stability.stars = 2;
  stability.differing = 3;
  stability.occupied = 1;
  Sample sample;
  EXPECT_FALSE(sample.reach(stability, 0.25));
  EXPECT_EQ(sample.reasons, std::vector<std::string>{
                                "level 2s: 2 stars are not certified to be the same in all charts (3 of 12 pairs); "
                                "of 1 a simplex has another point in its ball in such a chart"});
}

TEST(Derivation, of_stable_stars_refuses_those_that_do_not_fit) {
  Sample sample;
  sample.patch = Rational(1) / Rational(2);
  EXPECT_FALSE(sample.reach(stable_within(0.5), 0.25));
  EXPECT_EQ(sample.reasons, std::vector<std::string>{"level 2s: a star does not fit into the patches of its vertices"});
}

TEST(Derivation, of_stable_stars_needs_its_selection_and_level_2) {
  Sample sample;
  sample.selection = {"1", "2"};
  EXPECT_FALSE(sample.reach(stable_within(0.5), 0.25));
  Sample without;
  without.derivation.claims.manifold.reset();
  EXPECT_FALSE(without.reach(stable_within(0.5), 0.25));
  EXPECT_TRUE(sample.reasons.empty() && without.reasons.empty());
}

TEST(Derivation, of_stars_states_weaker_margins_where_balls_fit) {
  LocalMargins found;
  found.protection = 0.125;
  found.thickness = 0.5;
  found.circumradius = 0.25;
  Sample sample;
  EXPECT_TRUE(sample.derivation.derive_margins(found)) << "1/4 + 2/4 + 1/8 < 1";
  EXPECT_EQ(sample.derivation.claims.stars->protection, stated_below(0.125));
  EXPECT_EQ(sample.derivation.claims.stars->thickness, stated_below(0.5));
  EXPECT_EQ(sample.derivation.claims.stars->circumradius, stated_above(0.25));
  found.circumradius = 0.3125;  // 1/4 + 5/8 + 1/8 = 1
  Sample tight;
  EXPECT_FALSE(tight.derivation.derive_margins(found));
  EXPECT_FALSE(tight.derivation.claims.stars.has_value());
  EXPECT_EQ(tight.reasons,
            std::vector<std::string>{"level 1: a circumball with its protection does not fit into a patch"});
  Sample unasked;
  unasked.selection = {"0", "4"};
  EXPECT_FALSE(unasked.derivation.derive_margins(found));
  EXPECT_TRUE(unasked.reasons.empty());
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
