#include "proofs/certificate/space_form_claims.hpp"

#include <gtest/gtest.h>

#include "kernel/manifold/quotient/space_form_families.hpp"
#include "kernel/sample/separation.hpp"
#include "kernel/sample/space_form_net.hpp"
#include "tests/kernel/manifold/exhaustive.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

using Names = std::vector<std::string>;

/// A certified run on the sphere with some 550 points, as `delcert certify` makes it, and its measures.
struct RunOnSphere {
  SpaceForm form = verify_space_form(sphere(2));
  SpaceFormAtlas<2> atlas{form, space_form_net<2>(form, ratio(1, 8), 1, no_progress()).centres, ratio(1, 8)};
  RunParameters parameters = [this] {
    ParameterChoice choice;
    choice.mode = RunMode::measured;
    return parameters_for(Dimension(2), measure_separation<2>(atlas), choice);
  }();
  ChartRun<2> run = run_in_charts<2>(atlas, measured_parameters(Dimension(2), 1), RunRequest(), no_progress());
  SpaceFormMeasures measures = measure_run<2>(atlas, run, no_progress());
};

const RunOnSphere& on_sphere() {
  static const RunOnSphere result;
  return result;
}

struct Derived {
  Claims claims;
  std::vector<std::string> reasons;

  [[nodiscard]] bool has_reason(const std::string& part) const {
    return std::any_of(reasons.begin(), reasons.end(), [&](const auto& reason) { return mentions(reason, part); });
  }
};

Derived derive(const ChartRun<2>& run, const SpaceFormMeasures& measures,
               const LevelSelection& selection = all_levels()) {
  Derived result;
  result.claims = derive_claims<2>(on_sphere().atlas, on_sphere().parameters, run, measures, selection, result.reasons);
  return result;
}

TEST(SpaceFormClaims, are_weaker_than_what_was_found) {
  const auto& [form, atlas, parameters, run, measures] = on_sphere();
  ASSERT_TRUE(run.is_certified());
  const Derived derived = derive(run, measures);
  EXPECT_EQ(derived.claims.names(), (Names{"0", "1", "2", "2s", "4", "5", "6"}));
  EXPECT_TRUE(derived.reasons.empty());
  const auto less_than = [](const Rational& a, double b) { return a < Rational::exactly(b); };
  EXPECT_TRUE(less_than(derived.claims.stars->protection, run.margins.protection));
  EXPECT_FALSE(less_than(derived.claims.stars->protection, run.margins.protection * (1 - 0x1p-9)));
  EXPECT_TRUE(less_than(derived.claims.stars->thickness, run.margins.thickness));
  EXPECT_FALSE(less_than(derived.claims.stars->circumradius, run.margins.circumradius));
  EXPECT_TRUE(less_than(derived.claims.delaunay->balls->protection, run.model.protection));
  EXPECT_FALSE(less_than(derived.claims.delaunay->balls->circumradius, run.model.circumradius));
  EXPECT_TRUE(less_than(derived.claims.metric->least_stretch, measures.flat.lower));
  EXPECT_FALSE(less_than(derived.claims.metric->greatest_stretch, measures.flat.upper));
  EXPECT_TRUE(less_than(derived.claims.metric->weight.value(), measures.flat.least_weight));
  EXPECT_GT(derived.claims.metric->weight.value(), Rational(0));
  const Rational shift = parameters.algorithm.perturbation * atlas.sampling_radius();
  EXPECT_GE(derived.claims.input->density->density, derived.claims.delaunay->balls->circumradius + shift);
  // ε = 1/8: 9/8, 3/8 and 3/4 over their sines are 1.246858…, 1.023827… and 1.100289….
  EXPECT_GE(derived.claims.input->density->distortion, Rational(2177) / Rational(10000));
  EXPECT_LE(derived.claims.input->density->distortion, Rational(2184) / Rational(10000));
  EXPECT_GE(derived.claims.input->density->metric_distortion, Rational(911) / Rational(10000));
  EXPECT_LE(derived.claims.input->density->metric_distortion, Rational(912) / Rational(10000));
  EXPECT_GE(*derived.claims.stable_stars->reach, Rational(2) * derived.claims.stars->circumradius);
  EXPECT_EQ(derived.claims.manifold->euler_characteristic, 2);
  EXPECT_EQ(group_text(derived.claims.manifold->homology[1]), "0");
}

TEST(SpaceFormClaims, are_those_selected_and_what_they_rest_on) {
  const auto& run = on_sphere().run;
  const auto& measures = on_sphere().measures;
  EXPECT_EQ(derive(run, measures, {}).claims.names(), Names{});
  EXPECT_EQ(derive(run, measures, {"1"}).claims.names(), (Names{"1", "2"}));
  EXPECT_EQ(derive(run, measures, {"2", "2s"}).claims.names(), (Names{"1", "2", "2s"}));
  EXPECT_EQ(derive(run, measures, {"2", "4"}).claims.names(), (Names{"1", "2", "4"}));
  EXPECT_EQ(derive(run, measures, {"5", "6"}).claims.names(), Names{});
  EXPECT_EQ(derive(run, measures, {"0", "2"}).claims.names(), (Names{"0", "1", "2", "4"}));
}

TEST(SpaceFormClaims, are_not_made_where_a_measure_does_not_allow_them) {
  const auto& run = on_sphere().run;
  SpaceFormMeasures measures = on_sphere().measures;
  measures.stability.differing = 3;
  measures.stability.stars = 2;
  Derived derived = derive(run, measures);
  EXPECT_FALSE(derived.claims.stable_stars.has_value());
  EXPECT_TRUE(derived.has_reason("level 2s: 2 stars are not certified to be the same in all charts (3 of "));
  measures = on_sphere().measures;
  measures.stability.margins.reach = 1.2;
  derived = derive(run, measures);
  EXPECT_FALSE(derived.claims.stable_stars.has_value());
  EXPECT_TRUE(derived.has_reason("level 2s: a star does not fit into the patches"));
  measures = on_sphere().measures;
  measures.flat.undecided = 1;
  derived = derive(run, measures);
  EXPECT_FALSE(derived.claims.metric->weight.has_value());
  EXPECT_TRUE(derived.has_reason("level 6: 1 of "));
  measures.flat.lower = 0;
  derived = derive(run, measures);
  EXPECT_FALSE(derived.claims.metric.has_value());
  EXPECT_TRUE(derived.has_reason("level 6: of 0 simplices no flat one"));
}

TEST(SpaceFormClaims, of_riemannian_simplices_need_small_stars) {
  const auto& run = on_sphere().run;
  SpaceFormMeasures measures = on_sphere().measures;
  EXPECT_FALSE(derive(run, measures).claims.triangulation->riemannian.has_value());
  measures.simplices = {0.25, 0.04, 0.0416, Verdict::proved};
  EXPECT_TRUE(derive(run, measures).claims.triangulation->riemannian.has_value());
  measures.simplices.star_radius = 0.0417;  // above 0.25/6
  EXPECT_FALSE(derive(run, measures).claims.triangulation->riemannian.has_value());
  measures.simplices.star_radius = 0.04;
  measures.simplices.holds = Verdict::undecided;
  EXPECT_FALSE(derive(run, measures).claims.triangulation->riemannian.has_value());
}

TEST(SpaceFormClaims, of_the_input_need_whole_patches) {
  const auto& sphere = on_sphere();
  std::vector<Vector<Rational, 2>> centres;
  for (std::uint32_t index = 0; index < sphere.atlas.size(); ++index)
    centres.push_back(sphere.atlas.centre(Label(index)));
  const SpaceFormAtlas<2> small(sphere.form, centres, ratio(1, 8), 5);
  std::vector<std::string> reasons;
  const auto claims = derive_claims<2>(small, sphere.parameters, sphere.run, sphere.measures, all_levels(), reasons);
  EXPECT_FALSE(claims.input.has_value());
  EXPECT_TRUE(claims.delaunay.has_value());
  EXPECT_EQ(reasons, Names{"level 0: patches are smaller than 9 sampling radii"});
}

TEST(SpaceFormClaims, need_balls_that_fit_into_patches) {
  const auto& sphere = on_sphere();
  const auto changed = [&sphere](double chart_radius, double radius) {
    ChartRun<2> run = sphere.run;
    run.margins.circumradius = chart_radius;
    run.model.circumradius = radius;
    return derive(run, sphere.measures);
  };
  // A patch has the radius 9/8; points move by at most 1/32.
  EXPECT_EQ(changed(0.6, 0.2).claims.names(), Names{});
  EXPECT_TRUE(changed(0.6, 0.2).has_reason("level 1: a circumball with its protection does not fit"));
  EXPECT_EQ(changed(0.2, 0.6).claims.names(), (Names{"1", "2", "2s"}));
  EXPECT_TRUE(changed(0.2, 0.6).has_reason("level 4: a circumball with its protection does not fit"));
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
