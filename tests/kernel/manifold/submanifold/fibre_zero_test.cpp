#include "kernel/manifold/submanifold/fibre_zero.hpp"

#include "kernel/number/rounding_guard.hpp"
#include "tests/kernel/manifold/submanifold/samples.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

std::optional<std::vector<Interval>> heights_over(const ZeroSet& m, const TangentChart& chart, const Rational& y0,
                                                  const Rational& y1) {
  FormulaEvaluation<Interval> f(m.map());
  const std::vector<Interval> y{scalar_from<Interval>(y0), scalar_from<Interval>(y1)};
  return zero_on_fibre<Interval>(f, chart.enclosed(), y.data());
}

TEST(ZeroOnFibre, encloses_the_exact_heights_of_a_sphere) {
  const RoundingGuard guard;
  const ZeroSet m = unit_sphere_in_space();
  const TangentChart chart = polar_chart(Rational(1), Rational(1));
  const auto heights = heights_over(m, chart, ratio(3, 5), Rational(0)).value();
  EXPECT_LE(Rational::exactly(heights[0].lower()), ratio(-1, 5));
  EXPECT_GE(Rational::exactly(heights[0].upper()), ratio(-1, 5));
  EXPECT_LE(heights[0].upper() - heights[0].lower(), 1e-14);
  EXPECT_TRUE(heights_over(m, chart, Rational(0), Rational(0)));
  // Beyond the equator there is nothing, and on it the fibre is tangent.
  EXPECT_FALSE(heights_over(m, chart, ratio(11, 10), Rational(0)));
  EXPECT_FALSE(heights_over(m, chart, Rational(1), Rational(0)));
}

TEST(ZeroOnFibre, is_as_narrow_as_the_precision_asks_for) {
  const ZeroSet m = unit_sphere_in_space();
  const TangentChart chart = polar_chart(Rational(1), Rational(1));
  for (const unsigned bits : {128U, 512U}) {
    const BigInterval::Precision precision(PrecisionBits{bits});
    FormulaEvaluation<BigInterval> f(m.map());
    const std::vector<BigInterval> y{BigInterval(ratio(-3, 13)), BigInterval(ratio(4, 13))};
    const auto heights = zero_on_fibre<BigInterval>(f, chart.on<BigInterval>(), y.data()).value();
    EXPECT_LE(heights[0].lower(), ratio(12, 13) - Rational(1));
    EXPECT_GE(heights[0].upper(), ratio(12, 13) - Rational(1));
    EXPECT_LE(heights[0].upper() - heights[0].lower(), Rational::power_of_two(8 - static_cast<long>(bits)));
  }
}

TEST(ZeroOnFibre, holds_for_all_of_an_interval_of_coordinates) {
  const RoundingGuard guard;
  const ZeroSet m = unit_sphere_in_space();
  const TangentChart chart = polar_chart(Rational(1), Rational(1));
  FormulaEvaluation<Interval> f(m.map());
  const std::vector<Interval> y{Interval::between(0.59, 0.61), Interval(0)};
  const auto heights = zero_on_fibre<Interval>(f, chart.enclosed(), y.data()).value();
  for (const double end : {0.59, 0.6, 0.61}) {
    const auto there = heights_over(m, chart, Rational::exactly(end), Rational(0)).value();
    EXPECT_LE(heights[0].lower(), there[0].lower());
    EXPECT_GE(heights[0].upper(), there[0].upper());
  }
}

TEST(ZeroOnFibre, is_none_where_zeros_are_double) {
  const RoundingGuard guard;
  const ZeroSet m =
      zero_set("double", {"x", "y", "z"}, {"(x^2 + y^2 + z^2 - 1)^2"}, std::vector<Rational>(3, Rational(2)));
  EXPECT_FALSE(heights_over(m, polar_chart(Rational(1), Rational(1)), ratio(3, 5), Rational(0)));
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
