#include "kernel/sample/voronoi_cells.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace delcert::test {
namespace DELCERT_THIS_FILE {

constexpr std::array all_curvatures{Curvature::negative, Curvature::zero, Curvature::positive};

/// The corners of a square about 0 whose Voronoi cell has vertices with this tangent.
std::vector<Vector<double, 2>> square_with(double tangent) {
  // A ball through 0 with centre (t, 0)·tangent passes (t, ±t): the corners of the cell.
  const double side = tangent * std::sqrt(2);
  return {{side, 0}, {0, side}, {-side, 0}, {0, -side}};
}

double plain_tangent(Curvature curvature, double x) {
  return curvature == Curvature::zero ? x : curvature == Curvature::positive ? std::tan(x) : std::tanh(x);
}

CounterRandom some_random() { return {1, RandomPurpose::gap_filling, 0, 0}; }

TEST(VoronoiCells, that_are_narrow_have_no_gaps) {
  for (const Curvature curvature : all_curvatures) {
    const VoronoiCells<2> cells(curvature, 1.125);
    const auto cell = cells.cell(square_with(plain_tangent(curvature, 0.4999)));
    auto random = some_random();
    EXPECT_TRUE(cells.points_in_gaps(cell, 0.5, random).empty());
    EXPECT_EQ(cells.points_in_gaps(cell, 0.499, random).size(), 4U);
    EXPECT_EQ(cell.sphere_centres.size(), 4U);
    EXPECT_NEAR(cell.farthest_vertex, 0.4999, 1e-12);
  }
}

TEST(VoronoiCells, that_are_wide_are_filled_at_every_corner) {
  for (const Curvature curvature : all_curvatures) {
    const VoronoiCells<2> cells(curvature, 1.125);
    const auto others = square_with(plain_tangent(curvature, 0.51));
    auto random = some_random();
    const auto points = cells.points_in_gaps(cells.cell(others), 0.5, random);
    ASSERT_EQ(points.size(), 4U);
    for (const auto& point : points) {
      // Half the chord of two points by their conformal coordinates.
      const auto half_chord = [&](const Vector<double, 2>& a, const Vector<double, 2>& b) {
        const double sign = sign_of(curvature);
        const auto step = difference(a, b);
        const double squared = pairing(step, step) / ((1 + sign * pairing(a, a) / 4) * (1 + sign * pairing(b, b) / 4));
        return std::sqrt(squared) / 2;
      };
      const double least = curvature == Curvature::zero       ? 0.25
                           : curvature == Curvature::positive ? std::sin(0.25)
                                                              : std::sinh(0.25);
      EXPECT_GT(half_chord(point, Vector<double, 2>{}), least);
      for (const auto& other : others) EXPECT_GT(half_chord(point, other), least);
    }
  }
}

TEST(VoronoiCells, of_a_lonely_point_are_cut_off) {
  const VoronoiCells<3> cells(Curvature::positive, 0.2);
  const auto cell = cells.cell({});
  EXPECT_EQ(cell.sphere_centres.size(), 8U);
  EXPECT_NEAR(cell.farthest_vertex, 0.1, 1e-12);
  EXPECT_TRUE(std::isinf(cell.nearest));
  EXPECT_TRUE(cell.is_cut_off);
  EXPECT_EQ(VoronoiCells<3>::mass_centre(cell), (Vector<double, 3>{}));
}

TEST(VoronoiCells, know_the_nearest_point) {
  const VoronoiCells<2> cells(Curvature::positive, 1);
  const auto cell = cells.cell({{2 * std::tan(0.3), 0}, {0, 2 * std::tan(0.35)}});
  EXPECT_NEAR(cell.nearest, 0.6, 1e-12);
}

TEST(VoronoiCells, have_a_mass_centre) {
  // The rectangle [−1/2, 1] × [−1/2, 1/2], also where its vertices do not lie in their simplices.
  const VoronoiCells<2> plane(Curvature::zero, 20);
  const auto rectangle = VoronoiCells<2>::mass_centre(plane.cell({{2, 0}, {0, 1}, {-1, 0}, {0, -1}}));
  EXPECT_NEAR(rectangle[0], 0.25, 1e-15);
  EXPECT_NEAR(rectangle[1], 0, 1e-15);
  // The triangle with the vertices (2, 0), (−1, 3), (−1, −3), whose sides are x = −1 and |y| = 2 − x.
  const auto triangle = VoronoiCells<2>::mass_centre(plane.cell({{-2, 0}, {2, 2}, {2, -2}}));
  EXPECT_NEAR(triangle[0], 0, 1e-14);
  EXPECT_NEAR(triangle[1], 0, 1e-14);
  // The box [−1/2, 1] × [−1/2, 1/2] × [−1, 1/2].
  const VoronoiCells<3> space(Curvature::zero, 20);
  const auto box =
      VoronoiCells<3>::mass_centre(space.cell({{2, 0, 0}, {0, 1, 0}, {0, 0, 1}, {-1, 0, 0}, {0, -1, 0}, {0, 0, -2}}));
  EXPECT_NEAR(box[0], 0.25, 1e-14);
  EXPECT_NEAR(box[1], 0, 1e-14);
  EXPECT_NEAR(box[2], -0.25, 1e-14);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
