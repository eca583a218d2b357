#include "proofs/certificate/space_form_distortion.hpp"

#include <gtest/gtest.h>

#include "tests/kernel/manifold/exhaustive.hpp"
#include "tests/proofs/certificate/space_form_run.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

Claims claims_of(const Rational& epsilon) {
  Claims claims;
  claims.stars = StarMargins{epsilon / Rational(20), ratio(1, 7), Rational(11) * epsilon / Rational(10)};
  claims.delaunay = DelaunayClaim{DelaunayClaim::Balls{Rational(0), Rational(11) * epsilon / Rational(10)}, {}};
  return claims;
}

SpaceFormDistortion measured(const std::string& name, const Rational& epsilon, const Claims& claims) {
  const SpaceForm form = verify_space_form(find_space_form(name));
  auto net = space_form_net<2>(form, epsilon, 1, no_progress());
  const SpaceFormAtlas<2> atlas(form, std::move(net.centres), epsilon);
  return measure_distortion<2>(atlas, stated_parameters(measured_parameters(Dimension(2), 1), Dimension(2)), claims);
}

TEST(SpaceFormDistortion, is_enclosed_by_the_farthest_pair_of_neighbours) {
  const Rational epsilon = ratio(1, 10);
  for (const std::string name : {"projective-plane", "bolza-surface"}) {
    const auto found = measured(name, epsilon, claims_of(epsilon));
    EXPECT_LE(found.farthest, ratio(6, 10));
    EXPECT_GT(found.farthest, ratio(595, 1000));
    EXPECT_GT(found.needed, 0.98 * found.transitions.of_pairs.upper);
    EXPECT_LE(found.needed, found.transitions.of_pairs.lower);
    EXPECT_FALSE(found.demand.is_met);
    EXPECT_EQ(found.ledger.perturbation, ratio(1, 4));
  }
}

TEST(SpaceFormDistortion, leaves_the_stability_lemma_no_margin_on_curved_surfaces) {
  const Rational epsilon = ratio(1, 10);
  for (const std::string name : {"projective-plane", "bolza-surface"}) {
    const auto margin = measured(name, epsilon, claims_of(epsilon)).stability.value();
    // ρ₀ε + 2·1.1ε + 2·1.1ε, more on a sphere; Υδ/36 with μ₀′ of nearly (1 − 2ρ₀)/1.1 = 5/11 at most.
    EXPECT_GE(margin.radius, ratio(465, 1000));
    EXPECT_LT(margin.radius, ratio(6, 10));
    EXPECT_EQ(margin.centres, ratio(27, 100));
    EXPECT_LE(margin.allowed, ratio(5, 11) / Rational(7) * ratio(5, 1000) / Rational(36));
    EXPECT_GT(*margin.by_transitions, margin.allowed);
    EXPECT_GT(*margin.by_charts, margin.allowed);
  }
}

TEST(SpaceFormDistortion, leaves_all_of_the_margin_on_flat_ones) {
  const Rational epsilon = ratio(1, 24);
  const auto found = measured("klein-bottle", epsilon, claims_of(epsilon));
  EXPECT_EQ(found.transitions.of_pairs.upper, 0);
  EXPECT_EQ(found.metric, 0);
  EXPECT_EQ(*found.stability->by_transitions, Rational(0));
  EXPECT_EQ(*found.stability->by_charts, Rational(0));
  EXPECT_EQ(found.stability->allowed, ratio(5, 11) / Rational(7) * (epsilon / Rational(20)) / Rational(36));
  EXPECT_FALSE(measured("klein-bottle", epsilon, {}).stability.has_value());
}

TEST(SpaceFormDistortion, is_not_known_for_stars_beyond_the_region_of_interest) {
  const Rational epsilon = ratio(1, 10);
  Claims claims = claims_of(epsilon);
  claims.stars->circumradius = Rational(2) * epsilon;
  const auto margin = measured("bolza-surface", epsilon, claims).stability.value();
  EXPECT_FALSE(margin.by_transitions.has_value());
  EXPECT_FALSE(margin.by_charts.has_value());
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
