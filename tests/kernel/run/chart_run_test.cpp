#include "kernel/run/chart_run.hpp"

#include "kernel/manifold/gluing/atlas_distortion.hpp"
#include "kernel/manifold/gluing/gluing_check.hpp"
#include "kernel/manifold/space_form_file.hpp"
#include "kernel/parallel/threads.hpp"
#include "kernel/sample/atlas_net.hpp"
#include "kernel/sample/separation.hpp"
#include "kernel/sample/space_form_net.hpp"
#include "kernel/sample/submanifold_net.hpp"
#include "kernel/stars/stable_stars.hpp"
#include "kernel/theorems/piecewise_flat.hpp"
#include "kernel/theorems/riemannian_simplices.hpp"
#include "kernel/topology/homology.hpp"
#include "tests/kernel/manifold/gluing/atlas_samples.hpp"
#include "tests/kernel/manifold/submanifold/samples.hpp"
#include "tests/kernel/perturb/scene.hpp"
#include "tests/kernel/stars/curved_patch.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

const ModelGeometry unit_sphere{Curvature::positive, Rational(3)};
const ModelGeometry unit_torus{Curvature::zero, ratio(1, 2)};

template <int m>
ExactPoints<m> exact_points(const PointSet<m>& set) {
  ExactPoints<m> result;
  for (std::uint32_t index = 0; index < set.size(); ++index) result.push_back(set.exact(Label(index)));
  return result;
}

TEST(RunInCharts, certifies_a_perturbed_net_of_a_sphere) {
  const auto atlas = sphere(ratio(1, 5));
  const auto run = run_in_charts<2>(atlas, unit_sphere, measured_parameters(Dimension(2), 1), {}, no_progress());
  ASSERT_TRUE(run.is_certified());
  EXPECT_EQ(run.complex.euler_characteristic(), 2);
  EXPECT_EQ(run.complex.simplices().size(), 2 * atlas.size() - 4);
  const auto groups = homology(run.complex.label_complex());
  EXPECT_EQ(group_text(groups[1]), "0");
  EXPECT_GT(run.margins.protection, 0.002);
  EXPECT_GT(run.margins.thickness, 0.05);
  EXPECT_LT(run.margins.circumradius, 2 * 0.2);
  EXPECT_GT(run.model.protection, 0.002);
  EXPECT_EQ(run.statistics.placements, atlas.size() + run.repaired_points);
  for (std::uint32_t index = 0; index < atlas.size(); ++index) {
    const auto& v = run.points.exact(Label(index));
    EXPECT_LE(square(v[0]) + square(v[1]), square(ratio(1, 20)));
  }
}

TEST(RunInCharts, without_perturbation_certifies_nothing_of_a_raw_net_and_names_the_stars) {
  const auto atlas = sphere(ratio(1, 5));
  RunRequest request;
  request.perturb = false;
  const auto parameters = measured_parameters(Dimension(2), 1);
  const auto run = run_in_charts<2>(atlas, unit_sphere, parameters, request, no_progress());
  EXPECT_FALSE(run.is_certified());
  ASSERT_FALSE(run.agreement.failures.empty());
  EXPECT_TRUE(mentions(run.agreement.failures[0].reason, " but not of ")) << run.agreement.failures[0].reason;
  EXPECT_EQ(run.agreement.missing, run.first_agreement.missing);
  EXPECT_EQ(run.statistics.placements, 0U);
  EXPECT_EQ(run.repair_rounds, 0);
}

TEST(RunInCharts, repairs_stars_that_disagree) {
  // A perturbation without tolerances leaves what disagrees to be repaired.
  const auto atlas = sphere(ratio(1, 4), 3);
  auto parameters = measured_parameters(Dimension(2), 1);
  parameters.tolerance = Rational(0);
  parameters.clearance = Rational(0);
  parameters.choices = 1;
  std::size_t repaired = 0;
  std::size_t disagreeing = 0;
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    parameters.seed = seed;
    const auto run = run_in_charts<2>(atlas, unit_sphere, parameters, {}, no_progress());
    EXPECT_TRUE(run.is_certified());
    EXPECT_EQ(run.repair_rounds > 0, run.repaired_points > 0);
    if (run.first_agreement.missing > 0 || run.first_failures > 0) {
      EXPECT_GT(run.repair_rounds, 0);
      ++disagreeing;
    }
    repaired += run.repaired_points;
    // Only what a moved point concerns is computed again: the same as all anew.
    ChartView<2> view(atlas, run.points, unit_sphere);
    for (std::uint32_t index = 0; index < atlas.size(); ++index) {
      EXPECT_EQ(chart_star<2>(view, Label(index)).star.simplices, run.complex.chart_star(Label(index)).simplices);
    }
  }
  EXPECT_GT(disagreeing, 0U);
  EXPECT_GT(repaired, 0U);
}

TEST(RunInCharts, repairs_until_the_required_protection_is_reached) {
  const auto atlas = sphere(ratio(1, 5));
  auto parameters = measured_parameters(Dimension(2), 1);
  parameters.clearance = Rational(0);
  parameters.choices = 1;
  const auto before = run_in_charts<2>(atlas, unit_sphere, parameters, {}, no_progress());
  ASSERT_TRUE(before.is_certified());
  RunRequest request;
  request.required_protection = ratio(1, 200);
  ASSERT_LT(before.margins.protection, 0.005);
  const auto run = run_in_charts<2>(atlas, unit_sphere, parameters, request, no_progress());
  ASSERT_TRUE(run.is_certified());
  EXPECT_GT(run.margins.protection, 0.005);
  EXPECT_GT(run.repair_rounds, 0);
  request.required_protection = ratio(1, 12);
  request.most_repair_rounds = 1;
  const auto refused = run_in_charts<2>(atlas, unit_sphere, parameters, request, no_progress());
  EXPECT_FALSE(refused.is_certified());
  EXPECT_EQ(refused.repair_rounds, 1);
  EXPECT_TRUE(mentions(refused.star_failures.front().reason, "is less protected than required: label "));
}

TEST(RunInCharts, is_the_same_every_time_and_chooses_well) {
  const auto atlas = sphere(ratio(1, 5));
  const auto parameters = measured_parameters(Dimension(2), 7);
  const auto first = run_in_charts<2>(atlas, unit_sphere, parameters, {}, no_progress());
  const auto second = run_in_charts<2>(atlas, unit_sphere, parameters, {}, no_progress());
  EXPECT_EQ(exact_points<2>(first.points), exact_points<2>(second.points));
  EXPECT_EQ(first.complex.simplices(), second.complex.simplices());
  EXPECT_EQ(first.margins.protection, second.margins.protection);
  // The second tolerance is worth it.
  auto plain = parameters;
  plain.clearance = Rational(0);
  plain.choices = 1;
  const auto third = run_in_charts<2>(atlas, unit_sphere, plain, {}, no_progress());
  EXPECT_GT(first.margins.protection, third.margins.protection);
}

TEST(RunInCharts, of_a_flat_torus_has_the_complex_of_the_flat_run) {
  std::vector<Vector<Rational, 2>> net;
  for (long a = 0; a < 24; ++a) {
    for (long b = 0; b < 24; ++b) net.push_back({ratio(a, 24), ratio(b, 24)});
  }
  const FlatAtlas<2> atlas(cubic_torus<2>(), PointSet<2>(net), ratio(1, 32));
  const auto parameters = measured_parameters(Dimension(2), 1);
  const auto run = run_in_charts<2>(atlas, unit_torus, parameters, {}, no_progress());
  // The flat run places points in another order; so it is given where they are.
  const FlatAtlas<2> moved(cubic_torus<2>(), PointSet<2>(exact_points<2>(run.points)), ratio(1, 32));
  RunRequest as_they_are;
  as_they_are.perturb = false;
  const auto flat = run_algorithm<2>(moved, parameters, as_they_are, no_progress());
  ASSERT_TRUE(run.is_certified());
  ASSERT_TRUE(flat.is_certified());
  for (std::uint32_t index = 0; index < atlas.size(); ++index) {
    EXPECT_EQ(run.complex.star(Label(index)), flat.complex.star(Label(index)));
  }
  EXPECT_NEAR(run.margins.protection, approximate_double(flat.protection.margins->protection), 1e-3 / 32);
  EXPECT_LE(flat.protection.margins->protection, Rational::exactly(run.margins.protection) * ratio(2049, 2048));
}

TEST(RunInCharts, without_perturbation_of_a_square_lattice_names_every_star) {
  std::vector<Vector<Rational, 2>> net;
  for (long a = 0; a < 16; ++a) {
    for (long b = 0; b < 16; ++b) net.push_back({ratio(a, 16), ratio(b, 16)});
  }
  const FlatAtlas<2> atlas(cubic_torus<2>(), PointSet<2>(net), ratio(3, 64));
  RunRequest request;
  request.perturb = false;
  const auto run = run_in_charts<2>(atlas, unit_torus, measured_parameters(Dimension(2), 1), request, no_progress());
  EXPECT_FALSE(run.is_certified());
  EXPECT_EQ(run.first_failures, 256U);
}

template <int m>
SpaceFormAtlas<m> member(const std::string& name, const Rational& radius, int factor = 9) {
  const auto form = verify_space_form(find_space_form(name));
  auto net = space_form_net<m>(form, radius, 1, no_progress());
  return SpaceFormAtlas<m>(form, std::move(net.centres), radius, factor);
}

TEST(RunInCharts, certifies_surfaces_of_every_curvature_with_their_homology) {
  struct Member {
    std::string name;
    Rational radius;
    std::string homology;
    std::int64_t characteristic;
  };
  for (const auto& [name, radius, groups, characteristic] :
       {Member{"sphere-2", ratio(1, 8), "0", 2}, Member{"projective-plane", ratio(1, 8), "Z/2", 1},
        Member{"klein-bottle", ratio(1, 24), "Z + Z/2", 0}, Member{"bolza-surface", ratio(1, 8), "Z^4", -2}}) {
    const auto atlas = member<2>(name, radius);
    const auto run = run_in_charts<2>(atlas, measured_parameters(Dimension(2), 1), {}, no_progress());
    ASSERT_TRUE(run.is_certified()) << name;
    EXPECT_EQ(run.complex.euler_characteristic(), characteristic) << name;
    EXPECT_EQ(group_text(homology(run.complex.label_complex())[1]), groups) << name;
    EXPECT_GT(run.margins.protection, approximate_double(radius) / 100);
    const auto stability = check_stability<2>(atlas, run.points, geometry_of(atlas), run.complex, no_progress());
    EXPECT_TRUE(stability.failures.empty()) << name;
  }
}

TEST(RunInCharts, certifies_the_three_sphere) {
  // Coarse, with patches of five sampling radii.
  const auto atlas = member<3>("sphere-3", ratio(1, 4), 5);
  auto parameters = measured_parameters(Dimension(3), 1);
  parameters.choices = 20;
  const auto run = run_in_charts<3>(atlas, parameters, {}, no_progress());
  ASSERT_TRUE(run.is_certified());
  EXPECT_EQ(run.complex.euler_characteristic(), 0);
  EXPECT_EQ(group_text(homology(run.complex.label_complex())[1]), "0");
}

/// All that depends on a run and could depend on threads.
template <int m>
void check_threads(const SpaceFormAtlas<m>& atlas, const PerturbationParameters& parameters) {
  struct Found {
    ExactPoints<m> points;
    std::vector<LabelSimplex<m>> simplices;
    std::vector<std::vector<ChartSimplex<m>>> stars;
    std::vector<double> doubles;
    std::vector<std::uint64_t> counts;
    Rational separation;
    bool operator==(const Found&) const = default;
  };
  std::vector<Found> all;
  for (const unsigned limit : {1U, 2U, 4U}) {
    const ThreadLimit threads(limit);
    const auto run = run_in_charts<m>(atlas, parameters, {}, no_progress());
    ASSERT_TRUE(run.is_certified());
    const auto geometry = geometry_of(atlas);
    const auto exact = measure_riemannian_simplices<m>(atlas, run.points, geometry, run.complex, no_progress());
    const auto flat =
        measure_piecewise_flat<m>(atlas, run.points, geometry, run.complex, run.model.circumradius, no_progress());
    StarStability stability;
    if constexpr (m == 2) stability = check_stability<m>(atlas, run.points, geometry, run.complex, no_progress());
    Found& found = all.emplace_back();
    found.points = exact_points<m>(run.points);
    found.simplices = run.complex.simplices();
    for (std::uint32_t index = 0; index < atlas.size(); ++index)
      found.stars.push_back(run.complex.chart_star(Label(index)).simplices);
    found.doubles = {run.margins.protection,
                     run.margins.thickness,
                     run.margins.circumradius,
                     run.margins.reach,
                     run.model.protection,
                     run.model.circumradius,
                     exact.thickness,
                     exact.star_radius,
                     exact.scale,
                     flat.least_weight,
                     flat.lower,
                     flat.upper,
                     stability.margins.protection,
                     stability.margins.reach};
    found.counts = {run.statistics.placements,   run.statistics.tries,   run.statistics.most_tries,
                    run.statistics.candidates,   run.statistics.visited, run.repaired_points,
                    run.first_agreement.missing, flat.unrealised,        flat.hinges,
                    flat.not_delaunay,           stability.pairs,        stability.differing};
    found.separation = measure_separation<m>(atlas);
    EXPECT_TRUE(found == all.front()) << limit << " threads";
  }
}

TEST(RunInCharts, is_the_same_for_any_number_of_threads) {
  check_threads<2>(member<2>("sphere-2", ratio(1, 8)), measured_parameters(Dimension(2), 1));
  check_threads<2>(member<2>("klein-bottle", ratio(1, 24)), measured_parameters(Dimension(2), 1));
  auto parameters = measured_parameters(Dimension(3), 1);
  parameters.choices = 10;
  check_threads<3>(member<3>("sphere-3", ratio(1, 4), 5), parameters);
}

template <int m>
void check_failures(const Atlas<m>& atlas, const ModelGeometry& geometry) {
  RunRequest request;
  request.perturb = false;
  std::vector<std::string> texts;
  for (const unsigned limit : {1U, 2U, 4U}) {
    const ThreadLimit threads(limit);
    const auto parameters = measured_parameters(Dimension(m), 1);
    const auto run = run_in_charts<m>(atlas, geometry, parameters, request, no_progress());
    std::string& text = texts.emplace_back();
    for (const auto* failures : {&run.star_failures, &run.agreement.failures, &run.model.failures}) {
      for (const auto& failure : *failures) text += failure.reason + "\n";
    }
    EXPECT_EQ(text, texts.front());
  }
  EXPECT_FALSE(texts.front().empty());
}

TEST(RunInCharts, names_the_same_failures_in_the_same_order_for_any_number_of_threads) {
  const auto sphere = member<2>("sphere-2", ratio(1, 6));
  check_failures<2>(sphere, geometry_of(sphere));
  // Of degenerate points, where proposals are arbitrary.
  std::vector<Vector<Rational, 2>> lattice;
  for (long a = 0; a < 16; ++a) {
    for (long b = 0; b < 16; ++b) lattice.push_back({ratio(a, 16), ratio(b, 16)});
  }
  check_failures<2>(FlatAtlas<2>(cubic_torus<2>(), PointSet<2>(lattice), ratio(3, 64)), unit_torus);
}

/// A net of a zero set, run as it is and perturbed.
void check_zero_set(const ZeroSet& m, const Rational& radius, long characteristic, bool is_stable) {
  const SubmanifoldAtlas<2> atlas(m, submanifold_net<2>(m, radius, 1, no_progress()).charts, radius, no_progress());
  const auto geometry = geometry_of<2>(atlas);
  RunRequest request;
  request.certify_model = false;
  const auto parameters = measured_parameters(Dimension(2), 1);
  request.perturb = false;
  const auto raw = run_in_charts<2>(atlas, geometry, parameters, request, no_progress());
  EXPECT_GT(raw.agreement.missing, 0U);
  request.perturb = true;
  const auto run = run_in_charts<2>(atlas, geometry, parameters, request, no_progress());
  ASSERT_TRUE(run.is_certified());
  EXPECT_EQ(run.complex.euler_characteristic(), characteristic);
  EXPECT_GT(run.margins.protection, 0.005 * approximate_double(radius));
  const auto stability = check_stability<2>(atlas, run.points, geometry, run.complex, no_progress());
  EXPECT_EQ(stability.differing == 0, is_stable);
}

TEST(RunInCharts, certifies_zero_sets) {
  check_zero_set(torus_of_revolution(), ratio(1, 16), 0, true);
  check_zero_set(
      zero_set("ellipsoid", {"x", "y", "z"}, {"x^2/4 + 4*y^2/9 + z^2 - 1"}, {ratio(5, 2), Rational(2), ratio(3, 2)}),
      ratio(1, 24), 2, true);
}

/// A net of an atlas by formulas, verified, sampled and certified: levels 1, 2, and 2s if it is to be stable.
template <int m>
void check_formula_atlas(const std::string& name, const Rational& radius, bool is_stable) {
  const auto gluing = std::make_shared<const ChartGluing>(atlas_named(name));
  (void)check_gluing(*gluing);
  FormulaAtlas<m> atlas(gluing, atlas_net<m>(*gluing, radius, 1, no_progress()).places, radius);
  const ModelGeometry geometry = geometry_of<m>(atlas, fit_patches<m>(atlas, no_progress()));
  RunRequest request;
  request.certify_model = false;
  const auto run = run_in_charts<m>(atlas, geometry, measured_parameters(Dimension(m), 1), request, no_progress());
  ASSERT_TRUE(run.is_certified()) << name << ": " << run.star_failures.size() << " stars, " << run.agreement.missing;
  std::vector<std::string> groups;
  for (const auto& group : homology(run.complex.label_complex())) groups.push_back(group_text(group));
  EXPECT_EQ(groups, gluing->description().homology) << name;
  if (!is_stable) return;
  const auto stability = check_stability<m>(atlas, run.points, geometry, run.complex, no_progress());
  EXPECT_EQ(stability.differing, 0U) << name << ", of " << stability.pairs;
}

TEST(RunInCharts, certifies_atlases_by_formulas) {
  check_formula_atlas<2>("projective-plane-by-charts", ratio(1, 20), false);
  check_formula_atlas<2>("sphere-2-stereographic", ratio(1, 48), true);
  check_formula_atlas<2>("klein-bottle-rectangles", ratio(1, 40), true);
  check_formula_atlas<2>("torus-2-bent", ratio(1, 56), true);
}

TEST(RunInCharts, places_points_anew_that_a_neighbour_shows_in_the_ball_of_a_star) {
  const Rational radius(Integer(1), Integer(40));
  const auto gluing = std::make_shared<const ChartGluing>(atlas_named("torus-2-bent"));
  FormulaAtlas<2> atlas(gluing, atlas_net<2>(*gluing, radius, 1, no_progress()).places, radius);
  const ModelGeometry geometry = geometry_of<2>(atlas, fit_patches<2>(atlas, no_progress()));
  RunRequest request;
  request.certify_model = false;
  const auto run = [&] {
    return run_in_charts<2>(atlas, geometry, measured_parameters(Dimension(2), 1), request, no_progress());
  };
  const auto as_it_is = run();
  ASSERT_TRUE(as_it_is.is_certified());
  EXPECT_FALSE(as_it_is.stability);
  const auto found = check_stability<2>(atlas, as_it_is.points, geometry, as_it_is.complex, no_progress());
  EXPECT_GT(found.occupied, 0U);
  EXPECT_EQ(found.occupied, found.stars);
  request.repair_stability = true;
  const auto repaired = run();
  ASSERT_TRUE(repaired.is_certified());
  ASSERT_TRUE(repaired.stability);
  EXPECT_TRUE(repaired.stability->failures.empty());
  EXPECT_GT(repaired.repaired_points, as_it_is.repaired_points);
  // Without rounds the stars are certified all the same.
  request.most_repair_rounds = 0;
  const auto left = run();
  EXPECT_TRUE(left.is_certified());
  EXPECT_EQ(left.stability->stars, found.stars);
}

TEST(RunInCharts, has_the_stars_of_the_flat_torus_on_an_atlas_of_it) {
  const Rational radius(Integer(1), Integer(24));
  const auto gluing = std::make_shared<const ChartGluing>(atlas_named("torus-2-by-charts"));
  const FormulaAtlas<2> atlas(gluing, atlas_net<2>(*gluing, radius, 1, no_progress()).places, radius);
  const ModelGeometry geometry = geometry_of<2>(atlas, *measure_transitions<2>(atlas, ratio(1, 4), no_progress()));
  RunRequest request;
  request.certify_model = false;
  const auto parameters = measured_parameters(Dimension(2), 1);
  const auto run = run_in_charts<2>(atlas, geometry, parameters, request, no_progress());
  ASSERT_TRUE(run.is_certified());
  ExactPoints<2> points;
  for (std::uint32_t index = 0; index < atlas.size(); ++index) {
    auto x = atlas.position(Label(index), run.points.exact(Label(index)));
    for (Rational& coordinate : x) coordinate -= Rational(floor_of(coordinate));
    points.push_back(x);
  }
  request.perturb = false;
  const auto flat_run = [&] {
    const FlatAtlas<2> flat(cubic_torus<2>(), PointSet<2>(points), radius);
    return run_in_charts<2>(flat, unit_torus, parameters, request, no_progress());
  };
  const auto same = flat_run();
  ASSERT_TRUE(same.is_certified());
  EXPECT_EQ(run.complex.simplices(), same.complex.simplices());
  EXPECT_NEAR(run.margins.protection, same.margins.protection, 1e-12);
  // Of other points it has others.
  std::swap(points[0], points[1]);
  EXPECT_NE(run.complex.simplices(), flat_run().complex.simplices());
}

TEST(GeometryOf, is_what_was_certified_of_the_group) {
  const auto atlas = member<2>("projective-plane", ratio(1, 8), 5);
  const auto geometry = geometry_of(atlas);
  EXPECT_EQ(geometry.curvature, Curvature::positive);
  EXPECT_EQ(geometry.injectivity_radius, atlas.form().injectivity_radius.lower);
  EXPECT_EQ(geometry.patch_factor, 5);
}

TEST(MeasuredParameters, exist_for_surfaces_and_in_dimension_3) {
  EXPECT_EQ(measured_parameters(Dimension(2), 4).seed, 4U);
  EXPECT_LT(measured_parameters(Dimension(3), 4).tolerance, measured_parameters(Dimension(2), 4).tolerance);
  EXPECT_THROW((void)measured_parameters(Dimension(4), 1), std::invalid_argument);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
