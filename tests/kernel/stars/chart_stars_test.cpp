#include "kernel/stars/chart_stars.hpp"

#include <gtest/gtest.h>

#include "tests/kernel/stars/curved_patch.hpp"
#include "tests/kernel/stars/witness.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

template <int m>
CertifiedStar<m> star_at(const Atlas<m>& atlas, const PointSet<m>& points, const ModelGeometry& geometry, Label i) {
  ChartView<m> view(atlas, points, geometry);
  return chart_star<m>(view, i);
}

const ModelGeometry unit_sphere{Curvature::positive, Rational(3)};
const ModelGeometry unit_torus{Curvature::zero, ratio(1, 2)};

ExactPoints<2> square_lattice(long divisions) {
  ExactPoints<2> points;
  for (long a = 0; a < divisions; ++a) {
    for (long b = 0; b < divisions; ++b) points.push_back({ratio(a, divisions), ratio(b, divisions)});
  }
  return points;
}

TEST(ChartStar, does_not_certify_cospherical_points_and_names_them) {
  const FlatAtlas<2> atlas(cubic_torus<2>(), PointSet<2>(square_lattice(16)), ratio(3, 64));
  const auto result = star_at<2>(atlas, atlas.net(), unit_torus, Label(37));
  ASSERT_FALSE(result.failures.empty());
  for (const auto& failure : result.failures) {
    EXPECT_TRUE(mentions(failure.reason, "has another point in its closed circumball: label ")) << failure.reason;
    EXPECT_EQ(failure.cause, FailureCause::occupied_ball);
    EXPECT_EQ(failure.concerned.size(), 4U);
  }
}

TEST(ChartStar, tells_nearly_cospherical_points_apart) {
  auto points = square_lattice(16);
  points[37][0] += Rational::power_of_two(-40);
  points[37][1] += Rational::power_of_two(-41);
  const FlatAtlas<2> atlas(cubic_torus<2>(), PointSet<2>(points), ratio(3, 64));
  const auto result = star_at<2>(atlas, atlas.net(), unit_torus, Label(37));
  EXPECT_TRUE(result.failures.empty());
  EXPECT_GT(result.margins.protection, 0x1p-44);
  EXPECT_LT(result.margins.protection, 0x1p-38);
  // The stars of its neighbours still have other squares.
  EXPECT_FALSE(star_at<2>(atlas, atlas.net(), unit_torus, Label(38)).failures.empty());
}

TEST(ChartStar, of_a_flat_torus_is_that_of_exact_balls) {
  const auto points = random_points<2>(400, 7, 30, Rational(0), Rational(1));
  const FlatAtlas<2> atlas(hexagonal_torus(), PointSet<2>(points), ratio(1, 24));
  std::size_t certified = 0;
  for (std::uint32_t index = 0; index < 60; ++index) {
    const auto result = star_at<2>(atlas, atlas.net(), unit_torus, Label(index));
    if (!result.failures.empty()) continue;
    ++certified;
    for (const auto& others : result.star.simplices) {
      Lifts<2> lifts{{index, {}}};
      lifts.insert(lifts.end(), others.begin(), others.end());
      const auto ball = *ball_of_simplex<2>(atlas.space(), all_at<2>(points, std::span<const Lift<2>>(lifts)));
      EXPECT_TRUE(is_empty<2>(atlas.space(), points, ball));
      EXPECT_LE(ball.squared_radius, square(Rational::exactly(result.margins.circumradius)));
      // Grown by the protection, too.
      const Rational radius = square_root_lower(ball.squared_radius, 60) + Rational::exactly(result.margins.protection);
      EXPECT_EQ(lifts_within<2>(atlas.space(), points, ball.centre, radius).size(), 3U);
    }
  }
  EXPECT_GT(certified, 40U);
}

TEST(ChartStar, of_a_sphere_has_the_margins_that_it_says) {
  const auto atlas = sphere(ratio(1, 5));
  const double unit = 0.2;
  std::size_t certified = 0;
  for (std::uint32_t index = 0; index < atlas.size(); index += 5) {
    const Label i(index);
    const auto result = star_at<2>(atlas, atlas.net(), unit_sphere, i);
    if (!result.failures.empty()) continue;
    ++certified;
    EXPECT_GE(result.star.simplices.size(), 4U);
    EXPECT_LE(result.margins.circumradius, 1.1 * unit);
    EXPECT_GE(result.margins.thickness, 0.1);
    EXPECT_LE(result.margins.protection, unit / 2);
    // In doubles: all other points are farther by nearly the protection, and somewhere not by much more.
    double least = unit / 2;
    for (const auto& others : result.star.simplices) {
      const auto at = [&](const Sighting<2>& seen) {
        const BigInterval::Precision precision(PrecisionBits{128});
        const auto there = atlas.carry(i, seen, Vector<BigInterval, 2>{});
        return Vector<double, 2>{approximate_double(there[0].lower()), approximate_double(there[1].lower())};
      };
      const auto p = at(others[0]);
      const auto q = at(others[1]);
      const double determinant = 2 * (p[0] * q[1] - p[1] * q[0]);
      const double pp = p[0] * p[0] + p[1] * p[1];
      const double qq = q[0] * q[0] + q[1] * q[1];
      const Vector<double, 2> centre{(pp * q[1] - qq * p[1]) / determinant, (qq * p[0] - pp * q[0]) / determinant};
      const double radius = std::hypot(centre[0], centre[1]);
      for (const auto& seen : atlas.neighbours(i)) {
        if (seen == others[0] || seen == others[1] || seen.index == index) continue;
        const auto x = at(seen);
        least = std::min(least, std::hypot(x[0] - centre[0], x[1] - centre[1]) - radius);
      }
    }
    EXPECT_LE(result.margins.reach, 2 * result.margins.circumradius * (1 + 1e-9));
    EXPECT_GE(result.margins.reach, result.margins.circumradius);
    EXPECT_LE(result.margins.protection, least * (1 + 1e-9));
    EXPECT_GE(result.margins.protection, least - 1e-9);
  }
  EXPECT_GT(certified, 20U);
}

TEST(ChartStar, loses_its_protection_when_one_point_moves_into_a_ball) {
  const auto atlas = sphere(ratio(1, 5));
  std::uint32_t index = 0;
  while (!star_at<2>(atlas, atlas.net(), unit_sphere, Label(index)).failures.empty()) ++index;
  const Label i(index);
  const auto before = star_at<2>(atlas, atlas.net(), unit_sphere, i);
  // The neighbours of i in a simplex move to its middle one after the other; then the simplex has another neighbour.
  const auto& others = before.star.simplices.front();
  ExactPoints<2> points(atlas.size(), Vector<Rational, 2>{});
  points[index] = {ratio(1, 1000), ratio(-1, 700)};
  const auto moved = star_at<2>(atlas, PointSet<2>(points), unit_sphere, i);
  EXPECT_NE(moved.margins.protection, before.margins.protection);
  // On top of another point: two labels at one place.
  const BigInterval::Precision precision(PrecisionBits{128});
  const auto there = atlas.carry(i, others[0], Vector<BigInterval, 2>{});
  points[index] = {there[0].lower(), there[1].lower()};
  const auto coincident = star_at<2>(atlas, PointSet<2>(points), unit_sphere, i);
  ASSERT_FALSE(coincident.failures.empty());
  const auto other = star_at<2>(atlas, PointSet<2>(points), unit_sphere, label_of<2>(others[0]));
  EXPECT_FALSE(other.failures.empty());
}

TEST(ChartStar, needs_all_of_its_surroundings) {
  // Half of the points of the sphere: stars at the rim are not closed in a patch.
  const auto whole = farthest_point_net<2>(Curvature::positive, 0.1, 20000, 3);
  std::vector<Vector<Rational, 2>> half;
  for (const auto& a : whole) {
    if (a[0] > Rational(0)) half.push_back(a);
  }
  const CurvedPatch<2> atlas(Curvature::positive, half, ratio(1, 10));
  std::size_t failed = 0;
  std::size_t certified = 0;
  for (std::uint32_t index = 0; index < atlas.size(); ++index) {
    const bool is_rim = approximate_double(half[index][0]) < 0.02;
    const auto result = star_at<2>(atlas, atlas.net(), unit_sphere, Label(index));
    EXPECT_TRUE(!is_rim || !result.failures.empty());
    (result.failures.empty() ? certified : failed) += 1;
  }
  EXPECT_GT(failed, 5U);
  EXPECT_GT(certified, 300U);
}

TEST(ChartStar, in_dimension_3_fills_the_directions) {
  const auto points = random_points<3>(1500, 5, 30, Rational(0), Rational(1));
  const FlatAtlas<3> atlas(cubic_torus<3>(), PointSet<3>(points), ratio(1, 12));
  std::size_t certified = 0;
  for (std::uint32_t index = 0; index < 12; ++index) {
    const auto result = star_at<3>(atlas, atlas.net(), unit_torus, Label(index));
    if (!result.failures.empty()) continue;
    ++certified;
    // The link is a sphere: 2v − 4 triangles.
    std::vector<std::uint32_t> link;
    for (const auto& others : result.star.simplices) {
      for (const auto& seen : others) link.push_back(seen.index);
    }
    std::sort(link.begin(), link.end());
    link.erase(std::unique(link.begin(), link.end()), link.end());
    EXPECT_EQ(result.star.simplices.size(), 2 * link.size() - 4);
  }
  EXPECT_GT(certified, 6U);
}

TEST(LocalMargins, are_the_worst_of_both) {
  LocalMargins margins{2, 3, 4, 5};
  margins.include({1, 5, 3, 6});
  EXPECT_EQ(margins.protection, 1);
  EXPECT_EQ(margins.thickness, 3);
  EXPECT_EQ(margins.circumradius, 4);
  EXPECT_EQ(margins.reach, 6);
}

TEST(SimplexText, is_sorted) { EXPECT_EQ(simplex_text({Label(7), Label(2), Label(5)}), "simplex {2, 5, 7}"); }

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
