#include "kernel/chart/chart_view.hpp"

#include <gtest/gtest.h>

#include "tests/kernel/manifold/exhaustive.hpp"
#include "tests/kernel/stars/curved_patch.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

const ModelGeometry unit_sphere{Curvature::positive, Rational(3)};
const ModelGeometry hyperbolic{Curvature::negative, Rational(1)};
const ModelGeometry unit_torus{Curvature::zero, ratio(1, 2)};

TEST(ChartView, is_centred_at_the_original_point) {
  auto points = random_points<2>(50, 3);
  const FlatAtlas<2> atlas(hexagonal_torus(), PointSet<2>(points), ratio(1, 10));
  const Vector<Rational, 2> moved = sum(points[7], Vector<Rational, 2>{ratio(1, 100), ratio(-1, 50)});
  points[7] = moved;
  const PointSet<2> set(points);
  ChartView<2> view(atlas, set, unit_torus);
  view.look(Label(7), 0.4);
  const auto home = view.find(Label(7));
  ASSERT_TRUE(home.has_value());
  const auto at_home = view.position_in<Rational>(LocalCoordinates::chart, *home);
  EXPECT_EQ(at_home, (Vector<Rational, 2>{ratio(1, 100), ratio(-1, 50)}));
  EXPECT_EQ(view.position_in<Rational>(LocalCoordinates::conformal, *home), at_home);
  const FilterGuard guard;
  const auto& enclosure = view.position(LocalCoordinates::conformal, *home);
  for (std::size_t axis = 0; axis < 2; ++axis) {
    EXPECT_LE(Rational::exactly(enclosure[axis].lower()), at_home[axis]);
    EXPECT_GE(Rational::exactly(enclosure[axis].upper()), at_home[axis]);
  }
}

TEST(ChartView, shows_every_lift_within_its_complete_radius) {
  const auto net = random_points<2>(80, 3);
  auto points = net;
  for (std::size_t k = 0; k < points.size(); k += 3) points[k][0] += ratio(1, 64);
  const FlatAtlas<2> atlas(cubic_torus<2>(), PointSet<2>(net), ratio(1, 9));
  const PointSet<2> set(points);
  ChartView<2> view(atlas, set, unit_torus);
  EXPECT_GE(view.displacement(Label(0)), 1.0 / 64);
  EXPECT_LE(view.displacement(Label(0)), 1.0 / 64 * (1 + 0x1p-40));
  for (std::uint32_t chart = 0; chart < 10; ++chart) {
    view.look(Label(chart), 0.3);
    const double complete = view.complete_radius(LocalCoordinates::chart);
    EXPECT_GT(complete, 0.3 - 1.0 / 64 - 1e-9);
    EXPECT_LE(complete, 0.3 - 1.0 / 64);
    const auto near = lifts_within<2>(atlas.space(), points, net[chart], Rational::exactly(complete));
    for (const auto& lift : near) {
      bool is_shown = false;
      for (std::size_t place = 0; place < view.size(); ++place) is_shown = is_shown || view.sighting(place) == lift;
      EXPECT_TRUE(is_shown);
    }
  }
  view.look(Label(0), 1.0 / 128);
  EXPECT_EQ(view.complete_radius(LocalCoordinates::chart), 0);
}

TEST(ChartView, finds_a_label_that_is_seen_once_only) {
  const FlatAtlas<2> atlas(cubic_torus<2>(), PointSet<2>(random_points<2>(20, 8)), ratio(1, 4));
  ChartView<2> view(atlas, atlas.net(), unit_torus);
  view.look(Label(4), 0.3);
  std::size_t found = 0;
  for (std::uint32_t label = 0; label < 20; ++label) {
    const auto place = view.find(Label(label));
    if (!place) continue;
    ++found;
    EXPECT_EQ(view.label(*place), Label(label));
  }
  EXPECT_GT(found, 3U);
  EXPECT_LT(found, 15U);
  // Beyond half a period the label itself is seen again.
  view.look(Label(4), 1.1);
  EXPECT_FALSE(view.find(Label(4)).has_value());
}

TEST(ChartView, has_conformal_coordinates_in_which_balls_are_balls) {
  // Points at one distance from p_j, as the chart of i sees them: on a circle in conformal coordinates, and on none in
  // the chart.
  for (const auto& [geometry, curvature] :
       {std::pair(unit_sphere, Curvature::positive), std::pair(hyperbolic, Curvature::negative)}) {
    std::vector<Vector<Rational, 2>> net{{ratio(1, 4), ratio(0, 1)}};
    for (int k = 0; k < 4; ++k) net.push_back({ratio(1, 8), ratio(-1, 3)});
    const CurvedPatch<2> atlas(curvature, net, ratio(1, 5));
    ExactPoints<2> points{{Rational(0), Rational(0)},
                          {ratio(3, 10), Rational(0)},
                          {Rational(0), ratio(3, 10)},
                          {ratio(-3, 10), Rational(0)},
                          {ratio(-18, 100), ratio(-24, 100)}};
    const PointSet<2> set(points);
    ChartView<2> view(atlas, set, geometry);
    view.look(Label(0), 1.5);
    ASSERT_EQ(view.size(), 5U);
    const BigInterval::Precision precision(PrecisionBits{200});
    for (const auto coordinates : {LocalCoordinates::chart, LocalCoordinates::conformal}) {
      // |x|² lifts; the determinant vanishes for points of a circle.
      std::array<std::array<BigInterval, 3>, 3> rows;
      const auto first = view.position_in<BigInterval>(coordinates, 1);
      for (std::size_t k = 0; k < 3; ++k) {
        const auto edge = difference(view.position_in<BigInterval>(coordinates, k + 2), first);
        rows[k] = {edge[0], edge[1], square(edge[0]) + square(edge[1])};
      }
      const auto cross = [&](std::size_t a, std::size_t b, std::size_t row) {
        return rows[row][a] * rows[(row + 1) % 3][b] - rows[row][b] * rows[(row + 1) % 3][a];
      };
      const BigInterval determinant =
          rows[2][2] * cross(0, 1, 0) + rows[0][2] * cross(0, 1, 1) + rows[1][2] * cross(0, 1, 2);
      EXPECT_EQ(is_refuted(is_zero(determinant)), coordinates == LocalCoordinates::chart);
    }
    // The filter's enclosures contain those of the next rung.
    const FilterGuard guard;
    for (std::size_t place = 0; place < 5; ++place) {
      const auto big = view.position_in<BigInterval>(LocalCoordinates::conformal, place);
      const auto& small = view.position(LocalCoordinates::conformal, place);
      for (std::size_t axis = 0; axis < 2; ++axis) {
        EXPECT_LE(Rational::exactly(small[axis].lower()), big[axis].lower());
        EXPECT_GE(Rational::exactly(small[axis].upper()), big[axis].upper());
        EXPECT_LE(small[axis].upper() - small[axis].lower(), 1e-13);
      }
    }
  }
}

TEST(ChartView, looks_as_far_as_patches_reach) {
  const FlatAtlas<2> atlas(cubic_torus<2>(), PointSet<2>(random_points<2>(20, 8)), ratio(1, 20));
  const auto reaches = [&](const Rational& factor) {
    return ChartView<2>(atlas, atlas.net(), {Curvature::zero, ratio(1, 2), factor}).half_reaches();
  };
  EXPECT_EQ(reaches(9), (std::vector<double>{7, 10, 14, 18}));
  EXPECT_EQ(reaches(5), (std::vector<double>{7, 10}));
  EXPECT_EQ(reaches(ratio(19, 4)), (std::vector<double>{7, 9.5}));
  // Defect: in a patch smaller than the first reach nothing was looked at, and nothing found wrong.
  EXPECT_EQ(reaches(3), (std::vector<double>{6}));
  ChartView<2> view(atlas, atlas.net(), unit_torus);
  view.look_by_halves(Label(0), 7);
  EXPECT_NEAR(view.reach(), 3.5 / 20, 1e-12);
  EXPECT_LT(view.reach(), 3.5 / 20);
}

TEST(ChartView, converts_its_complete_radius) {
  const CurvedPatch<2> atlas(Curvature::positive, {{Rational(0), Rational(0)}, {ratio(1, 4), ratio(1, 3)}},
                             ratio(1, 5));
  ChartView<2> view(atlas, atlas.net(), unit_sphere);
  view.look(Label(1), 1);
  const double length = view.complete_radius(LocalCoordinates::chart);
  EXPECT_NEAR(length, 1, 1e-12);
  EXPECT_LE(view.complete_radius(LocalCoordinates::conformal), 2 * std::tan(length / 2) * (1 + 1e-15));
  EXPECT_NEAR(view.complete_radius(LocalCoordinates::conformal), 2 * std::tan(length / 2), 1e-12);
  view.look(Label(1), 1.58);
  EXPECT_EQ(view.complete_radius(LocalCoordinates::conformal), 0) << "beyond a right angle";
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
