#include "kernel/perturb/perturbation.hpp"

#include <numeric>

#include "kernel/parallel/threads.hpp"
#include "kernel/perturb/colouring.hpp"
#include "kernel/sample/poisson_disk.hpp"
#include "support/error.hpp"
#include "tests/kernel/perturb/scene.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

PerturbationParameters measured(const Rational& tolerance, std::uint64_t seed = 1) {
  PerturbationParameters parameters;
  parameters.separation = Rational(1);
  parameters.perturbation = ratio(1, 4);
  parameters.tolerance = tolerance;
  parameters.edge_bound = ratio(5, 2);
  parameters.circumradius_bound = Rational(2);
  parameters.seed = seed;
  return parameters;
}

template <int m>
FlatAtlas<m> poisson_atlas(const FlatSpace<m>& space, const Rational& radius, std::uint64_t seed = 1) {
  return FlatAtlas<m>(space, PointSet<m>(poisson_disk_net<m>(space, radius, seed, no_progress())), radius);
}

template <int m>
ExactPoints<m> exact_points(const PointSet<m>& set) {
  ExactPoints<m> result;
  for (std::uint32_t index = 0; index < set.size(); ++index) result.push_back(set.exact(Label(index)));
  return result;
}

template <int m>
void check_positions(const FlatAtlas<m>& atlas, const Perturbation<m>& perturbation, const Rational& reach) {
  const Rational step = Rational::power_of_two(perturbation.grid_exponent());
  for (std::uint32_t index = 0; index < atlas.size(); ++index) {
    const auto& moved_to = perturbation.points().exact(Label(index));
    EXPECT_LE(squared_distance<m>(atlas.space(), moved_to, atlas.net().exact(Label(index))), square(reach));
    for (const Rational& coordinate : moved_to) EXPECT_EQ((coordinate / step).denominator(), 1);
  }
}

TEST(Perturbation, moves_every_point_by_at_most_its_bound_on_the_grid) {
  const auto check = []<int m>(const FlatSpace<m>& space, const Rational& radius) {
    const auto atlas = poisson_atlas<m>(space, radius);
    Perturbation<m> perturbation(atlas, measured(Rational::power_of_two(-12)));
    perturbation.place_all(no_progress());
    check_positions<m>(atlas, perturbation, ratio(1, 4) * radius);
    EXPECT_EQ(perturbation.statistics().placements, atlas.size());
    EXPECT_GE(perturbation.statistics().tries, atlas.size());
    EXPECT_LT(perturbation.statistics().tries, 10 * atlas.size());
  };
  check.operator()<1>(cubic_torus<1>(), ratio(1, 30));
  check.operator()<2>(hexagonal_torus(), ratio(1, 10));
  check.operator()<2>(square_torus_in_a_long_basis(), ratio(1, 10));
  check.operator()<3>(skewed_torus(), ratio(1, 4));
  check.operator()<2>(ball_of<2>(Rational(1)), ratio(1, 8));
}

TEST(Perturbation, has_a_grid_far_below_the_tolerance) {
  const auto atlas = poisson_atlas<2>(cubic_torus<2>(), ratio(1, 10));
  const Rational tolerance = Rational::power_of_two(-57);
  const Perturbation<2> perturbation(atlas, measured(tolerance));
  const Rational step = Rational::power_of_two(perturbation.grid_exponent());
  EXPECT_LE(step, tolerance * ratio(1, 10) * Rational::power_of_two(-31));
  EXPECT_GE(step, tolerance * ratio(1, 10) * Rational::power_of_two(-36));
  // Frames with long vectors have finer steps.
  const auto stretched = torus_of<2>({{{Rational(10000), Rational(0)}, {Rational(0), Rational(10000)}}});
  const FlatAtlas<2> large(stretched, PointSet<2>(random_points<2>(5, 1)), Rational(10));
  const Rational coarse = Rational::power_of_two(Perturbation<2>(large, measured(tolerance)).grid_exponent());
  EXPECT_LE(coarse * Rational(100), tolerance * Rational(10) * Rational::power_of_two(-30));
}

/// The moves of points of a net where nothing is refused, in units of the bound.
std::vector<Vector<double, 2>> moves(const FlatAtlas<2>& atlas, const Perturbation<2>& perturbation, double reach) {
  std::vector<Vector<double, 2>> result;
  for (std::uint32_t index = 0; index < atlas.size(); ++index) {
    const auto move = difference(perturbation.points().exact(Label(index)), atlas.net().exact(Label(index)));
    auto cartesian = atlas.metric().approximate_cartesian(approximate<2>(move));
    for (double& coordinate : cartesian) coordinate /= reach;
    result.push_back(cartesian);
  }
  return result;
}

TEST(Perturbation, is_spread_evenly_over_its_ball) {
  // In quarters, and inside and outside of half the area; also in a frame whose box is far from the ball.
  for (const auto& space : {cubic_torus<2>(), square_torus_in_a_long_basis()}) {
    const auto atlas = poisson_atlas<2>(space, ratio(1, 30));
    Perturbation<2> perturbation(atlas, measured(Rational::power_of_two(-40)));
    perturbation.place_all(no_progress());
    std::array<double, 8> counts{};
    for (const auto& move : moves(atlas, perturbation, 0.25 / 30)) {
      const double squared = pairing(move, move);
      EXPECT_LE(squared, 1 + 1e-9);
      ++counts[(move[0] > 0 ? 1U : 0U) + (move[1] > 0 ? 2U : 0U) + (squared > 0.5 ? 4U : 0U)];
    }
    const double expected = static_cast<double>(atlas.size()) / 8;
    for (const double count : counts) EXPECT_NEAR(count, expected, 5 * std::sqrt(expected));
  }
}

TEST(Perturbation, depends_on_net_parameters_and_seed_only) {
  const auto atlas = poisson_atlas<2>(hexagonal_torus(), ratio(1, 10));
  const auto run = [&](const PerturbationParameters& parameters) {
    Perturbation<2> perturbation(atlas, parameters);
    perturbation.place_all(no_progress());
    perturbation.place_anew({Label(7), Label(3), Label(7)}, no_progress());
    return exact_points<2>(perturbation.points());
  };
  const auto first = run(measured(ratio(1, 64)));
  EXPECT_EQ(run(measured(ratio(1, 64))), first);
  EXPECT_NE(run(measured(ratio(1, 64), 2)), first);
  EXPECT_NE(run(measured(ratio(1, 64), 1 + (std::uint64_t{1} << 32U))), first);
}

TEST(Perturbation, places_anew_the_labels_asked_for_and_no_others) {
  const auto atlas = poisson_atlas<2>(hexagonal_torus(), ratio(1, 10));
  Perturbation<2> perturbation(atlas, measured(ratio(1, 64)));
  perturbation.place_all(no_progress());
  const auto before = exact_points<2>(perturbation.points());
  std::vector<std::string> stages;
  perturbation.place_anew({Label(9), Label(2), Label(9)},
                          [&](std::string_view stage, std::size_t, std::size_t) { stages.emplace_back(stage); });
  EXPECT_EQ(stages.front(), "repair");
  const auto after = exact_points<2>(perturbation.points());
  for (std::size_t index = 0; index < before.size(); ++index) {
    EXPECT_EQ(before[index] != after[index], index == 2 || index == 9) << index;
  }
  EXPECT_EQ(perturbation.statistics().placements, atlas.size() + 2);
  check_positions<2>(atlas, perturbation, ratio(1, 40));
}

/// Whether every clique of points, of 3 to m + 2 of them with edges below 5ε/2, has its last placed vertex farther than
/// t from the diametric sphere of the others, unless their circumradius is 2ε or more or they are degenerate: by
/// looking at all of them. `order[i]` says when i was placed.
template <int m>
std::size_t count_violations(const FlatAtlas<m>& atlas, const PointSet<m>& set, const std::vector<std::size_t>& order,
                             const Rational& tolerance, std::size_t& looked_at) {
  Scene<m> scene;
  scene.space = atlas.space();
  scene.points = exact_points<m>(set);
  scene.net = scene.points;
  scene.sampling_radius = atlas.sampling_radius();
  scene.parameters = measured(tolerance);
  scene.parameters.perturbation = Rational(0);
  std::size_t violations = 0;
  for (std::uint32_t last = 0; last < set.size(); ++last) {
    scene.placed.assign(set.size(), false);
    for (std::uint32_t other = 0; other < set.size(); ++other) scene.placed[other] = order[other] < order[last];
    // With nothing to move by, the candidates are the spheres within the tolerance of the point itself.
    violations += scene.candidates(last).size();
    looked_at += scene.available(last).size();
  }
  return violations;
}

/// The time at which each label is placed: colour by colour.
template <int m>
std::vector<std::size_t> times_of(const FlatAtlas<m>& atlas, const PerturbationParameters& parameters) {
  std::vector<std::size_t> result;
  for (const std::uint32_t colour : colours_of<m>(atlas, Placement<m>::reach(parameters), no_progress()))
    result.push_back(colour * atlas.size() + result.size());
  return result;
}

TEST(Perturbation, leaves_no_last_placed_vertex_within_the_tolerance_of_a_sphere) {
  const auto atlas = poisson_atlas<2>(cubic_torus<2>(), ratio(1, 16));
  Perturbation<2> perturbation(atlas, measured(ratio(1, 64)));
  const std::vector<std::size_t> times = times_of<2>(atlas, measured(ratio(1, 64)));
  const std::size_t later = 1 + *std::max_element(times.begin(), times.end());
  std::vector<std::size_t> order = times;
  std::size_t looked_at = 0;
  EXPECT_GT(count_violations<2>(atlas, atlas.net(), order, ratio(1, 64), looked_at), 20U) << "before";
  perturbation.place_all(no_progress());
  EXPECT_EQ(count_violations<2>(atlas, perturbation.points(), order, ratio(1, 64), looked_at), 0U);
  EXPECT_GT(looked_at, 5 * atlas.size());

  // Placing some anew keeps it, with the order in which points are placed now; a second time too.
  for (std::uint32_t round = 0; round < 2; ++round) {
    std::vector<Label> labels;
    for (std::uint32_t index = round; index < atlas.size(); index += 3) labels.emplace_back(index);
    perturbation.place_anew(labels, no_progress());
    for (const Label label : labels) order[label.value] = later * (round + 1) + times[label.value];
    EXPECT_EQ(count_violations<2>(atlas, perturbation.points(), order, ratio(1, 64), looked_at), 0U);
  }
}

TEST(Perturbation, of_other_dimensions_keeps_the_tolerance_too) {
  std::size_t looked_at = 0;
  const auto circle = poisson_atlas<1>(cubic_torus<1>(), ratio(1, 40));
  Perturbation<1> on_circle(circle, measured(ratio(1, 64)));
  on_circle.place_all(no_progress());
  const auto on_circle_at = times_of<1>(circle, measured(ratio(1, 64)));
  EXPECT_EQ(count_violations<1>(circle, on_circle.points(), on_circle_at, ratio(1, 64), looked_at), 0U);

  const FlatAtlas<3> solid(ball_of<3>(Rational(1)), PointSet<3>(random_points<3>(45, 1, 20)), ratio(1, 5));
  Perturbation<3> in_solid(solid, measured(ratio(1, 1024)));
  in_solid.place_all(no_progress());
  const auto in_solid_at = times_of<3>(solid, measured(ratio(1, 1024)));
  EXPECT_EQ(count_violations<3>(solid, in_solid.points(), in_solid_at, ratio(1, 1024), looked_at), 0U);
}

/// With the second tolerance.
PerturbationParameters choosing(std::uint64_t seed) {
  auto parameters = measured(ratio(1, 50), seed);
  parameters.clearance = ratio(1, 20);
  parameters.choices = 8;
  return parameters;
}

TEST(Perturbation, by_colour_is_what_one_thread_does_colour_by_colour) {
  const auto atlas = poisson_atlas<2>(hexagonal_torus(), ratio(1, 24));
  for (const auto& parameters : {measured(ratio(1, 50)), choosing(1)}) {
    auto colours = colours_of<2>(atlas, Placement<2>::reach(parameters), no_progress());
    std::vector<std::uint32_t> order(atlas.size());
    std::iota(order.begin(), order.end(), 0U);
    std::stable_sort(order.begin(), order.end(), [&](auto a, auto b) { return colours[a] < colours[b]; });
    PlacedPoints<2> state(atlas, parameters);
    Placement<2> placement(atlas, parameters, state);
    for (const std::uint32_t index : order) placement.place(Label(index));
    // Then every fifth label again, in the same order.
    const auto expected_first = exact_points<2>(state.points);
    std::vector<Label> again;
    for (const std::uint32_t index : order) {
      if (index % 5 != 0) continue;
      state.placed[index] = 0;
      again.emplace_back(index);
    }
    for (const Label label : again) placement.place(label);
    for (const unsigned limit : {1U, 2U, 4U}) {
      const ThreadLimit threads(limit);
      Perturbation<2> perturbation(atlas, parameters);
      perturbation.place_all(no_progress());
      EXPECT_EQ(exact_points<2>(perturbation.points()), expected_first) << limit;
      perturbation.place_anew(again, no_progress());
      EXPECT_EQ(exact_points<2>(perturbation.points()), exact_points<2>(state.points)) << limit;
      EXPECT_EQ(perturbation.statistics().tries, placement.statistics().tries);
      EXPECT_EQ(perturbation.statistics().most_tries, placement.statistics().most_tries);
      EXPECT_EQ(perturbation.statistics().candidates, placement.statistics().candidates);
      EXPECT_EQ(perturbation.statistics().placements, placement.statistics().placements);
    }
    // It is another order than that of labels.
    PlacedPoints<2> by_label(atlas, parameters);
    Placement<2> in_order(atlas, parameters, by_label);
    for (std::uint32_t index = 0; index < atlas.size(); ++index) in_order.place(Label(index));
    EXPECT_NE(exact_points<2>(by_label.points), expected_first);
  }
}

TEST(Perturbation, by_colour_gives_up_at_the_same_label_whatever_the_number_of_threads) {
  const auto atlas = poisson_atlas<2>(cubic_torus<2>(), ratio(1, 20));
  auto parameters = measured(ratio(1, 4));
  parameters.most_tries = 3;
  std::vector<std::string> messages;
  for (const unsigned limit : {1U, 2U, 4U}) {
    const ThreadLimit threads(limit);
    Perturbation<2> perturbation(atlas, parameters);
    messages.push_back(message_of<Rejection>([&] { perturbation.place_all(no_progress()); }));
    EXPECT_EQ(messages.back(), messages.front());
  }
  EXPECT_TRUE(mentions(messages.front(), " in 3 tries")) << messages.front();
}

TEST(Perturbation, gives_up_on_a_tolerance_that_nothing_satisfies_and_names_the_label) {
  const auto atlas = poisson_atlas<2>(cubic_torus<2>(), ratio(1, 10));
  auto parameters = measured(ratio(1, 2));
  parameters.most_tries = 30;
  Perturbation<2> perturbation(atlas, parameters);
  const std::string message = message_of<Rejection>([&] { perturbation.place_all(no_progress()); });
  EXPECT_TRUE(mentions(message, "no good perturbation of label ")) << message;
  EXPECT_TRUE(mentions(message, " in 30 tries, with tolerance 1/2 and ")) << message;
  EXPECT_FALSE(mentions(message, " 0 candidates")) << message;
}

TEST(Perturbation, tells_its_progress) {
  const auto atlas = poisson_atlas<1>(cubic_torus<1>(), ratio(1, 30));
  Perturbation<1> perturbation(atlas, measured(ratio(1, 64)));
  std::size_t last = 0;
  bool is_placing = false;
  perturbation.place_all([&](std::string_view stage, std::size_t done, std::size_t total) {
    is_placing = is_placing || stage == "perturb";
    EXPECT_EQ(stage, is_placing ? "perturb" : "colour");
    EXPECT_EQ(total, atlas.size());
    last = done;
  });
  EXPECT_TRUE(is_placing);
  EXPECT_EQ(last, atlas.size());
}

// The same points with every compiler and on every machine: what they are is written down here.
TEST(Perturbation, is_the_same_everywhere) {
  const FlatAtlas<2> atlas(hexagonal_torus(), PointSet<2>(random_points<2>(30, 1, 12)), ratio(1, 10));
  Perturbation<2> perturbation(atlas, measured(ratio(1, 64)));
  perturbation.place_all(no_progress());
  Rational total(0);
  for (const auto& point : exact_points<2>(perturbation.points())) total += point[0] + Rational(3) * point[1];
  EXPECT_EQ(perturbation.grid_exponent(), -45);
  EXPECT_EQ(total * Rational::power_of_two(45), Rational(1739681675837237));
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
