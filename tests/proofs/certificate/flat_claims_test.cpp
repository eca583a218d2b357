#include "proofs/certificate/flat_claims.hpp"

#include "kernel/sample/net_measure.hpp"
#include "kernel/sample/poisson_disk.hpp"
#include "kernel/sample/separation.hpp"
#include "tests/kernel/manifold/exhaustive.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

using Names = std::vector<std::string>;

/// A run from net to stars, as `delcert certify` does it.
template <int m>
struct RunOn {
  RunOn(const FlatSpace<m>& space, const Rational& radius, RunMode mode) {
    const PointSet<m> net(poisson_disk_net<m>(space, radius, 1, no_progress()));
    auto density = measure_density<m>(space, net, radius, no_progress());
    net_simplices = std::move(density.simplices);
    atlas.emplace(space, net, density.sampling_radius);
    ParameterChoice choice;
    choice.mode = mode;
    parameters = parameters_for(Dimension(m), measure_separation<m>(*atlas), choice);
    RunRequest request;
    request.perturb = mode != RunMode::none;
    run.emplace(run_algorithm<m>(*atlas, parameters.algorithm, request, no_progress()));
  }

  std::vector<LiftedSimplex<m>> net_simplices;
  std::optional<FlatAtlas<m>> atlas;
  RunParameters parameters;
  std::optional<RunResult<m>> run;
};

/// The flat torus of the hexagonal lattice at ε = 1/24 in theory mode: made once.
const RunOn<2>& surface() {
  static const RunOn<2> result(hexagonal_torus(), ratio(1, 24), RunMode::theory);
  return result;
}

struct Derived {
  Claims claims;
  std::vector<std::string> reasons;

  [[nodiscard]] bool has_reason(const std::string& part) const {
    return std::any_of(reasons.begin(), reasons.end(), [&](const auto& reason) { return mentions(reason, part); });
  }
};

template <int m>
Derived derive(const RunOn<m>& small, const RunResult<m>& run, const LevelSelection& selection = all_levels()) {
  Derived result;
  result.claims = derive_claims<m>(*small.atlas, small.parameters, run, selection, no_progress(), result.reasons);
  return result;
}

template <int m>
Derived derive(const RunOn<m>& small, const LevelSelection& selection = all_levels()) {
  return derive<m>(small, *small.run, selection);
}

/// The run with other margins.
RunResult<2> with_margins(const Rational& circumradius, const Rational& protection) {
  RunResult<2> run = *surface().run;
  run.protection.margins->circumradius = circumradius;
  run.protection.margins->protection = protection;
  return run;
}

TEST(FlatClaims, of_a_torus_in_theory_mode_reach_every_level) {
  const auto& small = surface();
  ASSERT_TRUE(small.run->is_certified());
  const auto [claims, reasons] = derive(small);
  EXPECT_EQ(claims.names(), (Names{"0", "1", "2", "2s", "3", "4", "5", "6"}));
  EXPECT_TRUE(reasons.empty());
  EXPECT_EQ(claims.input->hypotheses_2, true);
  EXPECT_EQ(claims.stars->protection, small.run->protection.margins->protection);
  EXPECT_EQ(claims.manifold->simplices, small.run->complex.simplices().size());
  EXPECT_EQ(claims.manifold->simplices, 2 * small.atlas->size());
  EXPECT_EQ(claims.manifold->euler_characteristic, 0);
  EXPECT_TRUE(claims.manifold->closed);
  EXPECT_EQ(claims.manifold->homology, (std::vector<AbelianGroup>{{1, {}}, {2, {}}, {1, {}}}));
  EXPECT_TRUE(mentions(*claims.no_forbidden, " sets of 3 to 4 points, "));
}

TEST(FlatClaims, are_limited_to_the_levels_selected) {
  const auto& small = surface();
  const auto names = [&](const LevelSelection& selection) { return derive(small, selection).claims.names(); };
  EXPECT_EQ(names({"0"}), (Names{"0"}));
  EXPECT_EQ(names({"1"}), (Names{"1", "2"}));
  EXPECT_EQ(names({"2"}), (Names{"1", "2"}));
  EXPECT_EQ(names({"0", "3"}), (Names{"0", "3"}));
  EXPECT_EQ(names({"0", "1", "2", "4", "5"}), (Names{"0", "1", "2", "4", "5"}));
  EXPECT_EQ(names({"1", "2", "4"}), (Names{"1", "2", "4"}));
  // A level is claimed only together with those that it rests on.
  EXPECT_EQ(names({"3"}), Names{});
  EXPECT_EQ(names({"2", "2s"}), (Names{"1", "2"}));
  EXPECT_EQ(names({"0", "2s"}), (Names{"0"}));
  EXPECT_EQ(names({"4", "5", "6"}), Names{});
  EXPECT_EQ(names({"2", "5"}), (Names{"1", "2"}));
  EXPECT_EQ(names({"2", "4", "6"}), (Names{"1", "2", "4"}));
  EXPECT_EQ(names({}), Names{});
}

TEST(FlatClaims, of_measured_mode_do_not_claim_hypotheses_2) {
  const RunOn<1> small(cubic_torus<1>(), ratio(1, 40), RunMode::measured);
  const auto [claims, reasons] = derive(small);
  EXPECT_EQ(claims.input->hypotheses_2, false);
  EXPECT_EQ(claims.names(), (Names{"0", "1", "2", "2s", "3", "4", "5", "6"}));
  EXPECT_TRUE(reasons.empty());
}

TEST(FlatClaims, of_a_ball_say_why_it_is_not_triangulated) {
  const RunOn<2> small(ball_of<2>(Rational(1)), ratio(1, 12), RunMode::theory);
  const auto derived = derive(small);
  EXPECT_EQ(derived.claims.names(), (Names{"0", "1", "2", "2s", "3", "4"}));
  EXPECT_FALSE(derived.claims.manifold->closed);
  ASSERT_EQ(derived.reasons.size(), 1U);
  EXPECT_TRUE(derived.has_reason("levels 5 and 6"));
  EXPECT_TRUE(derive(small, {"0", "1", "2", "4"}).reasons.empty());
}

TEST(FlatClaims, need_circumballs_that_fit_into_the_patches) {
  const auto& small = surface();
  const Rational& unit = small.atlas->sampling_radius();
  // 2r + δ ≤ 8ε, with equality; 16ε is below the systole 24ε.
  EXPECT_FALSE(derive(small, with_margins(ratio(15, 4) * unit, ratio(1, 2) * unit)).claims.names().empty());
  const Rational hair = Rational::power_of_two(-200);
  const auto derived = derive(small, with_margins(ratio(15, 4) * unit, ratio(1, 2) * unit + hair));
  EXPECT_TRUE(derived.claims.names().empty());
  EXPECT_TRUE(derived.has_reason("level 1"));
}

TEST(FlatClaims, need_lattice_vectors_longer_than_twice_the_circumballs) {
  // On the circle at ε = 1/8: 4r + 2δ < 1 although 2r + δ ≤ 8ε = 1.
  RunOn<1> small(cubic_torus<1>(), ratio(1, 40), RunMode::none);
  const auto net = small.atlas->net();
  small.atlas.emplace(cubic_torus<1>(), net, ratio(1, 8));
  RunResult<1> run = *small.run;
  run.protection.margins->circumradius = ratio(6, 25);
  run.protection.margins->protection = ratio(1, 50);
  EXPECT_TRUE(derive<1>(small, run, {"1"}).has_reason("level 1")) << "4r + 2δ = 1";
  run.protection.margins->protection = ratio(1, 51);
  EXPECT_EQ(derive<1>(small, run, {"1"}).claims.names(), (Names{"1", "2"}));
}

TEST(FlatClaims, of_stable_stars_need_stars_in_the_patches_of_their_vertices) {
  const auto& small = surface();
  const Rational& unit = small.atlas->sampling_radius();
  // 4r + 2ρ₀ε < 9ε with ρ₀ = 1/4: r < 17/8 ε.
  const Rational hair = Rational::power_of_two(-200);
  const LevelSelection levels{"0", "1", "2", "2s", "4"};
  const auto below = derive(small, with_margins(ratio(17, 8) * unit - hair, hair), levels);
  EXPECT_EQ(below.claims.names(), (Names{"0", "1", "2", "2s", "4"}));
  EXPECT_TRUE(below.reasons.empty());
  const auto tie = derive(small, with_margins(ratio(17, 8) * unit, hair), levels);
  EXPECT_EQ(tie.claims.names(), (Names{"0", "1", "2", "4"}));
  EXPECT_TRUE(tie.has_reason("level 2s"));
}

TEST(FlatClaims, of_level_3_name_a_forbidden_configuration) {
  const auto& small = surface();
  RunResult<2> run = *small.run;
  const Rational& unit = small.atlas->sampling_radius();
  // Four points that are near each other moved onto the corners of a rectangle: (1, 0) and (−1/2, 1) are orthogonal.
  const auto corner = run.points.exact(Label(100));
  std::vector<Label> labels;
  for (const auto& seen : small.atlas->neighbours(Label(100))) {
    if (seen.shift == Shift<2>{} && labels.size() < 4) labels.push_back(label_of<2>(seen));
  }
  ASSERT_EQ(labels.size(), 4U);
  const Rational half = unit / Rational(2);
  const ExactPoints<2> offsets{{Rational(0), Rational(0)}, {unit, Rational(0)}, {-half, unit}, {half, unit}};
  {
    const FilterGuard guard;
    for (std::size_t k = 0; k < 4; ++k) run.points.place(labels[k], sum(corner, offsets[k]));
  }
  // They are far from where they were: perturbation is said to be large, so that they are looked for.
  RunParameters parameters = small.parameters;
  parameters.algorithm.perturbation = Rational(10);
  std::vector<std::string> reasons;
  const Claims claims = derive_claims<2>(*small.atlas, parameters, run, {"0", "3"}, no_progress(), reasons);
  EXPECT_EQ(claims.names(), (Names{"0"}));
  ASSERT_EQ(reasons.size(), 1U);
  std::string expected = "level 3: forbidden configuration (P1 to P4) of labels";
  std::sort(labels.begin(), labels.end());
  EXPECT_TRUE(mentions(reasons[0], expected)) << reasons[0];
  for (const Label label : labels) EXPECT_TRUE(mentions(reasons[0] + " ", " " + std::to_string(label.value) + " "));
}

// The same run, but a flake parameter of measured size: every near-cocircular quadruple has the properties.
TEST(FlatClaims, of_level_3_depend_on_the_flake_parameter) {
  RunParameters parameters = surface().parameters;
  parameters.squared_flake_parameter = Rational::power_of_two(-30);
  std::vector<std::string> reasons;
  const Claims claims =
      derive_claims<2>(*surface().atlas, parameters, *surface().run, {"0", "3"}, no_progress(), reasons);
  EXPECT_FALSE(claims.no_forbidden.has_value());
  ASSERT_EQ(reasons.size(), 1U);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
