#include "kernel/sample/space_form_points.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "kernel/manifold/space_form_file.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

TEST(SpaceFormPoints, keep_their_distance) {
  SpaceFormPoints<2> points(verify_space_form(find_space_form("sphere-2")), 0.5);
  EXPECT_TRUE(points.insert({0.25, 0}, 0.3));
  EXPECT_FALSE(points.insert({0.25, 0.25}, 0.3));
  EXPECT_TRUE(points.insert({0.25, 0.5}, 0.3));
  EXPECT_TRUE(points.insert({0.25, 0.25}, 0));
  EXPECT_FALSE(points.insert({std::numeric_limits<double>::infinity(), 0}, 0));
  EXPECT_FALSE(points.insert({0, 0x1p30}, 0));
  EXPECT_EQ(points.size(), 3U);
}

TEST(SpaceFormPoints, are_seen_through_the_group) {
  // On the projective plane (y, 0) with |y| near the half-turn is close to its opposite: conformal 2 tan(d/2) = 2.
  SpaceFormPoints<2> points(verify_space_form(find_space_form("projective-plane")), 0.5);
  ASSERT_TRUE(points.insert({1.9, 0}, 0.1));
  EXPECT_FALSE(points.insert({-1.9, 0}, 0.2));
  ASSERT_TRUE(points.insert({-1.9, 0}, 0.01));
  std::vector<Vector<double, 2>> around;
  points.look_about(0, around);
  ASSERT_EQ(around.size(), 1U);
  // The distance is π − 4 arctan(1.9/2).
  const double distance = 3.14159265358979323846 - 4 * std::atan(0.95);
  EXPECT_NEAR(std::sqrt(pairing(around[0], around[0])), 2 * std::tan(distance / 2), 1e-12);
  // And from the label it is at those coordinates.
  const auto back = points.at(0, around[0]);
  EXPECT_NEAR(back[0], -1.9, 1e-12);
  EXPECT_NEAR(back[1], 0, 1e-12);
}

/// A candidate is compared with what was there when it was made, and at its turn with what is new.
TEST(SpaceFormPoints, come_in_rounds) {
  // On the projective plane (y, 0) with |y| near 2 is close to its opposite.
  SpaceFormPoints<2> points(verify_space_form(find_space_form("projective-plane")), 0.5);
  ASSERT_TRUE(points.insert({1.9, 0}, 0.1));
  EXPECT_FALSE(points.candidate({-1.9, 0}, 0.2).has_value());
  EXPECT_FALSE(points.candidate({0, 0x1p30}, 0).has_value());
  const auto first = points.candidate({0, 1.9}, 0.2);
  const auto second = points.candidate({0, -1.9}, 0.2);
  const auto third = points.candidate({0.25, 0}, 0.2);
  ASSERT_TRUE(first && second && third);
  points.begin_round();
  EXPECT_FALSE(points.has_new_about(0));
  EXPECT_TRUE(points.insert_candidate(*first, 0.2));
  EXPECT_FALSE(points.insert_candidate(*second, 0.2));  // the group takes it next to the first one
  EXPECT_FALSE(points.has_new_about(0));
  EXPECT_TRUE(points.has_new_about(1));
  EXPECT_TRUE(points.insert_candidate(*third, 0.2));
  EXPECT_EQ(points.size(), 3U);
  points.begin_round();
  EXPECT_FALSE(points.has_new_about(1));
  const auto near_the_first = points.candidate({1.85, 0}, 0.01);
  ASSERT_TRUE(near_the_first);
  EXPECT_TRUE(points.insert_candidate(*near_the_first, 0.01));
  EXPECT_TRUE(points.has_new_about(0));
  EXPECT_FALSE(points.has_new_about(1));
}

TEST(SpaceFormPoints, are_put_in_order_and_exact) {
  SpaceFormPoints<2> points(verify_space_form(find_space_form("klein-bottle")), 0.3);
  for (const double x : {0.25, -0.25, 0.125, -0.125}) EXPECT_TRUE(points.insert({x, -x}, 0));
  const auto ordered = points.ordered();
  ASSERT_EQ(ordered.size(), 4U);
  // By cells of the plane, those with the lower second coordinate first.
  EXPECT_EQ(ordered[0][1], Rational::exactly(-0.125));
  EXPECT_EQ(ordered[1][1], Rational::exactly(-0.25));
  EXPECT_EQ(ordered[2][1], Rational::exactly(0.125));
  EXPECT_EQ(ordered[3][1], Rational::exactly(0.25));
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
