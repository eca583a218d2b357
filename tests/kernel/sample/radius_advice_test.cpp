#include "kernel/sample/radius_advice.hpp"

#include <gtest/gtest.h>

#include "kernel/sample/submanifold_net.hpp"
#include "tests/kernel/manifold/submanifold/mesh_samples.hpp"
#include "tests/kernel/manifold/submanifold/samples.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

std::optional<RadiusAdvice> advice_for(const EmbeddedManifold& m, const Rational& radius,
                                       const std::string& sizing = "") {
  return advise_radius(m, radius, sizing, {}, 1, no_progress());
}

TEST(RadiusAdvice, names_a_radius_at_which_charts_fit) {
  // The twin: at the radius that was tried they do not.
  const ZeroSet m = zero_set("cassini", {"x", "y", "z"}, {"((x - 1)^2 + y^2 + z^2)*((x + 1)^2 + y^2 + z^2) - 11/10"},
                             {Rational(2), Rational(2), Rational(2)});
  const auto net_of = [&](const Rational& radius) { return submanifold_net<2>(m, radius, 1, no_progress()); };
  EXPECT_THROW((void)net_of(ratio(1, 10)), TooCoarse);
  const auto advice = advice_for(m, ratio(1, 10));
  ASSERT_TRUE(advice);
  EXPECT_EQ(advice->sizing, "");
  // The greatest curvature is 4.53.
  EXPECT_LE(advice->radius, ratio(1, 28));
  EXPECT_GE(advice->radius, ratio(1, 50));
  const auto points = static_cast<double>(net_of(advice->radius).centres.size());
  EXPECT_NEAR(advice->points, points, points / 4);
}

TEST(RadiusAdvice, is_below_what_was_tried) {
  const ZeroSet m = unit_sphere_in_space();
  const auto first = advice_for(m, ratio(1, 2));
  ASSERT_TRUE(first);
  EXPECT_LE(first->radius, ratio(1, 8));
  EXPECT_GT(first->radius, ratio(1, 10));
  const auto second = advice_for(m, first->radius);
  ASSERT_TRUE(second);
  EXPECT_LE(second->radius, first->radius * ratio(7, 8));
}

TEST(RadiusAdvice, follows_the_curvature_where_one_radius_takes_many_points) {
  const ZeroSet m = zero_set("bretzel", {"x", "y", "z"}, {"(x^2*(1 - x^2) - y^2)^2 + z^2/2 - (1 + x^2 + y^2 + z^2)/40"},
                             {Rational(2), Rational(2), Rational(2)});
  auto advice = advice_for(m, ratio(1, 10));
  ASSERT_TRUE(advice);
  EXPECT_TRUE(advice->sizing.starts_with("curvature:1/1")) << advice->sizing;
  EXPECT_LT(advice->points, 200000);
  EXPECT_EQ(advice->radius.numerator(), Integer(1));
  // Once more, and after the last there is nothing that is known to be better.
  advice = advice_for(m, ratio(1, 10), "curvature:1/15,1/15");
  ASSERT_TRUE(advice);
  EXPECT_EQ(advice->sizing, "curvature:1/20,1/20");
  EXPECT_FALSE(advice_for(m, ratio(1, 10), "curvature:1/20,1/20"));
}

TEST(RadiusAdvice, is_not_given_where_nothing_is_known) {
  const ZeroSet none =
      zero_set("none", {"x", "y", "z"}, {"x^2 + y^2 + z^2 + 1"}, {Rational(1), Rational(1), Rational(1)});
  EXPECT_FALSE(advice_for(none, ratio(1, 10)));
  EXPECT_FALSE(advice_for(polyhedral_sphere(8), ratio(1, 2)));
}

TEST(RadiusAdvice, is_said_as_options) {
  EXPECT_EQ((RadiusAdvice{ratio(2, 65), "", 6184}).text(), "--radius 2/65 --refine 8 should do, with some 6100 points");
  EXPECT_EQ((RadiusAdvice{ratio(1, 4), "curvature:1/10,1/10", 24119}).text(),
            "--radius 1/4 --sizing curvature:1/10,1/10 --refine 8 should do, with some 24000 points");
  EXPECT_EQ((RadiusAdvice{ratio(1, 4), "", 7}).text(), "--radius 1/4 --refine 8 should do, with some 7 points");
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
