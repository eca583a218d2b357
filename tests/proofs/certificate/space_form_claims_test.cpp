#include "proofs/certificate/space_form_claims.hpp"

#include <gtest/gtest.h>

#include "kernel/manifold/space_form/space_form_families.hpp"
#include "kernel/sample/space_form_net.hpp"

namespace delcert {
namespace {

/// The projective plane, ε = 1/8; once with patches of five sampling radii.
struct Derived {
  SpaceFormClaims claims;
  SpaceFormRun<2> run;
  std::vector<std::string> reasons;
  Rational moved;
};

Derived derived(int factor) {
  const Rational radius(Integer(1), Integer(8));
  const SpaceForm form = verify_space_form(projective_space(2));
  auto net = space_form_net<2>(form, radius, 1, no_progress());
  const SpaceFormAtlas<2> atlas(form, std::move(net.centres), radius, factor);
  const PerturbationParameters parameters = measured_parameters(Dimension(2), 1);
  auto run = run_on_space_form<2>(atlas, parameters, {}, no_progress());
  EXPECT_TRUE(run.is_certified());
  std::vector<std::string> reasons;
  auto claims = derive_space_form_claims<2>(atlas, parameters, run, no_progress(), reasons);
  return {std::move(claims), std::move(run), std::move(reasons), parameters.perturbation * radius};
}

TEST(SpaceFormClaims, AreWhatTheRunHas) {
  const Derived d = derived(9);
  EXPECT_EQ(d.claims.stars->protection, Rational::exactly(d.run.margins.protection));
  EXPECT_EQ(d.claims.stars->circumradius, Rational::exactly(d.run.margins.circumradius));
  EXPECT_EQ(d.claims.manifold->simplices, d.run.complex.simplices().size());
  EXPECT_EQ(d.claims.manifold->euler_characteristic, 1);
  EXPECT_EQ(group_text(d.claims.manifold->homology[1]), "Z/2");
  EXPECT_EQ(*d.claims.density, Rational::exactly(d.run.model.circumradius) + d.moved);
  ASSERT_TRUE(d.claims.reach);
  EXPECT_LT(*d.claims.reach, Rational(9) * Rational(Integer(1), Integer(8)));
  EXPECT_TRUE(d.claims.triangulation);
  EXPECT_FALSE(d.claims.riemannian) << "far too coarse";
  ASSERT_TRUE(d.claims.metric);
  ASSERT_TRUE(d.claims.metric->weight);
  EXPECT_GT(*d.claims.metric->weight, Rational(0));
  EXPECT_LT(d.claims.metric->least_stretch, Rational(1));
  EXPECT_GT(d.claims.metric->greatest_stretch, Rational(1));
  ASSERT_EQ(d.reasons.size(), 1U);
  EXPECT_EQ(d.reasons[0].substr(0, 8), "level 5:");
}

TEST(SpaceFormClaims, DoNotStateLevel0ForSmallPatches) {
  const Derived d = derived(5);
  EXPECT_FALSE(d.claims.density);
  EXPECT_EQ(d.reasons.front(), "level 0: patches are smaller than 9 sampling radii");
}

TEST(SpaceFormParameters, AreInTheRangesOfTheFormat) {
  PerturbationParameters parameters = measured_parameters(Dimension(3), 5);
  const RunParameters measured = space_form_parameters(parameters, Dimension(3), true);
  EXPECT_EQ(measured.mode, RunMode::measured);
  EXPECT_GT(measured.squared_flake_parameter, Rational(0));
  EXPECT_LE(measured.squared_flake_parameter, Rational(1));
  EXPECT_EQ(measured.algorithm.seed, 5U);
  parameters.tolerance = Rational(0);
  const RunParameters none = space_form_parameters(parameters, Dimension(3), false);
  EXPECT_EQ(none.mode, RunMode::none);
  EXPECT_EQ(none.algorithm.perturbation, Rational(0));
  EXPECT_GT(none.squared_flake_parameter, Rational(0));
}

}  // namespace
}  // namespace delcert
