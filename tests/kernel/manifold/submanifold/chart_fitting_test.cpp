#include "kernel/manifold/submanifold/chart_fitting.hpp"

#include "kernel/manifold/submanifold/graph_check.hpp"
#include "tests/kernel/manifold/submanifold/samples.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

TEST(FitCharts, takes_the_greatest_patches_that_are_graphs) {
  const std::vector<std::vector<Rational>> centres{{Rational(0), Rational(0), Rational(1)},
                                                   {ratio(3, 5), ratio(-4, 5), Rational(0)}};
  const ZeroSet m = unit_sphere_in_space();
  const auto factor = [&](const Rational& radius) {
    return fit_charts(m, centres, radius, no_progress()).patch_factor;
  };
  // L = 1.25·ϱ/(1 − 9Lϱ/16) ≤ 1 has a solution up to ϱ = 0.55, with 1.1 up to 0.6.
  EXPECT_EQ(factor(ratio(1, 10)), 5);
  EXPECT_EQ(factor(ratio(112, 1000)), ratio(19, 4));
  EXPECT_EQ(factor(ratio(12, 100)), ratio(9, 2));
  EXPECT_EQ(factor(ratio(13, 100)), ratio(9, 2));
  EXPECT_EQ(factor(ratio(137, 1000)), 4);
  EXPECT_EQ(factor(ratio(19, 100)), 3);
  const std::string refusal = message_of<Rejection>([&] { (void)factor(ratio(1, 4)); });
  EXPECT_TRUE(mentions(refusal, "): its patch is steeper than 1: there")) << refusal;
  EXPECT_TRUE(mentions(refusal, "a sampling radius of some 0.12 would do")) << refusal;
  const auto fitted = fit_charts(m, centres, ratio(9, 100), no_progress());
  for (const TangentChart& chart : fitted.charts) {
    EXPECT_EQ(chart.data().radius, ratio(45, 100));
    EXPECT_GT(chart.data().height, ratio(9, 16) * fitted.slope * chart.data().radius);
    EXPECT_TRUE(GraphCheck(m).may_be_as_high(chart));
    TangentChart higher = chart;
    higher.set_size(chart.data().radius, Rational(1));
    EXPECT_FALSE(GraphCheck(m).may_be_as_high(higher));
    EXPECT_FALSE(GraphCheck(m).failure(chart, fitted.slope).has_value());
  }
}

TEST(DistortionOfSlope, is_an_upper_bound_with_few_digits) {
  EXPECT_EQ(distortion_of_slope(Rational(0)), Rational(0));
  for (const Rational& slope : {ratio(1, 1000), ratio(1, 3), Rational(1)}) {
    const Rational bound = distortion_of_slope(slope);
    EXPECT_GE(square(Rational(1) + bound), Rational(1) + square(slope));
    EXPECT_LT(square(Rational(1) + bound * ratio(99, 100)), Rational(1) + square(slope));
  }
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
