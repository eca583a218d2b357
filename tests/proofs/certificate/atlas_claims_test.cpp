#include "proofs/certificate/atlas_claims.hpp"

#include <gtest/gtest.h>

#include "tests/proofs/certificate/atlas_run.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

TEST(AtlasClaims, claim_what_a_certified_run_reaches) {
  const auto& sample = glued_sphere_run();
  ASSERT_TRUE(sample.run.is_certified());
  std::vector<std::string> reasons;
  const auto claims = sample.claims(reasons, {"1", "2"});
  EXPECT_EQ(claims.names(), (std::vector<std::string>{"1", "2"}));
  EXPECT_TRUE(reasons.empty());
  EXPECT_LE(claims.stars->protection, Rational::exactly(sample.run.margins.protection));
  EXPECT_GE(claims.stars->protection * ratio(1001, 1000), Rational::exactly(sample.run.margins.protection));
  EXPECT_GE(claims.stars->circumradius, Rational::exactly(sample.run.margins.circumradius));
  EXPECT_EQ(claims.manifold->euler_characteristic, 2);
  EXPECT_EQ(group_text(claims.manifold->homology[1]), "0");
}

TEST(AtlasClaims, reach_level_5_if_blends_do_not_fold) {
  const auto& sample = glued_sphere_run();
  std::vector<std::string> reasons;
  const auto claims = sample.claims(reasons, {"2", "5"});
  EXPECT_EQ(claims.names(), (std::vector<std::string>{"1", "2", "5"}));
  EXPECT_EQ(claims.triangulation->route, "blended-charts");
  EXPECT_EQ(claims.triangulation->graph->contraction, sample.measures.triangulation->contraction);
  EXPECT_LT(claims.triangulation->graph->contraction, Rational(1));
  auto measures = sample.measures;
  const auto reason_of = [&] {
    std::vector<std::string> found;
    EXPECT_EQ(derive_claims<2>(sample.atlas, sample.parameters, sample.run, measures, {"2", "5"}, found).names(),
              (std::vector<std::string>{"1", "2"}));
    return found.at(0);
  };
  measures.triangulation->unseen = {1};
  EXPECT_EQ(reason_of(), "level 5: chart south shows no label");
  measures.triangulation->unclear = {Label(7)};
  EXPECT_TRUE(mentions(reason_of(), "that of label 7 first")) << reason_of();
  measures.triangulation->failures = {{{3, 4, 5}, BlendCause::fold}};
  EXPECT_TRUE(mentions(reason_of(), "simplex 3 4 5: what transitions do to it may fold it")) << reason_of();
}

TEST(AtlasClaims, level_2s_is_claimed_if_stars_are_the_same_in_all_charts) {
  const auto& sample = glued_sphere_run();
  auto run = sample.run;
  auto measures = sample.measures;
  const auto names_of = [&](std::vector<std::string>& reasons) {
    return derive_claims<2>(sample.atlas, sample.parameters, run, measures, {"2", "2s"}, reasons).names();
  };
  std::vector<std::string> reasons;
  measures.stability.differing = 0;
  EXPECT_EQ(names_of(reasons), (std::vector<std::string>{"1", "2", "2s"}));
  EXPECT_TRUE(reasons.empty());
  measures.stability.differing = 3;
  EXPECT_EQ(names_of(reasons), (std::vector<std::string>{"1", "2"}));
  EXPECT_TRUE(mentions(reasons.at(0), "(3 of "));
  run.margins.circumradius = 9;
  EXPECT_EQ(names_of(reasons), std::vector<std::string>{});
  EXPECT_EQ(reasons.at(1), "level 1: a circumball with its protection does not fit into a patch");
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
