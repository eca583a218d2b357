#include "proofs/certificate/space_form_claims.hpp"

#include <gtest/gtest.h>

#include <algorithm>

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
  RunParameters parameters;
  parameters.algorithm = measured_parameters(Dimension(2), 1);
  auto run = run_on_space_form<2>(atlas, parameters.algorithm, {}, no_progress());
  EXPECT_TRUE(run.is_certified());
  std::vector<std::string> reasons;
  auto claims =
      derive_claims<2>(atlas, parameters, run, measure_run<2>(atlas, run, no_progress()), all_levels(), reasons);
  return {std::move(claims), std::move(run), std::move(reasons), parameters.algorithm.perturbation * radius};
}

TEST(SpaceFormClaims, AreABitWeakerThanWhatTheRunHas) {
  const Derived d = derived(9);
  const auto near = [](const Rational& claimed, double found) {
    const double ratio = approximate_double(claimed) / found;
    return ratio > 0.999 && ratio < 1.001 && ratio != 1;
  };
  EXPECT_LT(d.claims.stars->protection, Rational::exactly(d.run.margins.protection));
  EXPECT_GT(d.claims.stars->circumradius, Rational::exactly(d.run.margins.circumradius));
  EXPECT_TRUE(near(d.claims.stars->protection, d.run.margins.protection));
  EXPECT_TRUE(near(d.claims.stars->circumradius, d.run.margins.circumradius));
  EXPECT_TRUE(near(d.claims.delaunay->circumradius, d.run.model.circumradius));
  EXPECT_EQ(d.claims.manifold->simplices, d.run.complex.simplices().size());
  EXPECT_EQ(d.claims.manifold->euler_characteristic, 1);
  EXPECT_EQ(group_text(d.claims.manifold->homology[1]), "Z/2");
  EXPECT_GE(*d.claims.density, Rational::exactly(d.run.model.circumradius) + d.moved);
  ASSERT_TRUE(d.claims.reach);
  EXPECT_LT(*d.claims.reach, Rational(9) * Rational(Integer(1), Integer(8)));
  EXPECT_TRUE(d.claims.triangulation);
  EXPECT_FALSE(d.claims.riemannian) << "far too coarse";
  ASSERT_TRUE(d.claims.metric);
  ASSERT_TRUE(d.claims.metric->weight);
  EXPECT_LT(d.claims.metric->least_stretch, Rational(1));
  EXPECT_GT(d.claims.metric->greatest_stretch, Rational(1));
  EXPECT_EQ(names_of(d.claims), (std::vector<std::string>{"0", "1", "2", "2s", "4", "5", "6"}));
}

TEST(SpaceFormClaims, DoNotStateLevel0ForSmallPatches) {
  const Derived d = derived(5);
  EXPECT_FALSE(d.claims.density);
  EXPECT_NE(std::find(d.reasons.begin(), d.reasons.end(), "level 0: patches are smaller than 9 sampling radii"),
            d.reasons.end());
}

}  // namespace
}  // namespace delcert
