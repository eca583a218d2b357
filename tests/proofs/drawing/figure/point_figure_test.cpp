#include "proofs/drawing/figure/point_figure.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace delcert {
namespace DELCERT_THIS_FILE {

double distance(const Figure::Point& a, const Figure::Point& b) { return std::hypot(a[0] - b[0], a[1] - b[1]); }

TEST(PointFigure, of_a_triangle_is_true_to_scale) {
  const Figure figure = figure_of({{"s", true, {{0, 0}, {3, 0}, {0, 4}}}});
  ASSERT_EQ(figure.circles.size(), 1U);
  EXPECT_NEAR(figure.circles[0].radius, 2.5, 1e-12);
  ASSERT_EQ(figure.dots.size(), 4U) << "the circumcentre and three vertices";
  for (std::size_t vertex = 1; vertex <= 3; ++vertex)
    EXPECT_NEAR(distance(figure.dots[vertex].centre, figure.circles[0].centre), 2.5, 1e-12);
  ASSERT_EQ(figure.paths.size(), 2U);
  EXPECT_TRUE(figure.paths[0].is_dashed);
  EXPECT_NEAR(distance(figure.paths[0].lines[0][0], figure.paths[0].lines[0][1]), 2.4, 1e-12) << "the least altitude";
  EXPECT_EQ(figure.paths[1].lines.size(), 3U);
  ASSERT_EQ(figure.names.size(), 3U);
  EXPECT_EQ(figure.names[2].text, "2");
  ASSERT_TRUE(figure.scale);
  EXPECT_EQ(figure.scale->text, "1");
  EXPECT_EQ(figure.description, "the simplex s");
}

TEST(PointFigure, moves_rigidly_into_the_plane) {
  // The same triangle in a plane of ℝ⁵.
  const Figure figure = figure_of({{"s", true, {{1, 1, 1, 1, 1}, {1, 4, 1, 1, 1}, {1, 1, 1, 1, 5}}}});
  ASSERT_EQ(figure.circles.size(), 1U);
  EXPECT_NEAR(figure.circles[0].radius, 2.5, 1e-12);
  EXPECT_EQ(figure.description, "the simplex s");
}

TEST(PointFigure, of_a_tetrahedron_is_seen_from_a_corner) {
  const Figure figure = figure_of({{"s", true, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}});
  ASSERT_EQ(figure.circles.size(), 1U);
  EXPECT_NEAR(figure.circles[0].radius, std::sqrt(0.75), 1e-12);
  EXPECT_EQ(figure.paths.back().lines.size(), 6U);
  for (const auto& edge : figure.paths.back().lines) EXPECT_GT(distance(edge[0], edge[1]), 0.1);
}

TEST(PointFigure, of_four_dimensions_is_projected_and_says_so) {
  DrawnSet set{"s", true, {{0, 0, 0, 0}}};
  for (std::size_t axis = 0; axis < 4; ++axis) {
    set.points.push_back({0, 0, 0, 0});
    set.points.back()[axis] = static_cast<double>(axis + 1);
  }
  const Figure figure = figure_of({set});
  EXPECT_TRUE(figure.circles.empty()) << "the circle would not be that of the ball";
  EXPECT_NE(figure.description.find("projected from dimension 4"), std::string::npos);
  EXPECT_EQ(figure.paths.back().lines.size(), 10U);
}

TEST(PointFigure, of_flat_simplices_and_single_points_has_no_ball) {
  const Figure flat = figure_of({{"s", true, {{0, 0}, {1, 0}, {2, 0}}}});
  EXPECT_TRUE(flat.circles.empty());
  const Figure one = figure_of({{"p", false, {{7, 7}}}});
  EXPECT_EQ(one.description, "the point p");
  ASSERT_EQ(one.names.size(), 1U);
  EXPECT_EQ(one.names[0].text, "p");
  for (const Figure& figure : {flat, one}) EXPECT_EQ(svg_of(figure).find("nan"), std::string::npos);
}

TEST(PointFigure, puts_sets_of_other_dimensions_side_by_side) {
  const Figure figure =
      figure_of({{"a", true, {{0, 0}, {1, 0}, {0, 1}}}, {"b", true, {{0}, {100}}}, {"c", false, {{5, 5}}}});
  EXPECT_FALSE(figure.scale) << "they have scales of their own";
  EXPECT_EQ(figure.description, "the simplex b; the simplex a, the point c");
  double rightmost_of_b = -10;
  double leftmost_of_a = 10;
  for (std::size_t at = 0; at < 2; ++at) rightmost_of_b = std::max(rightmost_of_b, figure.dots[at].centre[0]);
  for (std::size_t at = 2; at < figure.dots.size(); ++at)
    leftmost_of_a = std::min(leftmost_of_a, figure.dots[at].centre[0]);
  EXPECT_LT(rightmost_of_b, leftmost_of_a);
}

TEST(PointFigure, has_no_numbers_in_a_crowd) {
  DrawnSet crowd{"net", false, {}};
  for (int at = 0; at < 60; ++at) crowd.points.push_back({std::cos(at), std::sin(2 * at)});
  EXPECT_TRUE(figure_of({crowd}).names.empty());
  crowd.points.resize(30);
  EXPECT_EQ(figure_of({crowd}).names.size(), 30U);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
