#include "kernel/theorems/model_delaunay.hpp"

#include <gtest/gtest.h>

#include "tests/kernel/manifold/exhaustive.hpp"
#include "tests/kernel/stars/curved_patch.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

const ModelGeometry unit_sphere{Curvature::positive, Rational(3)};
const ModelGeometry hyperbolic{Curvature::negative, Rational(1)};
const ModelGeometry unit_torus{Curvature::zero, ratio(1, 2)};

template <int m>
ChartComplex<m> stars_of(const Atlas<m>& atlas, const PointSet<m>& points, const ModelGeometry& geometry) {
  ChartView<m> view(atlas, points, geometry);
  std::vector<ChartStar<m>> stars;
  std::vector<bool> interior;
  for (std::uint32_t index = 0; index < atlas.size(); ++index) {
    interior.push_back(atlas.is_interior(Label(index)));
    stars.push_back(interior.back() ? chart_star<m>(view, Label(index)).star : ChartStar<m>{Label(index), {}});
  }
  return ChartComplex<m>(std::move(stars), interior);
}

template <int m>
ModelReport report_of(const CurvedPatch<m>& atlas, const ModelGeometry& geometry, const ChartComplex<m>& complex) {
  return check_model_delaunay<m>(atlas, atlas.net(), geometry, complex, no_progress());
}

/// In doubles, from the definition: the normal n of the plane through the vertices, the distance of the other points
/// from the centre n/|n| less the radius. Of the stars of smallest labels.
struct SlowBalls {
  double protection = std::numeric_limits<double>::infinity();
  double circumradius = 0;
};
SlowBalls slow_balls(const CurvedPatch<2>& atlas, const std::vector<Vector<Rational, 2>>& net,
                     const ChartComplex<2>& complex) {
  const double sign = sign_of(atlas.curvature());
  std::vector<std::array<double, 3>> places;
  for (const auto& centre : net) {
    const auto exact = model_point<Rational, 2>(atlas.curvature(), centre);
    places.push_back({approximate_double(exact[0]), approximate_double(exact[1]), approximate_double(exact[2])});
  }
  const auto inner = [&](const auto& x, const auto& y) { return sign * x[0] * y[0] + x[1] * y[1] + x[2] * y[2]; };
  const auto distance = [&](const auto& x, const auto& y) {
    return sign > 0 ? std::acos(std::min(1.0, inner(x, y))) : std::acosh(std::max(1.0, -inner(x, y)));
  };
  SlowBalls result;
  std::vector<LabelSimplex<2>> simplices;
  for (std::uint32_t index = 0; index < complex.size(); ++index) {
    for (const auto& others : complex.chart_star(Label(index)).simplices) {
      const bool is_first = std::none_of(others.begin(), others.end(), [&](const auto& seen) {
        return seen.index < index && complex.is_interior(label_of<2>(seen));
      });
      if (is_first) simplices.push_back({index, others[0].index, others[1].index});
    }
  }
  for (const auto& simplex : simplices) {
    const auto& a = places[simplex[0]];
    const auto& b = places[simplex[1]];
    const auto& c = places[simplex[2]];
    std::array<double, 3> u{};
    std::array<double, 3> v{};
    for (std::size_t k = 0; k < 3; ++k) {
      u[k] = b[k] - a[k];
      v[k] = c[k] - a[k];
    }
    // Orthogonal to u and v in the form: the cross product with its first coordinate times the sign.
    std::array<double, 3> n{sign * (u[1] * v[2] - u[2] * v[1]), u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
    double scale = 1 / std::sqrt(std::abs(inner(n, n)));
    if (sign * inner(n, a) < 0) scale = -scale;
    for (double& entry : n) entry *= scale;
    const double radius = distance(n, a);
    result.circumradius = std::max(result.circumradius, radius);
    for (std::uint32_t other = 0; other < places.size(); ++other) {
      if (std::find(simplex.begin(), simplex.end(), other) != simplex.end()) continue;
      result.protection = std::min(result.protection, distance(n, places[other]) - radius);
    }
  }
  return result;
}

TEST(CheckModelDelaunay, has_the_margins_of_the_linear_model_on_a_sphere) {
  std::size_t certified = 0;
  for (const auto& [radius, seed] : {std::pair(0.2, 1U), std::pair(0.1, 1U), std::pair(0.1, 2U), std::pair(0.1, 3U)}) {
    const auto net = farthest_point_net<2>(Curvature::positive, radius, 20000, seed);
    const CurvedPatch<2> atlas(Curvature::positive, net, Rational::exactly(radius));
    const auto complex = stars_of<2>(atlas, atlas.net(), unit_sphere);
    const auto report = report_of<2>(atlas, unit_sphere, complex);
    const auto slow = slow_balls(atlas, net, complex);
    // Raw stars need not be Delaunay.
    ASSERT_EQ(report.failures.empty(), slow.protection > 1e-9) << seed;
    if (!report.failures.empty()) continue;
    ++certified;
    EXPECT_NEAR(report.protection, slow.protection, 1e-10);
    EXPECT_NEAR(report.circumradius, slow.circumradius, 1e-10);
  }
  EXPECT_GT(certified, 0U);
}

TEST(CheckModelDelaunay, has_the_margins_of_the_linear_model_in_the_hyperbolic_plane) {
  // Triangles at interior points of a piece of the plane, all points of which the charts of these see.
  const auto net = farthest_point_net<2>(Curvature::negative, 0.2, 6000, 2, 1.5);
  const CurvedPatch<2> atlas(Curvature::negative, net, ratio(1, 5), 1.0);
  const auto complex = stars_of<2>(atlas, atlas.net(), hyperbolic);
  ASSERT_GT(complex.simplices().size(), 100U);
  const auto report = report_of<2>(atlas, hyperbolic, complex);
  const auto slow = slow_balls(atlas, net, complex);
  ASSERT_EQ(report.failures.empty(), slow.protection > 1e-9);
  ASSERT_TRUE(report.failures.empty());
  EXPECT_NEAR(report.protection, slow.protection, 1e-10);
  EXPECT_NEAR(report.circumradius, slow.circumradius, 1e-10);
}

TEST(CheckModelDelaunay, refutes_a_flip_and_names_the_point_inside) {
  const auto net = farthest_point_net<2>(Curvature::positive, 0.2, 20000, 5);
  const CurvedPatch<2> atlas(Curvature::positive, net, ratio(1, 5));
  const auto complex = stars_of<2>(atlas, atlas.net(), unit_sphere);
  std::vector<ChartStar<2>> stars;
  for (std::uint32_t index = 0; index < atlas.size(); ++index) stars.push_back(complex.chart_star(Label(index)));
  // Two neighbours of label 0 that are not neighbours of each other span a triangle that is not Delaunay.
  const auto link = complex.neighbours(Label(0));
  const auto next = complex.neighbours(link[0]);
  const auto across = std::find_if(link.begin() + 1, link.end(), [&](Label other) {
    return std::find(next.begin(), next.end(), other) == next.end();
  });
  ASSERT_NE(across, link.end());
  stars[0].simplices.front() = {Sighting<2>{link[0].value, {}}, Sighting<2>{across->value, {}}};
  const ChartComplex<2> flipped(std::move(stars), std::vector<bool>(atlas.size(), true));
  const auto report = report_of<2>(atlas, unit_sphere, flipped);
  ASSERT_FALSE(report.failures.empty());
  const auto& failure = report.failures.front();
  EXPECT_EQ(failure.label, Label(0));
  EXPECT_TRUE(mentions(failure.reason, "has another lift in its closed geodesic circumball: label ")) << failure.reason;
  EXPECT_EQ(failure.concerned.size(), 4U);
}

TEST(CheckModelDelaunay, of_a_flat_torus_is_about_squared_distances) {
  std::vector<Vector<Rational, 2>> points;
  for (long a = 0; a < 24; ++a) {
    for (long b = 0; b < 24; ++b) {
      points.push_back(
          {ratio(a, 24) + ratio((a * 7 + b * 5) % 11, 1000), ratio(b, 24) + ratio((a * 3 + b * 8) % 13, 1000)});
    }
  }
  const FlatAtlas<2> atlas(cubic_torus<2>(), PointSet<2>(points), ratio(1, 30));
  ChartView<2> view(atlas, atlas.net(), unit_torus);
  LocalMargins margins = chart_star<2>(view, Label(0)).margins;
  for (std::uint32_t index = 0; index < atlas.size(); ++index) {
    margins.include(chart_star<2>(view, Label(index)).margins);
  }
  const auto complex = stars_of<2>(atlas, atlas.net(), unit_torus);
  const auto report = check_model_delaunay<2>(atlas, atlas.net(), unit_torus, complex, no_progress());
  ASSERT_TRUE(report.failures.empty());
  EXPECT_NEAR(report.protection, margins.protection, 1e-12);
  EXPECT_NEAR(report.circumradius, margins.circumradius, 1e-12);
}

TEST(CheckModelDelaunay, asks_for_a_large_injectivity_radius) {
  const auto net = farthest_point_net<2>(Curvature::positive, 0.2, 20000, 5);
  const CurvedPatch<2> atlas(Curvature::positive, net, ratio(1, 5));
  const auto complex = stars_of<2>(atlas, atlas.net(), unit_sphere);
  const auto report = report_of<2>(atlas, {Curvature::positive, ratio(2, 5)}, complex);
  ASSERT_EQ(report.failures.size(), 1U);
  EXPECT_TRUE(mentions(report.failures[0].reason, "half the injectivity radius"));
}

TEST(CheckModelDelaunay, knows_that_a_circle_in_the_model_may_be_no_ball) {
  // Three points far from o on a horocycle or beyond: on no geodesic circle of the hyperbolic plane.
  const std::vector<Vector<Rational, 2>> net{
      {Rational(0), Rational(0)}, {ratio(3, 2), ratio(1, 100)}, {ratio(-3, 2), ratio(1, 100)}};
  const CurvedPatch<2> atlas(Curvature::negative, net, ratio(1, 2));
  std::vector<ChartStar<2>> stars;
  for (std::uint32_t label = 0; label < 3; ++label) stars.push_back({Label(label), {}});
  stars[0].simplices = {{Sighting<2>{1, {}}, Sighting<2>{2, {}}}};
  const ChartComplex<2> complex(std::move(stars), std::vector<bool>(3, true));
  const auto report = report_of<2>(atlas, hyperbolic, complex);
  ASSERT_EQ(report.failures.size(), 1U);
  EXPECT_TRUE(mentions(report.failures[0].reason, "does not lie in the patch")) << report.failures[0].reason;
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
