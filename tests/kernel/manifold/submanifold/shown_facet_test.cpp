#include "kernel/manifold/submanifold/shown_facet.hpp"

#include <gtest/gtest.h>

#include "kernel/number/rounding_guard.hpp"
#include "tests/kernel/manifold/submanifold/mesh_samples.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

/// The chart whose coordinates are those of space.
TangentChart chart_of_space() {
  ChartData data;
  data.centre = {Rational(0), Rational(0), Rational(0)};
  data.columns = {1, 2, 3};
  data.skew = {Rational(0), Rational(0), Rational(0)};
  data.preconditioner = {Rational(1)};
  data.radius = Rational(2);
  data.height = Rational(2);
  return TangentChart(data, 2);
}

TEST(ShownFacet, knows_the_places_that_it_is_certainly_not_over) {
  const RoundingGuard guard;
  const TangentChart chart = chart_of_space();
  const PolyhedralMesh mesh = polyhedral_sphere(1);
  for (std::uint32_t facet = 0; facet < 8; ++facet) {
    const ShownFacet shown(mesh, chart.enclosed(), facet);
    const double x = (shown.corners[0][0] + shown.corners[1][0] + shown.corners[2][0]).lower() / 3;
    const double y = (shown.corners[0][1] + shown.corners[1][1] + shown.corners[2][1]).lower() / 3;
    // Its middle, a corner, and what is across the middle of the octahedron.
    EXPECT_FALSE(shown.is_certainly_not_over(Interval::exactly(x), Interval::exactly(y)));
    EXPECT_FALSE(shown.is_certainly_not_over(shown.corners[0][0], shown.corners[0][1]));
    EXPECT_TRUE(shown.is_certainly_not_over(Interval::exactly(-x), Interval::exactly(-y)));
    for (std::size_t edge = 0; edge < 3; ++edge) {
      const Interval side = shown.side(edge, Interval::exactly(x), Interval::exactly(y));
      EXPECT_EQ(shown.normal[2].lower() > 0, side.lower() > 0);
    }
  }
}

TEST(ShownFacet, is_visited_if_it_may_meet_the_box) {
  const RoundingGuard guard;
  const TangentChart chart = chart_of_space();
  const PolyhedralMesh mesh = polyhedral_sphere(4);
  const std::array<Interval, 3> place{Interval::between(0.5, 0.6), Interval::between(0.1, 0.2),
                                      Interval::between(0.7, 0.9)};
  std::vector<std::uint32_t> visited;
  visit_facets(mesh, chart.enclosed(), place.data(), [&](std::uint32_t facet) { visited.push_back(facet); });
  EXPECT_LT(visited.size(), mesh.mesh().triangles.size());
  for (std::uint32_t facet = 0; facet < mesh.mesh().triangles.size(); ++facet) {
    bool is_inside = false;
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const Interval* x = mesh.point(facet, corner);
      bool is_in_all = true;
      for (std::size_t axis = 0; axis < 3; ++axis)
        is_in_all = is_in_all && place[axis].lower() <= x[axis].lower() && x[axis].upper() <= place[axis].upper();
      is_inside = is_inside || is_in_all;
    }
    if (is_inside) {
      EXPECT_NE(std::find(visited.begin(), visited.end(), facet), visited.end());
    }
  }
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
