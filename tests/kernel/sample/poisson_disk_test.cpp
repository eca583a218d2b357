#include "kernel/sample/poisson_disk.hpp"

#include "kernel/sample/net_measure.hpp"
#include "support/error.hpp"
#include "tests/kernel/manifold/exhaustive.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

/// Whether all different lifts are at distance at least `radius`, looking at all pairs.
template <int m>
bool is_separated(const FlatSpace<m>& space, const ExactPoints<m>& points, const Rational& radius) {
  for (std::uint32_t index = 0; index < points.size(); ++index) {
    for (const auto& lift : lifts_within<m>(space, points, points[index], radius)) {
      const bool itself = lift == Lift<m>{index, {}};
      if (!itself && squared_distance<m>(space, at<m>(points, lift), points[index]) < square(radius)) return false;
    }
  }
  return true;
}

/// Separated exactly, and so dense, by the certified covering radius, that nothing more fits.
template <int m>
void check_net(const FlatSpace<m>& space, const Rational& radius, std::uint64_t seed) {
  const auto points = poisson_disk_net<m>(space, radius, seed, no_progress());
  EXPECT_TRUE(is_separated<m>(space, points, radius));
  const auto density = measure_density<m>(space, PointSet<m>(points), radius, no_progress());
  EXPECT_LE(density.sampling_radius, radius * (Rational(1) + Rational::power_of_two(-27)));
  EXPECT_LT(density.covering_radius_lower, radius * (Rational(1) + Rational::power_of_two(-27)));
  for (const auto& point : points) {
    for (const Rational& coordinate : point) {
      EXPECT_EQ(rounded_down(coordinate, -52), coordinate) << "dyadic";
    }
  }
}

TEST(PoissonDiskNet, is_separated_and_maximal_on_tori) {
  check_net<1>(cubic_torus<1>(), ratio(1, 50), 1);
  check_net<2>(cubic_torus<2>(), ratio(1, 16), 2);
  check_net<2>(hexagonal_torus(), ratio(1, 16), 3);
  check_net<2>(square_torus_in_a_long_basis(), ratio(1, 12), 4);
  check_net<3>(bcc_torus(), ratio(1, 5), 5);
  check_net<3>(skewed_torus(), ratio(1, 5), 6);
}

template <int m>
void check_triangulation(const FlatSpace<m>& space, const Rational& radius, std::uint64_t seed) {
  const auto net = triangulated_poisson_disk_net<m>(space, radius, seed, no_progress());
  EXPECT_EQ(net.points, poisson_disk_net<m>(space, radius, seed, no_progress()));
  EXPECT_EQ(net.simplices,
            propose_delaunay<m>(space, PointSet<m>(net.points).approximate_all(), approximate_double(radius)));
}

TEST(PoissonDiskNet, comes_with_its_delaunay_triangulation) {
  check_triangulation<1>(cubic_torus<1>(), ratio(1, 50), 1);
  check_triangulation<2>(hexagonal_torus(), ratio(1, 16), 3);
  check_triangulation<3>(skewed_torus(), ratio(1, 5), 6);
  check_triangulation<2>(ball_of<2>(Rational(1)), ratio(1, 6), 1);
}

TEST(PoissonDiskNet, has_the_usual_number_of_points) {
  // A maximal set in the plane has about 0.70 points for every square of the radius.
  const auto points = poisson_disk_net<2>(cubic_torus<2>(), ratio(1, 24), 1, no_progress());
  EXPECT_GT(points.size(), 370U);
  EXPECT_LT(points.size(), 430U);
}

TEST(PoissonDiskNet, of_a_ball_reaches_beyond_it) {
  const auto space = ball_of<2>(Rational(1));
  const Rational radius = ratio(1, 6);
  const auto points = poisson_disk_net<2>(space, radius, 1, no_progress());
  EXPECT_TRUE(is_separated<2>(space, points, radius));
  std::size_t outside = 0;
  for (const auto& point : points) {
    EXPECT_LE(squared_norm<2>(space, point), square(ratio(4, 3)));
    outside += squared_norm<2>(space, point) > Rational(1) ? 1U : 0U;
  }
  EXPECT_GT(outside, 20U);
  EXPECT_LE(measure_density<2>(space, PointSet<2>(points), radius, no_progress()).sampling_radius,
            radius * (Rational(1) + Rational::power_of_two(-27)));
  check_net<1>(ball_of<1>(Rational(1)), ratio(1, 20), 2);
  check_net<3>(ball_of<3>(Rational(1)), ratio(1, 2), 3);
}

TEST(PoissonDiskNet, depends_on_the_seed_only) {
  const auto net = [](std::uint64_t seed) {
    return poisson_disk_net<2>(hexagonal_torus(), ratio(1, 10), seed, no_progress());
  };
  EXPECT_EQ(net(1), net(1));
  EXPECT_NE(net(1), net(2));
  EXPECT_NE(net(1), net(1 + (std::uint64_t{1} << 32U)));
}

/// FNV-1a of the coordinates in units of 2⁻⁵².
template <int m>
std::uint64_t digest(const ExactPoints<m>& points) {
  std::uint64_t hash = 0xcbf29ce484222325;
  for (const auto& point : points) {
    for (const Rational& coordinate : point) {
      auto word = Integer(floor_of(coordinate * Rational::power_of_two(52))).convert_to<std::int64_t>();
      for (int byte = 0; byte < 8; ++byte, word >>= 8) {
        hash = (hash ^ (static_cast<std::uint64_t>(word) & 255U)) * 0x100000001b3;
      }
    }
  }
  return hash;
}

// The same points with every compiler and on every machine: what they are is written down here.
TEST(PoissonDiskNet, is_the_same_everywhere) {
  const auto surface = poisson_disk_net<2>(hexagonal_torus(), ratio(1, 10), 1, no_progress());
  EXPECT_EQ(surface.size(), 61U);
  EXPECT_EQ(digest<2>(surface), 5827820548057548343U);
  const auto ball = poisson_disk_net<3>(ball_of<3>(Rational(1)), ratio(1, 2), 3, no_progress());
  EXPECT_EQ(ball.size(), 226U);
  EXPECT_EQ(digest<3>(ball), 8497159311045835493U);
}

TEST(PoissonDiskNet, is_refused_for_a_radius_that_does_not_fit) {
  EXPECT_THROW((void)poisson_disk_net<2>(cubic_torus<2>(), ratio(1, 10000), 1, no_progress()), Rejection);
  EXPECT_TRUE(mentions(message_of<Rejection>([] {
                         (void)poisson_disk_net<3>(ball_of<3>(Rational(1)), ratio(1, 1000), 1, no_progress());
                       }),
                       "4000000 points"));
  EXPECT_THROW((void)poisson_disk_net<2>(cubic_torus<2>(), Rational(10), 1, no_progress()), Rejection);
}

TEST(PoissonDiskNet, tells_its_progress_and_may_be_given_up) {
  std::vector<std::string> stages;
  const Progress listen = [&stages](std::string_view stage, std::size_t, std::size_t) { stages.emplace_back(stage); };
  (void)poisson_disk_net<2>(cubic_torus<2>(), ratio(1, 8), 1, listen);
  EXPECT_EQ(stages.front(), "throw darts");
  EXPECT_EQ(stages.back(), "fill gaps");
  const Progress give_up = [](std::string_view, std::size_t, std::size_t) { throw std::domain_error("enough"); };
  EXPECT_THROW((void)poisson_disk_net<2>(cubic_torus<2>(), ratio(1, 8), 1, give_up), std::domain_error);
}

/// With radii that vary: whole simplices of the Delaunay triangulation have small balls, and points are apart.
TEST(PoissonDisk, follows_a_sizing_function) {
  const auto space = hexagonal_torus();
  TorusSizing<2> sizing(space, 1.0 / 8);
  sizing.add({{0.25, 0.25}, 1.0 / 30, 1.0 / 5});
  const auto points = poisson_disk_net<2>(space, sizing, 3, no_progress());
  const auto size_at = [&](std::size_t label) { return sizing.at(approximate<2>(points[label])); };
  double largest = 0;
  for (const auto& simplex : propose_delaunay<2>(space, approximate_all<2>(points), 1.0 / 8)) {
    double least = 1;
    for (const auto& vertex : simplex) least = std::min(least, size_at(vertex.index));
    const auto ball = ball_of_simplex<2>(space, all_at<2>(points, std::span<const Lift<2>>(simplex)));
    largest = std::max(largest, std::sqrt(approximate_double(ball->squared_radius)) / least);
  }
  EXPECT_LE(largest, 1 + 0x1p-20);
  double nearest = 1e9;
  for (std::uint32_t label = 0; label < points.size(); ++label) {
    for (const auto& lift : lifts_within<2>(space, points, points[label], ratio(1, 8))) {
      if (lift.index == label) continue;
      const double distance =
          std::sqrt(approximate_double(squared_distance<2>(space, at<2>(points, lift), points[label])));
      nearest = std::min(nearest, distance / std::max(size_at(label), size_at(lift.index)));
    }
  }
  // A point that fills a gap keeps away from the others by the least e of a simplex, two radii away at most.
  EXPECT_GE(nearest, 1 / (1 + 2.0 / 5) - 0x1p-20);
  EXPECT_LT(nearest, 1);
  // Far more than the greatest radius asks for, far fewer than the least.
  const auto coarse = poisson_disk_net<2>(space, ratio(1, 8), 3, no_progress()).size();
  const auto fine = poisson_disk_net<2>(space, ratio(1, 30), 3, no_progress()).size();
  EXPECT_GT(points.size(), 2 * coarse);
  EXPECT_LT(2 * points.size(), fine);
  EXPECT_EQ(points, (poisson_disk_net<2>(space, sizing, 3, no_progress())));
  EXPECT_NE(points, (poisson_disk_net<2>(space, sizing, 4, no_progress())));
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
