#include "kernel/sample/voronoi_gaps.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace delcert::test {
namespace {

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

TEST(VoronoiGaps, of_a_narrow_cell_are_none) {
  for (const Curvature curvature : all_curvatures) {
    const VoronoiGaps<2> gaps(curvature, 0.5);
    CounterRandom random(1, RandomPurpose::gap_filling, 0, 0);
    const auto found = gaps.find(square_with(plain_tangent(curvature, 0.4999)), random);
    EXPECT_TRUE(found.points.empty());
    EXPECT_NEAR(found.farthest_vertex, 0.4999, 1e-12);
  }
}

TEST(VoronoiGaps, of_a_wide_cell_are_filled_at_every_corner) {
  for (const Curvature curvature : all_curvatures) {
    const VoronoiGaps<2> gaps(curvature, 0.5);
    CounterRandom random(1, RandomPurpose::gap_filling, 0, 0);
    const auto others = square_with(plain_tangent(curvature, 0.51));
    const auto found = gaps.find(others, random);
    ASSERT_EQ(found.points.size(), 4U);
    for (const auto& point : found.points) {
      // Conformal coordinates of two points: 2 tan(d/2)-distances by the chord formula.
      const auto chord = [&](const Vector<double, 2>& a, const Vector<double, 2>& b) {
        const double sign = sign_of(curvature);
        const auto step = difference(a, b);
        const double squared = pairing(step, step) / ((1 + sign * pairing(a, a) / 4) * (1 + sign * pairing(b, b) / 4));
        return std::sqrt(squared) / 2;
      };
      const double least = curvature == Curvature::zero       ? 0.25
                           : curvature == Curvature::positive ? std::sin(0.25)
                                                              : std::sinh(0.25);
      EXPECT_GT(chord(point, Vector<double, 2>{}), least);
      for (const auto& other : others) EXPECT_GT(chord(point, other), least);
    }
  }
}

TEST(VoronoiGaps, of_a_lonely_point_are_all_about_it) {
  const VoronoiGaps<3> gaps(Curvature::positive, 0.1);
  CounterRandom random(1, RandomPurpose::gap_filling, 0, 0);
  const auto found = gaps.find({}, random);
  EXPECT_EQ(found.points.size(), 8U);
  EXPECT_TRUE(std::isinf(found.nearest));
}

TEST(VoronoiGaps, know_the_nearest_point) {
  const VoronoiGaps<2> gaps(Curvature::positive, 0.5);
  CounterRandom random(1, RandomPurpose::gap_filling, 0, 0);
  const auto found = gaps.find({{2 * std::tan(0.3), 0}, {0, 2 * std::tan(0.35)}}, random);
  EXPECT_NEAR(found.nearest, 0.6, 1e-12);
}

}  // namespace
}  // namespace delcert::test
