#include "proofs/certificate/metric_field_claims.hpp"

#include <gtest/gtest.h>

#include "tests/proofs/certificate/metric_field_run.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

TEST(MetricFieldClaims, claim_what_a_certified_run_reaches) {
  const auto& sample = sheared_run();
  ASSERT_TRUE(sample.run.is_certified());
  std::vector<std::string> reasons;
  const auto claims = sample.claims(reasons);
  EXPECT_EQ(claims.names(), (std::vector<std::string>{"1", "2", "2s", "5"}));
  ASSERT_EQ(reasons.size(), 1U);
  EXPECT_TRUE(mentions(reasons[0], "level 4: the metric varies too much in a patch: margin of stability ≥ -"))
      << reasons[0];
  ASSERT_TRUE(claims.delaunay_margin.has_value());
  EXPECT_LT(claims.delaunay_margin->value(), Rational(0));
  EXPECT_LE(claims.stars->protection, Rational::exactly(sample.run.margins.protection));
  EXPECT_GE(claims.stars->protection * ratio(1001, 1000), Rational::exactly(sample.run.margins.protection));
  EXPECT_GE(claims.stars->circumradius, Rational::exactly(sample.run.margins.circumradius));
  EXPECT_EQ(claims.manifold->euler_characteristic, 0);
  EXPECT_EQ(group_text(claims.manifold->homology[1]), "Z^2");
  EXPECT_LT(*claims.stable_stars->reach, sample.atlas.patch_radius());
}

TEST(MetricFieldClaims, reach_level_4_where_the_metric_varies_little) {
  for (const auto* sample : {&flat_run(), &nearly_flat_run()}) {
    ASSERT_TRUE(sample->run.is_certified());
    std::vector<std::string> reasons;
    const auto claims = sample->claims(reasons);
    EXPECT_EQ(claims.names(), (std::vector<std::string>{"1", "2", "2s", "4", "5"}));
    EXPECT_TRUE(reasons.empty());
    EXPECT_GT(claims.delaunay->stability->margin, Rational(0));
    EXPECT_LT(claims.delaunay->stability->margin, claims.delaunay_margin->value());
    EXPECT_LT(claims.delaunay->stability->edge, Rational::exactly(sample->measures.triangulation.edge));
    EXPECT_GT(claims.delaunay->stability->edge * ratio(1001, 1000),
              Rational::exactly(sample->measures.triangulation.edge));
    const auto margin =
        delaunay_margin(Dimension(2), sample->distortion.metric, *claims.stars, claims.delaunay->stability->edge)
            .value();
    EXPECT_EQ(claims.delaunay_margin->value(), margin);
  }
  EXPECT_LT(flat_run().distortion.metric, Rational::power_of_two(-30));
  EXPECT_GT(nearly_flat_run().distortion.metric, Rational::power_of_two(-20));
}

TEST(MetricFieldClaims, do_not_reach_level_4_where_charts_are_distorted_or_do_not_fit) {
  auto sample = flat_run();
  const auto reason = [&] {
    std::vector<std::string> reasons;
    EXPECT_EQ(sample.claims(reasons, {"1", "2", "4"}).names(), (std::vector<std::string>{"1", "2"}));
    return reasons.at(0);
  };
  sample.distortion.metric = ratio(1, 100);
  EXPECT_TRUE(mentions(reason(), "margin of stability ≥ -"));
  sample.distortion.metric = flat_run().distortion.metric;
  sample.measures.triangulation.other_lifts = 1;
  EXPECT_EQ(reason(), "level 4: straight simplices do not triangulate the torus");
}

TEST(MetricFieldClaims, are_no_more_than_what_was_selected) {
  std::vector<std::string> reasons;
  EXPECT_EQ(sheared_run().claims(reasons, {"1", "2"}).names(), (std::vector<std::string>{"1", "2"}));
  EXPECT_EQ(flat_run().claims(reasons, {"1", "2", "5"}).names(), (std::vector<std::string>{"1", "2", "5"}));
  EXPECT_EQ(flat_run().claims(reasons, {"2", "4"}).names(), (std::vector<std::string>{"1", "2", "4"}));
  EXPECT_EQ(flat_run().claims(reasons, {"4"}).names(), std::vector<std::string>{});
  EXPECT_EQ(sheared_run().claims(reasons, {"5"}).names(), std::vector<std::string>{});
  EXPECT_EQ(sheared_run().claims(reasons, {"2", "5"}).names(), (std::vector<std::string>{"1", "2", "5"}));
  EXPECT_TRUE(reasons.empty());
}

TEST(MetricFieldClaims, say_what_is_not_reached) {
  auto sample = sheared_run();
  const auto reasons_of = [&] {
    std::vector<std::string> reasons;
    (void)sample.claims(reasons, {"1", "2", "2s", "5"});
    return reasons;
  };
  sample.measures.stability.differing = 3;
  sample.measures.stability.stars = 2;
  EXPECT_TRUE(mentions(reasons_of().at(0), "level 2s: 2 stars are not certified to be the same in all charts (3 of "));
  sample.measures = sheared_run().measures;
  sample.measures.stability.margins.reach = 1;
  EXPECT_EQ(reasons_of().at(0), "level 2s: a star does not fit into the patches of its vertices");
  sample.measures = sheared_run().measures;
  sample.measures.triangulation.other_lifts = 1;
  EXPECT_TRUE(mentions(reasons_of().at(0), "level 5: 1 simplices are seen at other lifts"));
  sample.measures.triangulation = sheared_run().measures.triangulation;
  sample.measures.triangulation.most_sheets = 2;
  EXPECT_TRUE(mentions(reasons_of().at(0), "at most 2.0"));
  sample.run.margins.circumradius = 1;
  EXPECT_EQ(reasons_of(),
            std::vector<std::string>{"level 1: a circumball with its protection does not fit into a patch"});
}

TEST(MetricFieldClaims, geometry_has_the_stretch_of_the_charts) {
  const auto geometry = geometry_of<2>(sheared_run().atlas, {Rational(0), Rational(0), ratio(1, 5)});
  EXPECT_EQ(geometry.curvature, Curvature::zero);
  EXPECT_EQ(geometry.patch_factor, sheared_run().atlas.patch_factor());
  EXPECT_EQ(geometry.distortion, ratio(1, 2));
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
