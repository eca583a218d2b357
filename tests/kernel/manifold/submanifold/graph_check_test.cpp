#include "kernel/manifold/submanifold/graph_check.hpp"

#include "tests/kernel/manifold/submanifold/samples.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

std::string failure_of(const ZeroSet& m, const TangentChart& chart, const Rational& slope) {
  const auto failure = GraphCheck(m).failure(chart, slope);
  return failure ? failure->reason : "";
}

TEST(GraphCheck, accepts_a_cap_of_a_sphere_and_knows_how_steep_it_is) {
  const ZeroSet m = unit_sphere_in_space();
  const Rational radius = ratio(3, 10);
  EXPECT_EQ(failure_of(m, polar_chart(radius, ratio(1, 8)), ratio(2, 5)), "");
  // Its rim has the slope 0.3145…, and level sets in the bent cone more.
  const auto failure = GraphCheck(m).failure(polar_chart(radius, ratio(1, 8)), ratio(30, 100));
  ASSERT_TRUE(failure);
  EXPECT_TRUE(failure->is_slope);
}

TEST(GraphCheck, refuses_a_lid_that_is_too_low) {
  const ZeroSet m = unit_sphere_in_space();
  EXPECT_EQ(failure_of(m, polar_chart(ratio(3, 10), ratio(675, 10000)), ratio(2, 5)),
            "the lid of its patch is too low");
  EXPECT_EQ(failure_of(m, polar_chart(ratio(3, 10), ratio(676, 10000)), ratio(2, 5)), "");
}

TEST(GraphCheck, refuses_a_patch_that_touches_the_box) {
  const auto with_lid = [](const Rational& half) {
    return zero_set("sphere", {"x", "y", "z"}, {"x^2 + y^2 + z^2 - 1"}, {ratio(3, 2), ratio(3, 2), half});
  };
  const TangentChart chart = polar_chart(ratio(3, 10), ratio(1, 8));
  EXPECT_EQ(failure_of(with_lid(ratio(9, 8)), chart, ratio(2, 5)), "its patch is not inside of the box, across z");
  EXPECT_EQ(failure_of(with_lid(ratio(10, 8)), chart, ratio(2, 5)), "");
}

TEST(GraphCheck, refuses_two_sheets_in_one_cylinder) {
  // Concentric spheres.
  const auto sheets = [](const std::string& other) {
    return zero_set("sheets", {"x", "y", "z"}, {"(x^2 + y^2 + z^2 - 1)*(x^2 + y^2 + z^2 - " + other + ")"},
                    std::vector<Rational>(3, Rational(3)));
  };
  ChartData data = polar_chart(ratio(1, 5), ratio(1, 8)).data();
  const auto chart = [&](const Rational& derivative) {
    data.preconditioner = {Rational(1) / derivative};
    return TangentChart(data, 2);
  };
  EXPECT_EQ(failure_of(sheets("121/100"), chart(ratio(-42, 100)), ratio(2, 5)),
            "its patch is no graph: fibres are not transversal");
  EXPECT_EQ(failure_of(sheets("9"), chart(Rational(-16)), ratio(2, 5)), "");
}

TEST(GraphCheck, refuses_a_tilted_chart_and_one_without_a_point) {
  const ZeroSet m = unit_sphere_in_space();
  ChartData data = polar_chart(ratio(3, 10), ratio(1, 8)).data();
  data.skew[1] = ratio(1, 16);
  EXPECT_NE(failure_of(m, TangentChart(data, 2), ratio(2, 5)), "");
  EXPECT_EQ(failure_of(m, TangentChart(data, 2), ratio(1, 1)), "the lid of its patch is too low");
  data = polar_chart(ratio(3, 10), ratio(1, 8)).data();
  data.centre[0] = Rational(1);
  EXPECT_EQ(failure_of(m, TangentChart(data, 2), ratio(2, 5)), "no point of the manifold is certain over its centre");
}

/// The product of three unit circles in ℝ⁶, in the chart about a point, turned a little.
TangentChart chart_of_three_circles(const Rational& radius, const Rational& height) {
  ChartData data;
  for (const int coordinate : {1, 0, 1, 0, 1, 0}) data.centre.emplace_back(coordinate);
  data.columns = {2, 4, 6, 1, 3, 5};
  data.skew.assign(15, Rational(0));
  data.skew[0] = data.skew[7] = ratio(1, 4096);
  for (std::size_t entry = 0; entry < 9; ++entry) data.preconditioner.push_back(ratio(entry % 4 == 0 ? 1 : 0, 2));
  data.radius = radius;
  data.height = height;
  return TangentChart(data, 3);
}

TEST(GraphCheck, decides_a_wide_patch_in_codimension_3_at_once) {
  const ZeroSet m =
      zero_set("three-circles", {"a", "b", "c", "d", "e", "f"}, {"a^2 + b^2 - 1", "c^2 + d^2 - 1", "e^2 + f^2 - 1"},
               std::vector<Rational>(6, Rational(3)));
  // ϱ < L(1 − 9Lϱ/16) = 0.514 with L = 5/8: of a sphere of any dimension, and of a product of spheres.
  const Rational radius = ratio(1, 2);
  EXPECT_EQ(failure_of(m, chart_of_three_circles(radius, ratio(1, 4)), ratio(5, 8)), "");
  EXPECT_TRUE(GraphCheck(m).may_be_as_high(chart_of_three_circles(radius, ratio(1, 2))));
  // At the rim slopes are 0.577…, in the bent cone more.
  const auto failure = GraphCheck(m).failure(chart_of_three_circles(radius, ratio(1, 4)), ratio(4, 8));
  ASSERT_TRUE(failure);
  EXPECT_TRUE(failure->is_slope);
  // The other half of each circle.
  EXPECT_FALSE(GraphCheck(m).may_be_as_high(chart_of_three_circles(radius, Rational(1))));
}

TEST(GraphCheck, does_not_count_that_normals_turn_among_themselves) {
  // Pairs of orthogonal unit vectors.
  const ZeroSet m = zero_set("stiefel", {"a", "b", "c", "d", "e", "f"},
                             {"a^2 + b^2 + c^2 - 1", "d^2 + e^2 + f^2 - 1", "2*(a*d + b*e + c*f)"},
                             std::vector<Rational>(6, Rational(3)));
  FormulaEvaluation<double> f(m.map());
  TangentChart chart =
      tangent_chart(m, f, {Rational(1), Rational(0), Rational(0), Rational(0), Rational(1), Rational(0)});
  // D²z and the symmetric part of D²f[N, N] have the norm √(3/2), D²f[N, E] has 1/√2 and is orthogonal to D²z: at the
  // rim (3ϱ²/2 + h²/2)^½ < L(1 − √(3/2)·h), h = 9Lϱ/16, here 0.56 < 0.67.
  chart.set_size(ratio(7, 16), ratio(1, 4));
  EXPECT_EQ(failure_of(m, chart, ratio(15, 16)), "");
  const auto failure = GraphCheck(m).failure(chart, ratio(9, 16));
  ASSERT_TRUE(failure);
  EXPECT_TRUE(failure->is_slope);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
