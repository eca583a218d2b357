#include "kernel/theorems/blend_volume.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "kernel/number/rounding_guard.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

template <int m>
constexpr auto n = static_cast<std::size_t>(m);
template <int m>
using Point = std::array<double, n<m>>;
template <int m>
using Weights = std::array<double, n<m> + 1>;

template <int m>
FormulaMap inversion() {
  if constexpr (m == 2) return FormulaMap({"x", "y"}, {"x/(x^2+y^2)", "y/(x^2+y^2)"});
  return FormulaMap({"x", "y", "z"}, {"x/(x^2+y^2+z^2)", "y/(x^2+y^2+z^2)", "z/(x^2+y^2+z^2)"});
}

double determinant_of(const std::array<Point<2>, 2>& a) { return a[0][0] * a[1][1] - a[0][1] * a[1][0]; }
double determinant_of(const std::array<Point<3>, 3>& a) {
  double sum = 0;
  for (std::size_t k = 0; k < 3; ++k)
    sum += a[0][k] * (a[1][(k + 1) % 3] * a[2][(k + 2) % 3] - a[1][(k + 2) % 3] * a[2][(k + 1) % 3]);
  return sum;
}

/// The blend of a simplex in doubles, and its derivative by differences.
template <int m>
struct Blend {
  FormulaEvaluation<double>& map;
  std::array<Point<m>, n<m> + 1> x;
  std::array<bool, n<m> + 1> is_first;

  [[nodiscard]] Point<m> carried(const Point<m>& at) const {
    Point<m> there{};
    EXPECT_TRUE(map.value(at.data(), there.data()));
    return there;
  }
  [[nodiscard]] Point<m> at(const Weights<m>& t) const {
    Point<m> here{};
    Point<m> there{};
    double share = 0;
    for (std::size_t v = 0; v <= n<m>; ++v) {
      here = sum(here, scaled(t[v], x[v]));
      there = sum(there, scaled(t[v], carried(x[v])));
      share += is_first[v] ? t[v] : 0;
    }
    return sum(there, scaled(share, difference(carried(here), there)));
  }
  /// What it makes of volumes: by the ratio of two simplices, a small one at these coordinates and the large one.
  [[nodiscard]] double volume_at(const Weights<m>& t) const {
    constexpr double step = 1e-5;
    std::array<Point<m>, n<m>> small;
    std::array<Point<m>, n<m>> large;
    for (std::size_t v = 1; v <= n<m>; ++v) {
      Weights<m> ahead = t;
      Weights<m> behind = t;
      ahead[v] += step;
      ahead[0] -= step;
      behind[v] -= step;
      behind[0] += step;
      small[v - 1] = scaled(1 / (2 * step), difference(at(ahead), at(behind)));
      large[v - 1] = difference(carried(x[v]), carried(x[0]));
    }
    return determinant_of(small) / determinant_of(large);
  }
  [[nodiscard]] double least_volume() const {
    double least = 1;
    constexpr int parts = 8;
    for (int a = 0; a <= parts; ++a) {
      for (int b = 0; a + b <= parts; ++b) {
        for (int c = 0; a + b + c <= parts; ++c) {
          if (m == 2 && c > 0) continue;
          Weights<m> t{};
          t[0] = static_cast<double>(a) / parts;
          t[1] = static_cast<double>(b) / parts;
          t[n<m> - 1] += static_cast<double>(c) / parts;
          t[n<m>] += static_cast<double>(parts - a - b - c) / parts;
          least = std::min(least, volume_at(t));
        }
      }
    }
    return least;
  }
};

template <int m>
TwoHomes<m> enclosed(const Blend<m>& blend) {
  TwoHomes<m> result;
  result.is_first = blend.is_first;
  for (std::size_t v = 0; v <= n<m>; ++v) {
    const Point<m> there = blend.carried(blend.x[v]);
    for (std::size_t axis = 0; axis < n<m>; ++axis) {
      result.here[v][axis] = Interval::exactly(blend.x[v][axis]);
      result.there[v][axis] = Interval::between(there[axis] - 1e-14, there[axis] + 1e-14);
    }
  }
  return result;
}

template <int m>
void expect_bounds_of_inversions() {
  const FormulaMap map = inversion<m>();
  FormulaEvaluation<double> in_doubles(map);
  std::mt19937_64 random(m);
  std::uniform_real_distribution<double> side(-0.08, 0.08);
  int found = 0;
  int thin = 0;
  for (int round = 0; round < 60; ++round) {
    Blend<m> blend{in_doubles, {}, {}};
    for (std::size_t v = 0; v <= n<m>; ++v) {
      for (double& coordinate : blend.x[v]) coordinate = side(random);
      if (round % 2 == 1) blend.x[v][1] /= 8;
      blend.x[v][0] += 1;
      blend.is_first[v] = v == 0 || (v == 1 && round % 3 == 0);
    }
    const double truth = blend.least_volume();
    const RoundingGuard guard;
    FormulaEvaluation<Interval> evaluation(map);
    const double bound = blend_volume_below<m>(enclosed(blend), evaluation, 0.5);
    EXPECT_LE(bound, std::max(truth, 0.0) + 1e-4);
    if (truth > 0.6) {
      EXPECT_GE(bound, 0.5);
      ++found;
      if (round % 2 == 1) ++thin;
    }
  }
  EXPECT_GT(found, 30);
  EXPECT_GT(thin, 10);
}

TEST(BlendVolume, is_bounded_by_what_points_have_and_found_where_it_is_large) {
  expect_bounds_of_inversions<2>();
  expect_bounds_of_inversions<3>();
}

/// (x, y) goes to (x, y + x²): the triangle with the corners (±1, 0) and (0, height) to one with (±1, 1) and the same.
double bound_of_bent_triangle(double height, std::array<bool, 3> is_first, double enough, double* truth = nullptr) {
  const FormulaMap map({"x", "y"}, {"x", "y+x^2"});
  FormulaEvaluation<double> in_doubles(map);
  const Blend<2> blend{in_doubles, {Point<2>{-1, 0}, Point<2>{1, 0}, Point<2>{0, height}}, is_first};
  if (truth != nullptr) *truth = blend.least_volume();
  const RoundingGuard guard;
  FormulaEvaluation<Interval> evaluation(map);
  return blend_volume_below<2>(enclosed(blend), evaluation, enough);
}

TEST(BlendVolume, is_not_found_where_the_other_chart_turns_the_triangle_over) {
  for (const auto& first : {std::array<bool, 3>{true, false, false}, std::array<bool, 3>{false, false, true}}) {
    EXPECT_EQ(bound_of_bent_triangle(0.5, first, 0x1p-10), 0);
    EXPECT_EQ(bound_of_bent_triangle(0.75, first, 0x1p-10), 0);
  }
}

TEST(BlendVolume, is_not_found_where_the_blend_folds_though_both_charts_agree) {
  // The parabola is above the straight edge between the first two corners by up to 1, and the third corner is near.
  double truth = 1;
  const std::array<bool, 3> first = {true, true, false};
  EXPECT_EQ(bound_of_bent_triangle(-0.125, first, 0x1p-10, &truth), 0);
  EXPECT_LT(truth, 0);
  EXPECT_GT(bound_of_bent_triangle(-8, first, 0x1p-10, &truth), 0.25);
  EXPECT_GT(truth, 0.25);
}

TEST(BlendVolume, is_not_found_where_the_map_is_not_defined) {
  const FormulaMap map = inversion<2>();
  FormulaEvaluation<double> in_doubles(map);
  const Blend<2> blend{in_doubles, {Point<2>{-1, -0.5}, Point<2>{1, -0.5}, Point<2>{0, 1}}, {true, false, false}};
  const RoundingGuard guard;
  FormulaEvaluation<Interval> evaluation(map);
  EXPECT_EQ(blend_volume_below<2>(enclosed(blend), evaluation, 0x1p-10), 0);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
