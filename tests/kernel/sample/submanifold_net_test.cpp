#include "kernel/sample/submanifold_net.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "kernel/sample/separation.hpp"
#include "tests/kernel/manifold/submanifold/samples.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

TEST(SubmanifoldNet, is_a_maximal_poisson_disk_set) {
  const ZeroSet m = torus_of_revolution();
  const auto net = submanifold_net<2>(m, ratio(1, 12), 1, no_progress());
  EXPECT_LE(net.covering_radius, 0.0834);
  EXPECT_GE(net.covering_radius, 0.08);
  // Of the area 8π²: about 0.7 points a squared radius.
  EXPECT_GT(net.centres.size(), 6500U);
  EXPECT_LT(net.centres.size(), 9500U);
  const SubmanifoldAtlas<2> atlas(m, net.charts, ratio(1, 12), no_progress());
  EXPECT_GE(measure_separation<2>(atlas, no_progress()), ratio(98, 100));
  for (const auto& centre : net.centres) {
    for (const Rational& x : centre) EXPECT_LE(x.denominator(), Integer(1) << 36);
  }
}

TEST(SubmanifoldNet, is_the_same_for_a_seed) {
  const ZeroSet m = clifford_torus();
  const auto net = submanifold_net<2>(m, ratio(1, 8), 7, no_progress());
  EXPECT_EQ(net.centres, submanifold_net<2>(m, ratio(1, 8), 7, no_progress()).centres);
  EXPECT_NE(net.centres, submanifold_net<2>(m, ratio(1, 8), 8, no_progress()).centres);
}

TEST(SubmanifoldNet, finds_components_that_no_dart_goes_to) {
  // Newton's method goes to the small sphere from hardly anywhere.
  const ZeroSet m = zero_set("hidden", {"x", "y", "z"}, {"(x^2 + y^2 + z^2 - 1/64)*((x - 18)^2 + y^2 + z^2 - 1/400)"},
                             {Rational(20), Rational(20), Rational(20)});
  const auto net = submanifold_net<2>(m, ratio(1, 180), 1, no_progress());
  const auto on_small = std::count_if(net.centres.begin(), net.centres.end(),
                                      [](const auto& centre) { return centre[0] > Rational(10); });
  EXPECT_GT(on_small, 200);
  EXPECT_LT(on_small, static_cast<std::ptrdiff_t>(net.centres.size()));
}

TEST(SubmanifoldNet, says_what_is_wrong_and_where) {
  const auto attempt = [](const ZeroSet& m, const Rational& radius) {
    (void)submanifold_net<2>(m, radius, 1, no_progress());
  };
  const auto rejection = [&](const ZeroSet& m, const Rational& radius) {
    return message_of<Rejection>([&] { attempt(m, radius); });
  };
  const std::vector<Rational> cube(3, Rational(1));
  // No zeros; a singular point; a box that cuts; curvature.
  EXPECT_EQ(rejection(zero_set("none", {"x", "y", "z"}, {"x^2 + y^2 + z^2 + 1"}, cube), ratio(1, 10)),
            "none: no point of the box is a zero of the equations");
  EXPECT_TRUE(mentions(message_of<Undecided>([&] { attempt(cone(), ratio(1, 20)); }), "cone: undecided"));
  const ZeroSet cut =
      zero_set("cut", {"x", "y", "z"}, {"x^2 + y^2 + z^2 - 1"}, {ratio(3, 2), ratio(3, 2), ratio(9, 10)});
  EXPECT_TRUE(mentions(message_of<Undecided>([&] { attempt(cut, ratio(1, 10)); }),
                       "cut: undecided whether the manifold goes through the side of the box near ("));
  EXPECT_TRUE(mentions(rejection(unit_sphere_in_space(), ratio(1, 4)), "its patch is steeper than 1"));
  EXPECT_THROW(attempt(unit_sphere_in_space(), Rational(0)), InputError);
  // Everything is a zero: undecided, at a place.
  const std::string everything = message_of<Undecided>([&] {
    attempt(zero_set("everything", {"x", "y", "z"}, {"x*y - y*x"}, cube), ratio(1, 10));
  });
  EXPECT_TRUE(mentions(everything, "everything: undecided at the part of the box from (")) << everything;
  // A double sphere has no regular point.
  const ZeroSet twice = zero_set("double", {"x", "y", "z"}, {"(x^2 + y^2 + z^2 - 1/4)^2"}, cube);
  EXPECT_ANY_THROW(attempt(twice, ratio(1, 10)));
}

TEST(SubmanifoldSampling, follows_its_sizing_function_and_is_refined_where_it_is_told) {
  const ZeroSet m = unit_sphere_in_space();
  Sizing sizing(3, 0.1);
  sizing.add({{1, 0, 0}, 0.05, 0.125});
  SubmanifoldSampling<2> sampling(m, ratio(1, 10), sizing, 1);
  const auto net = sampling.complete(no_progress());
  EXPECT_TRUE(net.radii.vary());
  const auto radius_near = [](const SubmanifoldNet<2>& of, double x) {
    double least = 1;
    for (std::size_t label = 0; label < of.centres.size(); ++label) {
      if (std::fabs(approximate_double(of.centres[label][0]) - x) < 0.02)
        least = std::min(least, approximate_double(of.radii.of(label)));
    }
    return least;
  };
  EXPECT_LT(radius_near(net, 1), 0.06);
  EXPECT_GE(radius_near(net, 1), 0.05 * 0.999);
  EXPECT_GT(radius_near(net, -1), 0.099);
  EXPECT_GT(net.centres.size(), submanifold_net<2>(m, ratio(1, 10), 1, no_progress()).centres.size());
  const SubmanifoldAtlas<2> atlas(m, net.charts, net.radii, no_progress());
  EXPECT_GE(measure_separation<2>(atlas, no_progress()), ratio(3, 4));
  EXPECT_GT(radius_variation(net.charts.charts, net.radii), Rational(0));
  EXPECT_EQ(radius_variation(net.charts.charts, ratio(1, 10)), Rational(0));
  sampling.refine({{-1, 0, 0}});
  const auto refined = sampling.complete(no_progress());
  EXPECT_GT(refined.centres.size(), net.centres.size());
  EXPECT_LT(radius_near(refined, -1), 0.06);
}

TEST(RequireCover, names_the_part_that_is_left) {
  const ZeroSet m = unit_sphere_in_space();
  auto charts = submanifold_net<2>(m, ratio(1, 10), 1, no_progress()).charts.charts;
  EXPECT_GT(require_cover(m, charts, no_progress()), 0U);
  charts.erase(charts.begin(), charts.begin() + static_cast<std::ptrdiff_t>(charts.size() / 2));
  EXPECT_TRUE(mentions(message_of<Undecided>([&] { (void)require_cover(m, charts, no_progress()); }),
                       "sphere: undecided at the part of the box from ("));
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
