#include "properties/instances/net_sample.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/properties/instances/square_net.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

template <int m>
Rational squared_distance(const Vector<Rational, m>& a, const Vector<Rational, m>& b) {
  const auto offset = difference(a, b);
  return pairing(offset, offset);
}

template <int m, class Draw>
void check_nets(const Draw& draw, std::uint32_t count) {
  for (std::uint32_t number = 0; number < count; ++number) {
    RandomChoices choices(1, m, number);
    const NetSample<m> net = draw(4, choices);
    EXPECT_EQ(net.points[0], (Vector<Rational, m>{}));
    Rational least(1000);
    for (std::size_t a = 0; a < net.points.size(); ++a) {
      for (std::size_t b = 0; b < a; ++b) least = minimum(least, squared_distance<m>(net.points[a], net.points[b]));
    }
    EXPECT_EQ(squared_separation<m>(net.points), least);
    EXPECT_GT(least, Rational(0));
    const NetObject object(coordinate_lists<m>(net.points), net.radius, Rational(4) * net.radius);
    ASSERT_TRUE(object.covering().has_value()) << number;
    EXPECT_LE(object.covering()->upper, net.radius * (Rational(1) + Rational::power_of_two(-20)));
  }
}

TEST(NetSample, is_a_net_of_the_radius_that_it_says) {
  check_nets<2>(draw_net<2>, 12);
  check_nets<3>(draw_net<3>, 2);
}

TEST(NetSample, a_nearly_degenerate_net_is_one_too_and_sheared_a_little) {
  check_nets<2>(draw_nearly_degenerate_net<2>, 8);
  check_nets<3>(draw_nearly_degenerate_net<3>, 2);
  int sheared = 0;
  for (std::uint32_t number = 0; number < 20; ++number) {
    RandomChoices choices(2, 2, number);
    const auto net = draw_nearly_degenerate_net<2>(2, choices);
    // (1, 0) is a point, and no point is right above the origin.
    EXPECT_NE(std::find(net.points.begin(), net.points.end(), Vector<Rational, 2>{Rational(1), Rational(0)}),
              net.points.end());
    sheared += std::none_of(net.points.begin() + 1, net.points.end(),
                            [](const auto& point) { return point[0] == Rational(0); })
                   ? 1
                   : 0;
  }
  EXPECT_GT(sheared, 10);
}

TEST(NetSample, moves_no_point_farther_than_the_length) {
  const auto points = square_vectors(4);
  const Rational length(Integer(1), Integer(7));
  const Vector<Rational, 2> centre{Rational(Integer(1), Integer(2)), Rational(Integer(1), Integer(2))};
  const auto greatest = [&](NetMotion motion) {
    Rational result(0);
    const auto moved = moved_points<2>(points, length, motion, centre, Rational(9), 5);
    for (std::size_t at = 0; at < points.size(); ++at) {
      result = maximum(result, squared_distance<2>(moved[at], points[at]));
    }
    return result;
  };
  EXPECT_EQ(greatest(NetMotion::none), Rational(0));
  EXPECT_EQ(greatest(NetMotion::axis), square(length));
  for (const NetMotion motion : {NetMotion::random, NetMotion::outward}) {
    EXPECT_LE(greatest(motion), square(length));
    EXPECT_GT(greatest(motion), square(length) / Rational(2));
  }
}

TEST(NetSample, outward_motion_enlarges_the_hole) {
  const auto points = square_vectors(4);
  const Vector<Rational, 2> centre{Rational(Integer(1), Integer(2)), Rational(Integer(1), Integer(2))};
  const auto moved = moved_points<2>(points, Rational::power_of_two(-3), NetMotion::outward, centre, Rational(1), 0);
  for (std::size_t at = 0; at < points.size(); ++at) {
    const Rational before = squared_distance<2>(points[at], centre);
    if (before <= Rational(1)) {
      EXPECT_GT(squared_distance<2>(moved[at], centre), before + Rational::power_of_two(-3));
    } else {
      EXPECT_EQ(moved[at], points[at]);
    }
  }
}

TEST(NetSample, centre_of_a_square) {
  const auto points = square_vectors(1);
  std::vector<std::uint32_t> cell;
  for (std::uint32_t at = 0; at < points.size(); ++at) {
    if (points[at][0] >= Rational(0) && points[at][1] >= Rational(0)) cell.push_back(at);
  }
  const Rational half(Integer(1), Integer(2));
  EXPECT_EQ(centre_of<2>(points, cell), (Vector<Rational, 2>{half, half}));
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
