#include "kernel/chart/length_units.hpp"

#include "kernel/manifold/submanifold/submanifold_atlas.hpp"
#include "tests/kernel/manifold/submanifold/samples.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

/// Charts at both poles of the unit sphere.
SubmanifoldAtlas<2> poles(const SamplingRadii& radii) {
  ChartData south = polar_chart(ratio(1, 4), ratio(1, 4)).data();
  south.centre[2] = Rational(-1);
  south.preconditioner = {ratio(-1, 2)};
  FittedCharts charts;
  charts.charts = {polar_chart(ratio(1, 4), ratio(1, 4)), TangentChart(south, 2)};
  charts.slope = ratio(1, 2);
  charts.patch_factor = 3;
  return {unit_sphere_in_space(), std::move(charts), radii, no_progress()};
}

TEST(LengthUnits, are_parts_of_the_greatest_radius) {
  const LengthUnits units(poles(SamplingRadii(std::vector<double>{0.0625, 0.08})));
  EXPECT_TRUE(units.vary());
  EXPECT_EQ(units.of(Label(1)), 1);
  EXPECT_LE(units.of(Label(0)), 0.0625 / 0.08 * (1 + 0x1p-10));
  EXPECT_GE(units.of(Label(0)), 0.0625 / 0.08 * (1 - 0x1p-10));
  // On the safe side, and not by more than it takes.
  const double unit = units.of(Label(0));
  const auto product = [&](double x) { return Rational::exactly(x) * Rational::exactly(unit); };
  EXPECT_LT(product(units.lower(Label(0), 0.1)), Rational::exactly(0.1));
  EXPECT_GT(product(units.upper(Label(0), 0.1)), Rational::exactly(0.1));
  EXPECT_LE(units.upper(Label(0), 0.1) - units.lower(Label(0), 0.1), 0x1p-50);
}

TEST(LengthUnits, are_1_where_radii_are_the_same) {
  const LengthUnits units(poles(ratio(1, 10)));
  EXPECT_FALSE(units.vary());
  EXPECT_EQ(units.of(Label(1)), 1);
  EXPECT_EQ(units.lower(Label(0), 0.1), 0.1);
  EXPECT_EQ(units.upper(Label(0), 0.1), 0.1);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
