#include "kernel/sample/net_measure.hpp"

#include "kernel/number/exact_text.hpp"
#include "kernel/sample/lattice_net.hpp"
#include "kernel/sample/poisson_disk.hpp"
#include "support/error.hpp"
#include "tests/kernel/stars/witness.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

template <int m>
ExactPoints<m> lattice(const FlatSpace<m>& space, std::uint32_t divisions, bool centred = false) {
  LatticeNet net;
  net.divisions = divisions;
  net.centred = centred;
  return lattice_net<m>(space, net);
}

template <int m>
NetDensity<m> density_of(const FlatSpace<m>& space, const ExactPoints<m>& points,
                         const std::optional<Rational>& nominal = {}) {
  return measure_density<m>(space, PointSet<m>(points), nominal, no_progress());
}

/// lower ≤ covering radius < ε ≤ 1.001·lower, where the square of the covering radius is known; and the witness.
template <int m>
void check_density(const FlatSpace<m>& space, const ExactPoints<m>& points, const Rational& squared_covering_radius) {
  const auto density = density_of<m>(space, points);
  EXPECT_LE(square(density.covering_radius_lower), squared_covering_radius);
  EXPECT_LT(squared_covering_radius, square(density.sampling_radius));
  EXPECT_LE(density.sampling_radius * Rational(1000), density.covering_radius_lower * Rational(1001));
  EXPECT_EQ(complaint_of_torus_witness<m>(space, points, density.simplices, density.sampling_radius), "");
  EXPECT_NE(complaint_of_torus_witness<m>(space, points, density.simplices, density.covering_radius_lower), "");
}

// A triangulation that is known is not believed: where it does not cover, one of a displaced copy is made.
TEST(MeasureDensity, of_a_known_triangulation_is_that_of_a_displaced_copy) {
  const auto check = []<int m>(const FlatSpace<m>& space, const Rational& radius) {
    const auto net = triangulated_poisson_disk_net<m>(space, radius, 2, no_progress());
    const PointSet<m> points(net.points);
    const auto expected = measure_density<m>(space, points, radius, no_progress());
    auto holed = net.simplices;
    holed.pop_back();
    for (const auto& known : {net.simplices, holed}) {
      const auto density = measure_density<m>(space, points, radius, no_progress(), known);
      EXPECT_EQ(density.simplices, expected.simplices);
      EXPECT_EQ(density.sampling_radius, expected.sampling_radius);
      EXPECT_EQ(density.covering_radius_lower, expected.covering_radius_lower);
    }
  };
  check.template operator()<2>(hexagonal_torus(), ratio(1, 16));
  check.template operator()<3>(skewed_torus(), ratio(1, 5));
}

TEST(MeasureDensity, of_a_known_triangulation_that_covers_by_a_large_simplex_is_refused) {
  auto net = triangulated_poisson_disk_net<3>(skewed_torus(), ratio(1, 5), 2, no_progress());
  net.simplices.back()[3].shift[0] += 1;
  EXPECT_THROW(
      (void)measure_density<3>(skewed_torus(), PointSet<3>(net.points), ratio(1, 5), no_progress(), net.simplices),
      Rejection);
}

TEST(MeasureDensity, knows_the_covering_radii_of_lattices) {
  check_density<1>(cubic_torus<1>(), lattice<1>(cubic_torus<1>(), 48), ratio(1, 96 * 96));
  check_density<2>(cubic_torus<2>(), lattice<2>(cubic_torus<2>(), 20), ratio(1, 2 * 20 * 20));
  check_density<2>(square_torus_in_a_long_basis(), lattice<2>(square_torus_in_a_long_basis(), 20),
                   ratio(1, 2 * 20 * 20));
  check_density<2>(hexagonal_torus(), lattice<2>(hexagonal_torus(), 17), ratio(1, 3 * 17 * 17));
  check_density<3>(cubic_torus<3>(), lattice<3>(cubic_torus<3>(), 6), ratio(3, 4 * 6 * 6));
  check_density<3>(cubic_torus<3>(), lattice<3>(cubic_torus<3>(), 5, true), ratio(5, 16 * 5 * 5));
  // The frame of the bcc lattice scaled to a shortest vector of length 1: √5/4 of the side 2/√3 of its cubes.
  check_density<3>(bcc_torus(), lattice<3>(bcc_torus(), 6), ratio(5 * 4, 16 * 3 * 6 * 6));
}

// Defect: displaced coordinates were not exact after translations, so that copies of a cube were triangulated
// differently, on all cubic lattices but those of a power of two.
TEST(MeasureDensity, triangulates_cubes_the_same_way_in_all_copies) {
  for (const std::uint32_t divisions : {5U, 7U, 9U, 10U}) {
    const auto space = cubic_torus<3>();
    const long n = divisions;
    check_density<3>(space, lattice<3>(space, divisions), ratio(3, 4 * n * n));
  }
}

TEST(MeasureDensity, knows_the_covering_radius_of_a_lattice_in_dimension_4) {
  // Coarse but enough to be triangulated: the centred hypercubic lattice D₄*, with covering radius √2/2 of a step.
  const auto space = cubic_torus<4>();
  check_density<4>(space, lattice<4>(space, 2, true), ratio(1, 8));
}

TEST(MeasureDensity, takes_the_nominal_radius_where_it_is_one_and_tight) {
  const auto space = cubic_torus<2>();
  const auto points = lattice<2>(space, 20);
  const Rational covering = square_root_upper(ratio(1, 800), 60);
  const Rational tight = covering * ratio(10005, 10000);
  EXPECT_EQ(density_of<2>(space, points, tight).sampling_radius, tight);
  for (const Rational& nominal : {covering * ratio(9999, 10000), covering * ratio(102, 100), Rational(1)}) {
    const Rational measured = density_of<2>(space, points, nominal).sampling_radius;
    EXPECT_NE(measured, nominal);
    EXPECT_LT(ratio(1, 800), square(measured));
    EXPECT_LE(measured, covering * ratio(1001, 1000));
  }
}

TEST(MeasureDensity, notices_a_missing_point) {
  const auto space = cubic_torus<2>();
  auto points = lattice<2>(space, 20);
  points.erase(points.begin() + 137);
  // The place of the missing point is at distance 1/20 from its neighbours, and nothing is farther.
  check_density<2>(space, points, ratio(1, 400));
}

TEST(MeasureDensity, notices_a_hole_punched_in_a_net) {
  const auto space = hexagonal_torus();
  auto points = poisson_disk_net<2>(space, ratio(1, 20), 1, no_progress());
  const Rational before = density_of<2>(space, points, ratio(1, 20)).sampling_radius;
  EXPECT_LE(before, ratio(1, 20) * ratio(1001, 1000));
  const Vector<Rational, 2> centre{ratio(1, 2), ratio(1, 2)};
  std::erase_if(points, [&](const auto& point) { return squared_distance<2>(space, point, centre) < ratio(1, 64); });
  const auto after = density_of<2>(space, points, ratio(1, 20));
  EXPECT_GE(after.sampling_radius, ratio(1, 8));
  EXPECT_GE(after.covering_radius_lower * Rational(1001), after.sampling_radius * Rational(1000));
  EXPECT_EQ(complaint_of_torus_witness<2>(space, points, after.simplices, after.sampling_radius), "");
}

TEST(MeasureDensity, has_a_true_lower_bound) {
  // For random points: no place of the torus may be farther than ε, some place is at least the lower bound away.
  const auto space = skewed_torus();
  const auto points = random_points<3>(60, 3);
  const auto density = density_of<3>(space, points);
  EXPECT_EQ(complaint_of_torus_witness<3>(space, points, density.simplices, density.sampling_radius), "");
  Rational farthest(0);
  for (const auto& place : random_points<3>(500, 4)) {
    Rational nearest(100);
    for (const auto& lift : lifts_within<3>(space, points, place, density.sampling_radius)) {
      nearest = minimum(nearest, squared_distance<3>(space, at<3>(points, lift), place));
    }
    EXPECT_LT(nearest, square(density.sampling_radius));
    farthest = maximum(farthest, nearest);
  }
  EXPECT_GT(farthest, square(density.sampling_radius) / Rational(4));
}

TEST(MeasureDensity, refuses_too_few_points) {
  const auto space = cubic_torus<2>();
  EXPECT_TRUE(mentions(message_of<Rejection>([&] { (void)density_of<2>(space, random_points<2>(2, 1)); }),
                       "more than 2 points"));
}

// Defect: a nominal radius of 0 for a given net never came to an end.
TEST(MeasureDensity, refuses_a_nominal_radius_that_is_not_above_0) {
  const auto space = cubic_torus<2>();
  for (const Rational& nominal : {Rational(0), ratio(-1, 2)}) {
    const auto refusal = message_of<InputError>([&] { (void)density_of<2>(space, lattice<2>(space, 5), nominal); });
    EXPECT_TRUE(mentions(refusal, exact_text(nominal) + " is not above 0"));
  }
}

TEST(MeasureDensity, of_a_ball_looks_at_the_ball_only) {
  const auto space = ball_of<2>(Rational(1));
  const auto points = lattice<2>(space, 10);
  const auto density = density_of<2>(space, points);
  EXPECT_LT(ratio(1, 200), square(density.sampling_radius));
  EXPECT_LE(square(density.covering_radius_lower), ratio(1, 200));
  EXPECT_LE(density.sampling_radius * Rational(1000), density.covering_radius_lower * Rational(1001));
  // A hole beyond the ball changes nothing, one inside does.
  auto outer = points;
  std::erase(outer, Vector<Rational, 2>{ratio(13, 10), ratio(13, 10)});
  EXPECT_EQ(outer.size(), points.size() - 1);
  EXPECT_LT(density_of<2>(space, outer).sampling_radius, ratio(1, 14));
  auto inner = points;
  std::erase(inner, Vector<Rational, 2>{Rational(0), ratio(1, 5)});
  EXPECT_EQ(inner.size(), points.size() - 1);
  const auto sparser = density_of<2>(space, inner);
  EXPECT_GT(sparser.sampling_radius, ratio(1, 10));
  EXPECT_LT(sparser.sampling_radius, ratio(1, 10) * ratio(1001, 1000));
}

// Defect: simplices with a large circumball about a centre beyond the ball were left out though they reached into it.
TEST(MeasureDensity, of_a_ball_keeps_simplices_whose_centres_lie_beyond_it) {
  const auto space = ball_of<2>(Rational(1));
  auto points = lattice<2>(space, 10);
  // A hole beyond the ball leaves (9/10, 0), (11/10, ±1/5): circumcentre (11/10, 0), circumradius 1/5.
  const Vector<Rational, 2> hole{ratio(23, 20), Rational(0)};
  std::erase_if(points, [&](const auto& point) { return squared_distance<2>(space, point, hole) < ratio(1, 25); });
  const auto density = density_of<2>(space, points);
  EXPECT_GT(density.sampling_radius, ratio(1, 5));
  EXPECT_LT(density.sampling_radius, ratio(1, 5) * ratio(1001, 1000));
  EXPECT_LT(density.covering_radius_lower, ratio(1, 5));
}

TEST(MeasureDensity, rejects_a_ball_that_the_net_does_not_reach_beyond_naming_a_simplex) {
  const auto space = ball_of<2>(Rational(1));
  auto points = lattice<2>(space, 6);
  std::erase_if(points, [](const auto& point) { return point[0] > ratio(5, 6); });
  const std::string refusal = message_of<Rejection>([&] { (void)density_of<2>(space, points); });
  EXPECT_TRUE(mentions(refusal, "does not reach beyond the ball at net simplex {")) << refusal;
  EXPECT_THROW((void)density_of<3>(ball_of<3>(Rational(2)), random_points<3>(50, 1)), Rejection);
}

TEST(MeasureDensity, covers_balls_of_dimension_1_3_and_4) {
  const auto line = density_of<1>(ball_of<1>(Rational(1)), lattice<1>(ball_of<1>(Rational(1)), 8));
  EXPECT_GT(line.sampling_radius, ratio(1, 16));
  EXPECT_LT(line.sampling_radius, ratio(1, 16) * ratio(1001, 1000));
  const auto solid = density_of<3>(ball_of<3>(Rational(1)), lattice<3>(ball_of<3>(Rational(1)), 3));
  EXPECT_GT(square(solid.sampling_radius), ratio(3, 36));
  EXPECT_LT(square(solid.sampling_radius), ratio(3, 36) * ratio(1003, 1000));
  const auto four = ball_of<4>(ratio(1, 2));
  auto points = lattice<4>(four, 1);
  std::erase_if(points, [](const auto& p) {
    return std::any_of(p.begin(), p.end(), [](const auto& x) { return absolute(x) > Rational(2); });
  });
  const auto hyper = density_of<4>(four, points);
  EXPECT_GT(hyper.sampling_radius, ratio(1, 2));
  EXPECT_LT(hyper.covering_radius_lower, Rational(1));
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
