#include "properties/instances/net_object.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/properties/instances/square_net.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

TEST(NetObject, encloses_the_covering_radius_of_the_square_lattice) {
  const NetObject net(square_points(6), Rational(1), Rational(2));
  ASSERT_TRUE(net.covering().has_value());
  // √2/2.
  EXPECT_LE(square(net.covering()->lower), Rational(Integer(1), Integer(2)));
  EXPECT_GT(square(net.covering()->upper), Rational(Integer(1), Integer(2)));
  EXPECT_LT(net.covering()->upper - net.covering()->lower, Rational::power_of_two(-20));
}

TEST(NetObject, has_no_covering_radius_where_the_points_do_not_reach_beyond_the_ball) {
  EXPECT_FALSE(NetObject(square_points(2), Rational(1), Rational(4)).covering().has_value());
  EXPECT_FALSE(NetObject(square_points(2), Rational(1), Rational(0)).covering().has_value());
}

TEST(NetObject, reads_back_what_it_wrote) {
  auto points = square_points(4);
  points[3][0] += Rational(Integer(1), Integer(3));
  const NetObject net(points, Rational(Integer(5), Integer(7)), Rational(0));
  const auto again = NetObject::read(net.json());
  const auto& read = dynamic_cast<const NetObject&>(*again);
  EXPECT_EQ(read.points(), points);
  EXPECT_EQ(read.sampling_radius(), net.sampling_radius());
  EXPECT_EQ(read.ball_radius(), Rational(0));
  EXPECT_EQ(read.json(), net.json());
}

TEST(NetObject, refuses_what_is_no_net) {
  auto points = square_points(2);
  EXPECT_THROW(NetObject({}, Rational(1), Rational(0)), InputError);
  EXPECT_THROW(NetObject(points, Rational(0), Rational(0)), InputError);
  EXPECT_THROW(NetObject(points, Rational(1), Rational(-1)), InputError);
  points[1] = points[2];
  EXPECT_THROW(NetObject(points, Rational(1), Rational(0)), InputError);
  points[1] = {Rational(1)};
  EXPECT_THROW(NetObject(points, Rational(1), Rational(0)), InputError);
  EXPECT_THROW((void)NetObject::read(nlohmann::ordered_json::parse(R"({"points": [], "ball_radius": "0"})")),
               InputError);
  EXPECT_THROW((void)NetObject::read(nlohmann::ordered_json::parse(R"({"points": 1})")), InputError);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
