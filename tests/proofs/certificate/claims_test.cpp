#include "proofs/certificate/claims.hpp"

#include <gtest/gtest.h>

#include "tests/proofs/certificate/small_run.hpp"

namespace delcert {
namespace {

using Names = std::vector<std::string>;

TEST(Claims, ACertifiedTorusReachesEveryLevel) {
  const Claims claims = small_run().claims();
  EXPECT_EQ(claims.names(), all_levels());
  EXPECT_TRUE(claims.input.value());
  EXPECT_EQ(claims.manifold->euler_characteristic, 0);
  EXPECT_EQ(claims.manifold->simplices, small_run().run.complex.simplices().size());
}

TEST(Claims, ASelectionLeavesOutWhatRestsOnWhatIsLeftOut) {
  EXPECT_EQ(small_run().claims({"1"}).names(), (Names{"1", "2"}));
  EXPECT_EQ(small_run().claims({"2s", "3", "5", "6"}).names(), Names{});
  EXPECT_EQ(small_run().claims({"1", "2", "5"}).names(), (Names{"1", "2"}));
  EXPECT_EQ(small_run().claims({"0", "1", "2", "2s", "4", "5", "6"}).names(),
            (Names{"0", "1", "2", "2s", "4", "5", "6"}));
}

TEST(Claims, MeasuredModeClaimsNoHypotheses2) {
  RunParameters parameters = small_run().parameters;
  parameters.mode = RunMode::measured;
  std::vector<std::string> reasons;
  const Claims claims = derive_claims<2>(small_run().atlas, parameters, small_run().run, {"0"}, no_progress(), reasons);
  EXPECT_FALSE(claims.input.value());
}

TEST(Claims, ABallThatDoesNotFitItsPatchReachesNothing) {
  RunResult<2> run = small_run().run;
  run.protection.margins->circumradius = Rational(4) * small_run().atlas.sampling_radius();
  std::vector<std::string> reasons;
  EXPECT_TRUE(derive_claims<2>(small_run().atlas, small_run().parameters, run, all_levels(), no_progress(), reasons)
                  .names()
                  .empty());
  ASSERT_EQ(reasons.size(), 1U);
  EXPECT_NE(reasons[0].find("patch"), std::string::npos);
}

TEST(Claims, AStarThatDoesNotFitItsPatchesIsNotStable) {
  RunResult<2> run = small_run().run;
  // 4r + 2ρ₀ε < 9ε fails from r = 17ε/8 on at ρ₀ = 1/4; level 1 still holds.
  run.protection.margins->circumradius = Rational(Integer(17), Integer(8)) * small_run().atlas.sampling_radius();
  std::vector<std::string> reasons;
  const Claims claims =
      derive_claims<2>(small_run().atlas, small_run().parameters, run, {"0", "1", "2", "2s"}, no_progress(), reasons);
  EXPECT_EQ(claims.names(), (Names{"0", "1", "2"}));
}

TEST(Claims, ForbiddenConfigurationsKeepLevel3Away) {
  // With a flake parameter of measured size every near-cocircular quadruple has the properties.
  RunParameters parameters = small_run().parameters;
  parameters.squared_flake_parameter = Rational::power_of_two(-30);
  std::vector<std::string> reasons;
  const Claims claims =
      derive_claims<2>(small_run().atlas, parameters, small_run().run, {"0", "3"}, no_progress(), reasons);
  EXPECT_FALSE(claims.no_forbidden.has_value());
  ASSERT_EQ(reasons.size(), 1U);
  EXPECT_NE(reasons[0].find("forbidden configuration"), std::string::npos);
}

}  // namespace
}  // namespace delcert
