#include "proofs/certificate/submanifold_claims.hpp"

#include <gtest/gtest.h>

#include "tests/proofs/certificate/submanifold_run.hpp"
#include "tests/support/message_of.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

using Names = std::vector<std::string>;

TEST(SubmanifoldClaims, of_a_sphere_are_what_the_measures_say) {
  const auto& sample = test::sphere_run();
  ASSERT_TRUE(sample.run.is_certified());
  std::vector<std::string> reasons;
  const Claims claims = sample.claims(reasons);
  EXPECT_EQ(claims.names(), claims.stable_stars ? (Names{"1", "2", "2s", "4", "5", "5i", "6"})
                                                : (Names{"1", "2", "4", "5", "5i", "6"}));
  // Level 2s is reached or not, as stars are the same in charts, and then it is the one that is not.
  EXPECT_EQ(claims.stable_stars.has_value(), sample.measures.stability->differing == 0);
  // So is level 4 for the length of curves.
  EXPECT_TRUE(claims.delaunay->restricted->extrinsic);
  EXPECT_EQ(claims.delaunay->restricted->intrinsic, sample.measures.delaunay->intrinsic.holds());
  EXPECT_EQ(reasons.size(), (claims.stable_stars ? 0U : 1U) + (claims.delaunay->restricted->intrinsic ? 0U : 1U));
  EXPECT_EQ(claims.manifold->euler_characteristic, 2);
  EXPECT_EQ(claims.triangulation->route, "graph");
  EXPECT_EQ(claims.triangulation->graph->contraction, sample.measures.triangulation.contraction);
  EXPECT_EQ(claims.triangulation->graph->displacement, sample.measures.triangulation.displacement);
  EXPECT_GT(*claims.isotopy->margin, Rational(0));
  EXPECT_LT(*claims.isotopy->margin, Rational::exactly(sample.measures.isotopy->margin));
  EXPECT_FALSE(claims.isotopy->cosine);
}

TEST(SubmanifoldClaims, are_those_that_are_selected) {
  const auto& sample = test::sphere_run();
  const auto names = [&](const LevelSelection& levels) {
    std::vector<std::string> reasons;
    return sample.claims(reasons, levels).names();
  };
  EXPECT_EQ(names({"1"}), (Names{"1", "2"}));
  EXPECT_EQ(names({"1", "2", "5"}), (Names{"1", "2", "5"}));
  EXPECT_EQ(names({"1", "5i"}), (Names{"1", "2", "5", "5i"}));
  EXPECT_EQ(names({"5", "5i"}), Names());
}

TEST(SubmanifoldClaims, have_no_more_of_level_5i_than_was_measured) {
  const auto& sample = test::sphere_run();
  // What is not asked for is not looked at: it may take longer than all else.
  EXPECT_TRUE(sample.measured({"1", "2", "5i"}).isotopy);
  EXPECT_FALSE(sample.measured({"1", "2", "4", "5", "6"}).isotopy);
  const auto claim_with = [&](const std::optional<GraphIsotopy>& isotopy) {
    std::vector<std::string> reasons;
    Claims claims = sample.claims(reasons, {"1", "2"});
    claim_graph<2>(sample.measures.triangulation, isotopy, test::ratio(1, 8), all_levels(), claims, reasons);
    EXPECT_TRUE(claims.triangulation);
    return claims.isotopy;
  };
  EXPECT_FALSE(claim_with(std::nullopt));
  GraphIsotopy isotopy = *sample.measures.isotopy;
  isotopy.margin = -0.25;
  EXPECT_FALSE(claim_with(isotopy));
  isotopy.cosine = 0.5;
  const auto claim = claim_with(isotopy);
  ASSERT_TRUE(claim);
  EXPECT_FALSE(claim->margin);
  EXPECT_LT(*claim->cosine, test::ratio(1, 2));
  EXPECT_GT(*claim->cosine, test::ratio(49, 100));
}

TEST(SubmanifoldClaims, say_which_level_is_not_reached_and_why) {
  const auto& sample = test::sphere_run();
  GraphIsotopy isotopy = *sample.measures.isotopy;
  const auto reasons_with = [&](const GraphTriangulation<2>& triangulation) {
    std::vector<std::string> reasons;
    std::vector<std::string> unused;
    Claims claims = sample.claims(unused, {"1", "2"});
    claim_graph<2>(triangulation, isotopy, test::ratio(1, 8), all_levels(), claims, reasons);
    std::string text;
    for (const std::string& name : claims.names()) text += name + " ";
    for (const std::string& reason : reasons) text += "| " + reason;
    return text;
  };
  GraphTriangulation<2> other = sample.measures.triangulation;
  EXPECT_EQ(reasons_with(other), "1 2 5 5i ");
  isotopy.margin = -0.25;
  isotopy.tightest = Label(7);
  EXPECT_EQ(reasons_with(other),
            "1 2 5 | level 5i: simplices may meet on their way to the manifold: margin ≥ -2 ε, at label 7");
  isotopy.cosine = 0.5;
  EXPECT_EQ(reasons_with(other), "1 2 5 5i ");
  other.unclear = {Label(4), Label(9)};
  EXPECT_EQ(reasons_with(other),
            "1 2 | level 5: in 2 components no label is certainly alone over its place, that of label 4 first");
  other.failures = {{{1, 2, 3}, GraphCause::fibre}};
  EXPECT_EQ(reasons_with(other),
            "1 2 | level 5: 1 simplices are not certainly mapped to the manifold as they should be; simplex 1 2 3: "
            "fibres across it are not certainly transversal to the manifold");
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
