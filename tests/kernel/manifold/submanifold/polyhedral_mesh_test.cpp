#include "kernel/manifold/submanifold/polyhedral_mesh.hpp"

#include <gtest/gtest.h>

#include "kernel/manifold/submanifold/shown_facet.hpp"
#include "kernel/number/elementary.hpp"
#include "kernel/number/rounding_guard.hpp"
#include "kernel/number/scalar.hpp"
#include "tests/kernel/manifold/submanifold/mesh_samples.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

/// About the north pole, with the plane of x and y.
TangentChart chart_at_pole(const Rational& weight = Rational(1)) {
  ChartData data;
  data.centre = {Rational(0), Rational(0), Rational(1)};
  data.columns = {1, 2, 3};
  data.skew = {Rational(0), Rational(0), Rational(0)};
  data.preconditioner = {weight};
  data.radius = ratio(1, 2);
  data.height = ratio(1, 4);
  return TangentChart(data, 2);
}

TEST(PolyhedralMesh, of_a_sphere_is_closed) {
  const PolyhedralMesh mesh = polyhedral_sphere(4);
  EXPECT_EQ(mesh.mesh().points.size(), 66U);
  EXPECT_EQ(mesh.mesh().triangles.size(), 128U);
  EXPECT_EQ(mesh.dimension(), 2U);
  EXPECT_FALSE(mesh.is_smooth());
  for (std::uint32_t facet = 0; facet < 128; ++facet) {
    for (std::size_t edge = 0; edge < 3; ++edge) {
      const auto& there = mesh.neighbours(mesh.neighbours(facet)[edge]);
      EXPECT_NE(std::find(there.begin(), there.end(), facet), there.end());
    }
  }
  for (const auto& side : mesh.box()) EXPECT_TRUE(side[0] < Rational(-1) && Rational(1) < side[1]);
}

TEST(PolyhedralMesh, heights_are_the_same_on_all_rungs) {
  const PolyhedralMesh mesh = polyhedral_sphere(8);
  const TangentChart chart = chart_at_pole();
  const auto evaluation = mesh.evaluation();
  // Also over a vertex, an edge, and next to one.
  const std::array<std::array<Rational, 2>, 4> places{{{ratio(1, 7), ratio(2, 11)},
                                                       {Rational(0), Rational(0)},
                                                       {ratio(1, 16), Rational(0)},
                                                       {ratio(1, 16), Rational::power_of_two(-80)}}};
  for (const auto& y : places) {
    const auto exact = evaluation->heights(chart, y.data());
    ASSERT_TRUE(exact);
    const std::array<BigInterval, 2> in_big{BigInterval(y[0]), BigInterval(y[1])};
    const auto big = evaluation->heights(chart, in_big.data());
    ASSERT_TRUE(big);
    EXPECT_LE((*big)[0].lower(), (*exact)[0]);
    EXPECT_GE((*big)[0].upper(), (*exact)[0]);
    EXPECT_LT((*big)[0].upper() - (*big)[0].lower(), Rational::power_of_two(-50));
    const RoundingGuard guard;
    const std::array<Interval, 2> in_doubles{scalar_from<Interval>(y[0]), scalar_from<Interval>(y[1])};
    const auto filtered = evaluation->heights(chart, in_doubles.data());
    ASSERT_TRUE(filtered);
    EXPECT_LE(Rational::exactly((*filtered)[0].lower()), (*exact)[0]);
    EXPECT_GE(Rational::exactly((*filtered)[0].upper()), (*exact)[0]);
    EXPECT_LT((*filtered)[0].upper() - (*filtered)[0].lower(), 1e-12);
    // Below the sphere, above the chords of its facets.
    const double height = approximate_double((*exact)[0]) + 1;
    const double round = std::sqrt(1 - approximate_double(y[0] * y[0] + y[1] * y[1]));
    EXPECT_LE(height, round + 1e-15);
    EXPECT_GE(height, round - 0.02);
  }
  const std::array<Rational, 2> outside{ratio(3, 2), Rational(0)};
  EXPECT_FALSE(evaluation->heights(chart, outside.data()));
}

TEST(PolyhedralMesh, has_derivatives_and_heights_over_a_simplex) {
  const PolyhedralMesh mesh = polyhedral_sphere(12);
  const RoundingGuard guard;
  for (const long weight : {1, -2}) {
    const TangentChart chart = chart_at_pole(Rational(weight));
    const auto evaluation = mesh.evaluation();
    const std::array<std::array<Rational, 2>, 3> corners{
        {{Rational(0), Rational(0)}, {ratio(1, 4), ratio(1, 50)}, {ratio(1, 9), ratio(1, 4)}}};
    std::array<std::array<Interval, 3>, 3> places;
    std::array<const Interval*, 3> vertices;
    for (std::size_t v = 0; v < 3; ++v) {
      const auto height = evaluation->heights(chart, corners[v].data());
      ASSERT_TRUE(height);
      places[v] = {scalar_from<Interval>(corners[v][0]), scalar_from<Interval>(corners[v][1]),
                   scalar_from<Interval>((*height)[0] + Rational(1))};
      vertices[v] = places[v].data();
    }
    DerivativeHull hull;
    ASSERT_TRUE(evaluation->enclose(chart, vertices, 0.01, hull));
    EXPECT_GE(hull.matrices.size(), 6U);
    EXPECT_EQ(hull.spread.upper(), 0);
    for (const Dense<Interval>& matrix : hull.matrices) {
      // The height itself has the derivative 1 along N; it is over Y.
      EXPECT_LE(matrix[2].lower(), 1.0 / static_cast<double>(weight));
      EXPECT_GE(matrix[2].upper(), 1.0 / static_cast<double>(weight));
    }
    // By hand, at some places of the simplex.
    double most = 0;
    for (int i = 0; i <= 10; ++i) {
      for (int j = 0; i + j <= 10; ++j) {
        const std::array<Rational, 3> t{ratio(i, 10), ratio(j, 10), ratio(10 - i - j, 10)};
        std::array<Rational, 2> y{Rational(0), Rational(0)};
        double flat = 0;
        for (std::size_t v = 0; v < 3; ++v) {
          for (std::size_t k = 0; k < 2; ++k) y[k] = y[k] + t[v] * corners[v][k];
          flat += approximate_double(t[v]) * (places[v][2].lower() - 1);
        }
        const auto height = evaluation->heights(chart, y.data());
        ASSERT_TRUE(height);
        most =
            std::max(most, std::fabs(approximate_double((*height)[0]) - flat) / std::abs(static_cast<double>(weight)));
      }
    }
    EXPECT_GT(most, 0);
    EXPECT_GE(hull.height, most * (1 - 1e-9));
    EXPECT_LE(hull.height, 3 * most);
    // Where nothing is over it.
    for (auto& place : places) place[0] = place[0] + Interval(5);
    EXPECT_FALSE(evaluation->enclose(chart, vertices, 0.01, hull));
  }
}

TEST(PolyhedralMesh, is_sampled_by_its_areas_with_normals_to_the_outside) {
  const PolyhedralMesh mesh = polyhedral_sphere(6);
  const auto sampler = mesh.sampler(0.1);
  CounterRandom random(1, RandomPurpose::darts, 0, 0);
  std::size_t upper = 0;
  for (int dart = 0; dart < 400; ++dart) {
    std::vector<double> x = sampler->dart(random);
    ASSERT_TRUE(sampler->project(x, nullptr));
    const double length = std::sqrt(x[0] * x[0] + x[1] * x[1] + x[2] * x[2]);
    EXPECT_LE(length, 1 + 1e-12);
    EXPECT_GE(length, 0.97);
    if (x[2] > 0) ++upper;
    const auto normals = sampler->normals(x);
    ASSERT_TRUE(normals);
    double cosine = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) cosine += (*normals)[axis] * x[axis] / length;
    EXPECT_GE(cosine, 0.97);
    // From outside, along the normal, back to the mesh.
    const auto frame = propose_frame(*normals, 1, 3);
    ASSERT_TRUE(frame);
    std::vector<double> away = x;
    for (std::size_t axis = 0; axis < 3; ++axis) away[axis] += 0.05 * frame->frame[3 * axis + 2];
    ASSERT_TRUE(sampler->project(away, &frame->frame));
    for (std::size_t axis = 0; axis < 3; ++axis) EXPECT_NEAR(away[axis], x[axis], 1e-9);
  }
  EXPECT_GE(upper, 160U);
  EXPECT_LE(upper, 240U);
  const Dense<double> identity{1, 0, 0, 0, 1, 0, 0, 0, 1};
  std::vector<double> far{5, 0, 0};
  EXPECT_FALSE(sampler->project(far, &identity));
}

TEST(PolyhedralMesh, slopes_are_nearly_affine_where_facets_are_small) {
  const RoundingGuard guard;
  const TangentChart chart = chart_at_pole();
  const Interval side = Interval::between(-0.25, 0.25);
  const std::array<Interval, 2> place{side, side};
  const auto change_of = [&](int k) {
    const auto change = polyhedral_sphere(k).evaluation()->slope_change(chart, place.data(), Interval(1));
    EXPECT_TRUE(change);
    return change.value_or(SlopeChange{});
  };
  const SlopeChange fine = change_of(64);
  const SlopeChange coarse = change_of(16);
  EXPECT_NEAR(fine.rate.upper(), 1, 0.1);
  EXPECT_LT(fine.size.upper(), 0.05);
  EXPECT_LT(fine.size.upper(), coarse.size.upper());
  // Slopes of facets differ by what is said, and by no less than a facet's share of it.
  const PolyhedralMesh mesh = polyhedral_sphere(16);
  struct Slope {
    std::array<double, 2> place, slope;
  };
  std::vector<Slope> slopes;
  const std::array<Interval, 3> low{side, side, Interval::between(-0.25, 0.25)};
  visit_facets(mesh, chart.enclosed(), low.data(), [&](std::uint32_t facet) {
    const ShownFacet shown(mesh, chart.enclosed(), facet);
    Slope one{};
    for (std::size_t axis = 0; axis < 2; ++axis) {
      for (const auto& corner : shown.corners) one.place[axis] += corner[axis].lower() / 3;
      one.slope[axis] = (-(shown.normal[axis] / shown.normal[2])).lower();
    }
    if (std::hypot(one.place[0], one.place[1]) < 0.25) slopes.push_back(one);
  });
  ASSERT_GT(slopes.size(), 20U);
  double most = 0;
  for (const Slope& a : slopes) {
    for (const Slope& b : slopes) {
      const double apart = std::hypot(a.place[0] - b.place[0], a.place[1] - b.place[1]);
      const double change = std::hypot(a.slope[0] - b.slope[0], a.slope[1] - b.slope[1]);
      EXPECT_LE(change, coarse.rate.upper() * apart + 2 * coarse.size.upper() + 1e-12);
      most = std::max(most, change - coarse.rate.upper() * apart);
    }
  }
  EXPECT_GT(most, 0);
  // A facet that is vertical in the chart.
  TangentChart high = chart_at_pole();
  high.set_size(Rational(2), Rational(8));
  const Interval wide = Interval::between(-1.5, 1.5);
  const std::array<Interval, 2> all{wide, wide};
  EXPECT_TRUE(polyhedral_sphere(1).evaluation()->slope_change(high, all.data(), Interval(1)));
  TriangleMesh prism = sphere_mesh(1);
  for (auto& point : prism.points) {
    if (point[2] < Rational(0)) point = {Rational(1), Rational(0), Rational(-3)};
  }
  EXPECT_FALSE(PolyhedralMesh("prism", prism, {}).evaluation()->slope_change(high, all.data(), Interval(1)));
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
