#include "kernel/manifold/gluing/piecewise_values.hpp"

#include <gtest/gtest.h>

#include "kernel/manifold/gluing/chart_gluing.hpp"
#include "kernel/number/rounding_guard.hpp"
#include "kernel/number/scalar.hpp"
#include "tests/kernel/manifold/gluing/atlas_samples.hpp"
#include "tests/support/contains.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

/// (x, y) goes to (x + |y|/2, y).
const ChartGluing& fold() {
  static const ChartGluing gluing(
      two_charts(Rational(2), Rational(1), {0, 1, {"x + abs(y)/2", "y"}, {"u - abs(v)/2", "v"}, {}}));
  return gluing;
}

TEST(PiecewiseValues, takes_one_piece_for_doubles) {
  PiecewiseValues<double> map(fold().transitions()[0].pieces);
  for (const double y : {-0.5, 0.0, 0.75}) {
    const std::array<double, 2> x{0.25, y};
    std::array<double, 2> f{};
    std::array<double, 4> df{};
    ASSERT_TRUE(map.first(x.data(), f.data(), df.data()));
    EXPECT_EQ(f[0], 0.25 + std::abs(y) / 2);
    EXPECT_EQ(f[1], y);
    EXPECT_EQ(df[1], y < 0 ? -0.5 : 0.5);
    EXPECT_EQ(map.pieces_at(x.data()).size(), 1U);
  }
}

TEST(PiecewiseValues, encloses_all_pieces_that_a_box_meets) {
  const RoundingGuard guard;
  PiecewiseValues<Interval> map(fold().transitions()[0].pieces);
  const Cell across{Interval::between(0, 0.25), Interval::between(-0.5, 1), Interval(0)};
  std::array<Interval, 2> f;
  ASSERT_TRUE(map.value(across.data(), f.data()));
  for (const auto& x : {ratio(0, 1), ratio(1, 4), ratio(1, 2), ratio(3, 4)}) EXPECT_TRUE(contains(f[0], x));
  std::array<Interval, 4> df;
  ASSERT_TRUE(centred_derivative(map, across, 2, df.data()));
  EXPECT_EQ(df[0].lower(), 1);
  EXPECT_EQ(df[1].lower(), -0.5);
  EXPECT_EQ(df[1].upper(), 0.5);
  const Cell above{Interval::between(0, 0.25), Interval::between(0.5, 1), Interval(0)};
  ASSERT_TRUE(centred_derivative(map, above, 2, df.data()));
  EXPECT_EQ(df[1].lower(), 0.5);
  EXPECT_EQ(df[1].upper(), 0.5);
}

TEST(PiecewiseValues, is_sharp_with_big_floats_near_a_fold) {
  PiecewiseValues<BigInterval> map(fold().transitions()[0].pieces);
  const Rational little = Rational::power_of_two(-80);
  const std::array<BigInterval, 2> x{BigInterval(Rational(0)), BigInterval(-little)};
  EXPECT_EQ(map.pieces_at(x.data()), std::vector<std::size_t>{1});
  std::array<BigInterval, 2> f;
  ASSERT_TRUE(map.value(x.data(), f.data()));
  EXPECT_LE(f[0].lower(), little / Rational(2));
  EXPECT_GE(f[0].upper(), little / Rational(2));
  EXPECT_GT(f[0].lower(), Rational(0));
  // On the line itself both count.
  const std::array<BigInterval, 2> on_line{BigInterval(Rational(0)), BigInterval(Rational(0))};
  EXPECT_EQ(map.pieces_at(on_line.data()).size(), 2U);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
