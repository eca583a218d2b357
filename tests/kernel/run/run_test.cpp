#include "kernel/run/run.hpp"

#include "kernel/sample/lattice_net.hpp"
#include "kernel/sample/net_measure.hpp"
#include "kernel/sample/poisson_disk.hpp"
#include "support/error.hpp"
#include "tests/kernel/stars/witness.hpp"

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
FlatAtlas<m> poisson_atlas(const FlatSpace<m>& space, const Rational& radius) {
  return FlatAtlas<m>(space, PointSet<m>(poisson_disk_net<m>(space, radius, 1, no_progress())), radius);
}

FlatAtlas<2> square_lattice(std::uint32_t divisions) {
  LatticeNet lattice;
  lattice.divisions = divisions;
  return FlatAtlas<2>(cubic_torus<2>(), PointSet<2>(lattice_net<2>(cubic_torus<2>(), lattice)),
                      ratio(3, 4) / Rational(divisions));
}

template <int m>
ExactPoints<m> exact_points(const PointSet<m>& set) {
  ExactPoints<m> result;
  for (std::uint32_t index = 0; index < set.size(); ++index) result.push_back(set.exact(Label(index)));
  return result;
}

/// The stars are those of the Delaunay complex: empty balls that fill the torus.
template <int m>
void check_complex(const FlatSpace<m>& space, const RunResult<m>& run) {
  const auto points = exact_points<m>(run.points);
  Rational total(0);
  for (const auto& simplex : run.complex.simplices()) {
    const auto vertices = all_at<m>(points, std::span<const Lift<m>>(simplex));
    EXPECT_TRUE(is_empty<m>(space, points, *ball_of_simplex<m>(space, vertices)));
    total += absolute(edge_determinant<m>(vertices));
  }
  EXPECT_EQ(total, Rational(factorial(m)));
}

TEST(RunAlgorithm, certifies_a_perturbed_net_of_a_torus) {
  const auto atlas = poisson_atlas<2>(hexagonal_torus(), ratio(1, 12));
  const auto run = run_algorithm<2>(atlas, measured(ratio(1, 64)), {}, no_progress());
  ASSERT_TRUE(run.is_certified());
  EXPECT_TRUE(run.protection.failures.empty());
  EXPECT_EQ(run.repair_rounds, 0);
  EXPECT_EQ(run.repaired_points, 0U);
  EXPECT_EQ(run.complex.simplices().size(), 2 * atlas.size());
  EXPECT_EQ(run.complex.euler_characteristic(), 0);
  EXPECT_GT(run.protection.margins->protection, Rational(0));
  EXPECT_EQ(run.statistics.placements, atlas.size());
  check_complex<2>(atlas.space(), run);
}

TEST(RunAlgorithm, certifies_a_square_lattice_once_it_is_perturbed) {
  const auto atlas = square_lattice(12);
  const auto run = run_algorithm<2>(atlas, measured(ratio(1, 64)), {}, no_progress());
  ASSERT_TRUE(run.is_certified());
  check_complex<2>(atlas.space(), run);
}

TEST(RunAlgorithm, without_perturbation_certifies_nothing_of_a_square_lattice_and_names_every_star) {
  const auto atlas = square_lattice(12);
  RunRequest request;
  request.perturb = false;
  const auto run = run_algorithm<2>(atlas, measured(ratio(1, 64)), request, no_progress());
  EXPECT_FALSE(run.is_certified());
  EXPECT_FALSE(run.protection.margins.has_value());
  EXPECT_EQ(run.repair_rounds, 0);
  EXPECT_EQ(exact_points<2>(run.points), exact_points<2>(atlas.net()));
  EXPECT_EQ(run.statistics.placements, 0U);
  std::vector<bool> concerned(atlas.size(), false);
  for (const auto& failure : run.protection.failures) {
    for (const Label label : failure.concerned) concerned[label.value] = true;
  }
  EXPECT_EQ(std::count(concerned.begin(), concerned.end(), true), 144);
}

TEST(RunAlgorithm, without_perturbation_certifies_a_net_in_general_position) {
  const auto atlas = poisson_atlas<2>(hexagonal_torus(), ratio(1, 12));
  RunRequest request;
  request.perturb = false;
  const auto run = run_algorithm<2>(atlas, measured(ratio(1, 64)), request, no_progress());
  EXPECT_TRUE(run.is_certified());
  EXPECT_EQ(exact_points<2>(run.points), exact_points<2>(atlas.net()));
  check_complex<2>(atlas.space(), run);
}

TEST(RunAlgorithm, repairs_until_the_required_protection_is_reached) {
  const auto atlas = poisson_atlas<2>(cubic_torus<2>(), ratio(1, 16));
  const auto parameters = measured(ratio(1, 128));
  const auto unrepaired = run_algorithm<2>(atlas, parameters, {}, no_progress());
  ASSERT_TRUE(unrepaired.is_certified());
  RunRequest request;
  request.required_protection = ratio(1, 50) * atlas.sampling_radius();
  ASSERT_LT(unrepaired.protection.margins->protection, *request.required_protection);
  std::vector<std::string> stages;
  const auto run = run_algorithm<2>(atlas, parameters, request, [&](std::string_view stage, std::size_t, std::size_t) {
    if (stages.empty() || stages.back() != stage) stages.emplace_back(stage);
  });
  ASSERT_TRUE(run.is_certified());
  EXPECT_GE(run.protection.margins->protection, *request.required_protection * ratio(2047, 2048));
  EXPECT_GT(run.repair_rounds, 0);
  EXPECT_GE(run.repaired_points, 4U);
  EXPECT_EQ(run.statistics.placements, atlas.size() + run.repaired_points);
  EXPECT_GE(std::count(stages.begin(), stages.end(), "repair"), 1);
  check_complex<2>(atlas.space(), run);
  // Points that no failure concerned stay where they were.
  std::size_t moved_points = 0;
  for (std::uint32_t index = 0; index < atlas.size(); ++index) {
    const Label i(index);
    moved_points += run.points.exact(i) == unrepaired.points.exact(i) ? 0U : 1U;
    EXPECT_LE(squared_distance<2>(atlas.space(), run.points.exact(i), atlas.net().exact(i)),
              square(ratio(1, 4) * atlas.sampling_radius()));
  }
  EXPECT_GT(moved_points, 0U);
  EXPECT_LE(moved_points, run.repaired_points);
}

TEST(RunAlgorithm, gives_up_after_the_rounds_it_is_allowed) {
  const auto atlas = poisson_atlas<2>(cubic_torus<2>(), ratio(1, 12));
  RunRequest request;
  request.required_protection = ratio(2, 5) * atlas.sampling_radius();
  request.most_repair_rounds = 2;
  const auto run = run_algorithm<2>(atlas, measured(ratio(1, 128)), request, no_progress());
  EXPECT_FALSE(run.is_certified());
  EXPECT_EQ(run.repair_rounds, 2);
  EXPECT_FALSE(run.protection.failures.empty());
  EXPECT_GT(run.repaired_points, 0U);
  request.most_repair_rounds = 0;
  const auto first = run_algorithm<2>(atlas, measured(ratio(1, 128)), request, no_progress());
  EXPECT_FALSE(first.is_certified());
  EXPECT_EQ(first.repair_rounds, 0);
  EXPECT_EQ(first.repaired_points, 0U);
}

TEST(RunAlgorithm, is_the_same_every_time) {
  const auto atlas = poisson_atlas<2>(cubic_torus<2>(), ratio(1, 12));
  RunRequest request;
  request.required_protection = ratio(1, 60) * atlas.sampling_radius();
  const auto first = run_algorithm<2>(atlas, measured(ratio(1, 128)), request, no_progress());
  const auto second = run_algorithm<2>(atlas, measured(ratio(1, 128)), request, no_progress());
  EXPECT_EQ(exact_points<2>(first.points), exact_points<2>(second.points));
  EXPECT_EQ(first.complex.simplices(), second.complex.simplices());
  EXPECT_EQ(first.protection.margins->protection, second.protection.margins->protection);
  EXPECT_NE(exact_points<2>(run_algorithm<2>(atlas, measured(ratio(1, 128), 2), request, no_progress()).points),
            exact_points<2>(first.points));
}

TEST(RunAlgorithm, certifies_the_interior_of_a_ball) {
  const auto atlas = poisson_atlas<2>(ball_of<2>(Rational(1)), ratio(1, 12));
  const auto run = run_algorithm<2>(atlas, measured(ratio(1, 64)), {}, no_progress());
  ASSERT_TRUE(run.is_certified());
  std::size_t interior = 0;
  for (std::uint32_t index = 0; index < atlas.size(); ++index) {
    const Label i(index);
    EXPECT_EQ(run.complex.star(i).empty(), !atlas.is_interior(i));
    interior += atlas.is_interior(i) ? 1U : 0U;
  }
  EXPECT_GT(interior, 5U);
}

TEST(RunAlgorithm, certifies_the_circle) {
  const auto atlas = poisson_atlas<1>(cubic_torus<1>(), ratio(1, 40));
  const auto run = run_algorithm<1>(atlas, measured(ratio(1, 64)), {}, no_progress());
  ASSERT_TRUE(run.is_certified());
  EXPECT_EQ(run.complex.simplices().size(), atlas.size());
  EXPECT_GE(run.protection.margins->thickness, ratio(4095, 4096));
}

TEST(RunAlgorithm, certifies_a_torus_of_dimension_3) {
  const auto atlas = poisson_atlas<3>(cubic_torus<3>(), ratio(1, 10));
  const auto run = run_algorithm<3>(atlas, measured(Rational::power_of_two(-12)), {}, no_progress());
  ASSERT_TRUE(run.is_certified());
  EXPECT_EQ(run.complex.euler_characteristic(), 0);
  EXPECT_GT(run.complex.simplices().size(), 6 * atlas.size());
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
