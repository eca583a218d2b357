#include "kernel/perturb/candidates.hpp"

#include "kernel/number/algebraic.hpp"
#include "kernel/sample/poisson_disk.hpp"
#include "tests/kernel/perturb/scene.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

// --- is_farther

template <class S>
Verdict farther_on(const Rational& distance, const Rational& radius, const Rational& tolerance) {
  const Rational power = square(distance) - square(radius);
  return is_farther<S>(scalar_from<S>(power), scalar_from<S>(square(radius)), scalar_from<S>(square(tolerance)));
}

RC_GTEST_PROP(IsFarther, is_the_distance_from_the_sphere_on_every_rung, ()) {
  const Rational distance = absolute(*any_coordinate());
  const Rational radius = absolute(*any_coordinate());
  Rational tolerance = absolute(*any_coordinate());
  const int kind = *rc::gen::inRange(0, 4);
  const Rational nudge = kind == 3 ? Rational(0) : Rational::power_of_two(-*rc::gen::inRange(10, 150));
  // Exactly at the tolerance, give or take a hair.
  if (kind >= 1) tolerance = absolute(absolute(distance - radius) + (kind == 2 ? -nudge : nudge));
  const Verdict truth = verdict_of(absolute(distance - radius) > tolerance);
  RC_ASSERT(farther_on<Rational>(distance, radius, tolerance) == truth);
  RC_ASSERT(is_exactly_farther(square(distance), square(radius), square(tolerance)) == is_proved(truth));
  RC_ASSERT(agrees(farther_on<BigInterval>(distance, radius, tolerance), truth));
  const FilterGuard guard;
  RC_ASSERT(agrees(farther_on<Filter>(distance, radius, tolerance), truth));
}

TEST(IsFarther, decides_the_cases_of_the_formula) {
  const auto farther = [](long distance, long radius, long tolerance) {
    return is_proved(farther_on<Rational>(Rational(distance), Rational(radius), Rational(tolerance)));
  };
  EXPECT_TRUE(farther(10, 5, 4));
  EXPECT_FALSE(farther(9, 5, 4)) << "a tie outside";
  EXPECT_FALSE(farther(1, 5, 4)) << "a tie inside";
  EXPECT_TRUE(farther(0, 5, 4)) << "the centre";
  EXPECT_FALSE(farther(0, 4, 4));
  EXPECT_FALSE(farther(0, 1, 5)) << "inside a sphere that is smaller than the tolerance";
  EXPECT_FALSE(farther(3, 1, 5));
  EXPECT_TRUE(farther(7, 1, 5));
  EXPECT_TRUE(farther(3, 0, 2)) << "a sphere that is a point";
  EXPECT_FALSE(farther(5, 5, 0));
  EXPECT_TRUE(farther(5, 6, 0));
}

// --- candidates

/// Sets of lifts that the test collects for label i.
template <int m>
std::vector<Lifts<m>> collected(const CandidateTest<m>& test) {
  std::vector<Lifts<m>> result;
  for (const auto& candidate : test.candidates()) {
    result.emplace_back();
    for (std::uint32_t at = 0; at < candidate.vertex_count; ++at) {
      result.back().push_back(test.view().sighting(candidate.vertices[at]));
    }
  }
  std::sort(result.begin(), result.end());
  return result;
}

/// Positions in the ball of perturbations, many of them at the tolerance from one of the spheres, give or take a hair.
template <int m>
ExactPoints<m> positions(const Scene<m>& scene, std::uint32_t i, const std::vector<Lifts<m>>& candidates,
                         std::size_t count, std::uint64_t seed) {
  const Rational reach = scene.parameters.perturbation * scene.sampling_radius;
  ExactPoints<m> result;
  std::mt19937_64 random(seed);
  for (const auto& unit : random_points<m>(count, seed, 30, Rational(-1), Rational(2))) {
    auto x = sum(scene.net[i], scaled(reach, unit));
    if (!candidates.empty() && random() % 2 == 0) {
      const auto ball = scene.ball(candidates[random() % candidates.size()]);
      const auto spoke = difference(x, ball->centre);
      const Rational length = square_root_upper(squared_norm<m>(scene.space, spoke), 80);
      const Rational side(random() % 2 == 0 ? 1 : -1);
      const Rational hair = (Rational(random() % 3) - Rational(1)) * Rational::power_of_two(-56);
      const Rational wanted = square_root_upper(ball->squared_radius, 80) + side * scene.tolerance() + hair;
      x = sum(ball->centre, scaled(wanted / length, spoke));
      for (Rational& coordinate : x) coordinate = rounded_down(coordinate, -90);
    }
    if (squared_distance<m>(scene.space, x, scene.net[i]) <= square(reach)) result.push_back(x);
  }
  return result;
}

struct Tally {
  std::size_t candidates = 0;
  std::size_t bounded = 0;  // of these, in doubles
  int accepted = 0;
  int refused = 0;
};

/// The candidates of every label are those of the definition, and positions are accepted exactly when good.
template <int m>
Tally check_scene(const Scene<m>& scene, bool on_intervals = false) {
  Tally tally;
  const auto atlas = scene.atlas();
  const PointSet<m> points(scene.points);
  CandidateTest<m> test(atlas, points, scene.placed, scene.parameters);
  if (on_intervals) test.use_intervals_only();
  for (std::uint32_t i = 0; i < scene.net.size(); i += 4) {
    {
      const FilterGuard guard;
      test.prepare(Label(i));
    }
    const auto expected = scene.candidates(i);
    EXPECT_EQ(collected<m>(test), expected);
    EXPECT_EQ(test.candidate_count(), expected.size());
    EXPECT_GE(test.visited(), expected.size());
    tally.candidates += expected.size();
    for (const auto& candidate : test.candidates()) tally.bounded += candidate.is_bounded ? 1 : 0;
    for (const auto& x : positions<m>(scene, i, expected, 30, i + 1)) {
      const bool good = scene.is_good(expected, x);
      const FilterGuard guard;
      EXPECT_EQ(test.accepts(x), good);
      ++(good ? tally.accepted : tally.refused);
    }
  }
  return tally;
}

TEST(CandidateTest, has_the_candidates_of_the_definition_and_accepts_what_is_good) {
  Tally all;
  const auto add = [&all](const Tally& tally) {
    EXPECT_GT(tally.candidates, 20U);
    all.accepted += tally.accepted;
    all.refused += tally.refused;
  };
  const Rational tolerance = ratio(1, 32);
  add(check_scene(any_scene<1>(cubic_torus<1>(), random_points<1>(40, 1, 20), ratio(1, 25), tolerance, 1)));
  add(check_scene(any_scene<2>(hexagonal_torus(), random_points<2>(40, 2, 20), ratio(1, 9), tolerance, 2)));
  add(check_scene(
      any_scene<2>(square_torus_in_a_long_basis(), random_points<2>(40, 3, 20), ratio(1, 9), tolerance, 3)));
  add(check_scene(any_scene<3>(skewed_torus(), random_points<3>(30, 4, 20), ratio(1, 5), ratio(1, 64), 4)));
  add(check_scene(any_scene<4>(ball_of<4>(Rational(1)), random_points<4>(14, 5, 20), ratio(1, 2), ratio(1, 64), 5)));
  EXPECT_GT(all.accepted, 50);
  EXPECT_GT(all.refused, 50);
}

TEST(CandidateTest, is_the_same_on_intervals_only_as_with_doubles_first) {
  const auto plane = any_scene<2>(hexagonal_torus(), random_points<2>(40, 2, 20), ratio(1, 9), ratio(1, 32), 2);
  const auto solid = any_scene<3>(skewed_torus(), random_points<3>(30, 4, 20), ratio(1, 5), ratio(1, 64), 4);
  const Tally doubles[] = {check_scene(plane), check_scene(solid)};
  const Tally intervals[] = {check_scene(plane, true), check_scene(solid, true)};
  for (std::size_t at = 0; at < 2; ++at) {
    EXPECT_EQ(doubles[at].candidates, intervals[at].candidates);
    EXPECT_EQ(doubles[at].accepted, intervals[at].accepted);
    EXPECT_EQ(doubles[at].bounded, doubles[at].candidates) << "of points in general position all";
    EXPECT_EQ(intervals[at].bounded, 0U);
  }
}

TEST(CandidateTest, of_the_reference_modes_has_all_simplices_of_the_paper) {
  for (const auto rule : {CandidateRule::whole, CandidateRule::printed}) {
    auto plane = any_scene<2>(ball_of<2>(Rational(1)), random_points<2>(18, 6, 20), ratio(1, 9), ratio(1, 32), 6);
    plane.parameters.candidates = rule;
    plane.parameters.separation = ratio(1, 2);
    EXPECT_GT(check_scene(plane).candidates, 100U);
    auto solid = any_scene<3>(ball_of<3>(Rational(1)), random_points<3>(11, 7, 20), ratio(1, 3), ratio(1, 64), 7);
    solid.parameters.candidates = rule;
    EXPECT_GT(check_scene(solid).candidates, 100U);
  }
}

TEST(CandidateTest, leaves_out_no_candidate_among_degenerate_points) {
  // A square lattice as it is: collinear triples, four on a circle, spheres through points.
  ExactPoints<2> lattice;
  for (long a = 0; a < 9; ++a) {
    for (long b = 0; b < 9; ++b) lattice.push_back({ratio(a, 9), ratio(b, 9)});
  }
  auto scene = any_scene<2>(cubic_torus<2>(), lattice, ratio(1, 12), ratio(1, 32), 8);
  scene.points = scene.net;
  auto wider = scene;
  wider.parameters.edge_bound += Rational::power_of_two(-30);
  wider.parameters.circumradius_bound += Rational::power_of_two(-30);
  wider.parameters.perturbation += Rational::power_of_two(-30);
  const auto atlas = scene.atlas();
  const PointSet<2> points(scene.points);
  CandidateTest<2> test(atlas, points, scene.placed, scene.parameters);
  std::size_t total = 0;
  for (std::uint32_t i = 0; i < 30; i += 7) {
    const FilterGuard guard;
    test.prepare(Label(i));
    const auto found = collected<2>(test);
    const auto exact = scene.candidates(i);
    const auto outer = wider.candidates(i);
    total += exact.size();
    EXPECT_TRUE(std::includes(found.begin(), found.end(), exact.begin(), exact.end()));
    EXPECT_TRUE(std::includes(outer.begin(), outer.end(), found.begin(), found.end()));
  }
  EXPECT_GT(total, 5U);
}

TEST(CandidateTest, decides_positions_exactly_at_the_tolerance) {
  // The edge from (0, 0) to (3/5, 0): centre (3/10, 0), radius 3/10; x = (3/10, 3/10 ± t).
  Scene<2> scene;
  scene.space = ball_of<2>(Rational(9));
  scene.net = {{Rational(0), Rational(0)}, {ratio(3, 5), Rational(0)}, {ratio(3, 10), ratio(3, 10)}};
  scene.points = scene.net;
  scene.placed = {true, true, false};
  scene.sampling_radius = Rational(1);
  scene.parameters.separation = Rational(1);
  scene.parameters.perturbation = ratio(1, 4);
  scene.parameters.tolerance = ratio(1, 10);
  scene.parameters.edge_bound = ratio(5, 2);
  scene.parameters.circumradius_bound = Rational(2);
  const auto atlas = scene.atlas();
  const PointSet<2> points(scene.points);
  CandidateTest<2> test(atlas, points, scene.placed, scene.parameters);
  const FilterGuard guard;
  test.prepare(Label(2));
  ASSERT_EQ(test.candidate_count(), 1U);
  const Rational hair = Rational::power_of_two(-300);
  for (const Rational& side : {Rational(1), Rational(-1)}) {
    const Rational tie = ratio(3, 10) + side * ratio(1, 10);
    EXPECT_FALSE(test.accepts({ratio(3, 10), tie}));
    EXPECT_TRUE(test.accepts({ratio(3, 10), tie + side * hair}));
    EXPECT_FALSE(test.accepts({ratio(3, 10), tie - side * hair}));
  }
}

TEST(CandidateTest, has_nothing_to_test_before_two_points_are_placed) {
  auto scene = any_scene<2>(hexagonal_torus(), random_points<2>(20, 9, 20), ratio(1, 9), ratio(1, 32), 9);
  scene.placed.assign(20, false);
  const auto atlas = scene.atlas();
  const PointSet<2> points(scene.points);
  CandidateTest<2> test(atlas, points, scene.placed, scene.parameters);
  const FilterGuard guard;
  test.prepare(Label(4));
  EXPECT_EQ(test.candidate_count(), 0U);
  EXPECT_TRUE(test.accepts(scene.net[4]));
}

// --- whole and pruned (docs/claims/pruned-candidates.md)

/// Every x that `whole` accepts, `pruned` accepts; and `printed` accepts it too.
template <int m>
Tally check_whole_and_pruned(Scene<m> scene, std::uint32_t step, std::size_t count) {
  Tally tally;
  const auto atlas = scene.atlas();
  const PointSet<m> points(scene.points);
  const auto test_by = [&](CandidateRule rule) {
    auto parameters = scene.parameters;
    parameters.candidates = rule;
    return CandidateTest<m>(atlas, points, scene.placed, parameters);
  };
  auto pruned = test_by(CandidateRule::pruned);
  auto whole = test_by(CandidateRule::whole);
  auto printed = test_by(CandidateRule::printed);
  for (std::uint32_t i = 0; i < scene.net.size(); i += step) {
    {
      const FilterGuard guard;
      pruned.prepare(Label(i));
      whole.prepare(Label(i));
      printed.prepare(Label(i));
    }
    EXPECT_LE(pruned.candidate_count(), whole.candidate_count());
    EXPECT_LE(printed.candidate_count(), whole.candidate_count());
    for (const auto& x : positions<m>(scene, i, collected<m>(pruned), count, i + 1)) {
      const FilterGuard guard;
      const bool by_whole = whole.accepts(x);
      EXPECT_TRUE(!by_whole || pruned.accepts(x));
      EXPECT_TRUE(!by_whole || printed.accepts(x));
      ++(by_whole ? tally.accepted : tally.refused);
    }
  }
  return tally;
}

TEST(CandidateTest, pruned_accepts_whatever_whole_accepts) {
  Tally all;
  const auto add = [&all](const Tally& tally) {
    all.accepted += tally.accepted;
    all.refused += tally.refused;
  };
  const auto surface = [](const Rational& radius, std::uint64_t seed) {
    return poisson_disk_net<2>(cubic_torus<2>(), radius, seed, no_progress());
  };
  add(check_whole_and_pruned<1>(
      any_scene<1>(cubic_torus<1>(), random_points<1>(60, 1, 20), ratio(1, 60), ratio(1, 64), 1), 1, 60));
  for (const auto& tolerance : {ratio(1, 64), ratio(1, 1000), ratio(1, 100000)}) {
    add(check_whole_and_pruned<2>(any_scene<2>(cubic_torus<2>(), surface(ratio(1, 14), 2), ratio(1, 14), tolerance, 2),
                                  29, 40));
  }
  add(check_whole_and_pruned<3>(
      any_scene<3>(ball_of<3>(Rational(1)), random_points<3>(30, 3, 20), ratio(1, 6), ratio(1, 1000), 3), 7, 60));
  EXPECT_GT(all.accepted, 100);
  EXPECT_GT(all.refused, 100);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
