#include "proofs/certificate/delaunay_margin.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "tests/support/ratio.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

TEST(DelaunayMargin, is_what_the_formula_says) {
  // s = 2, h = 3.
  const StarMargins stars{Rational(1), ratio(1, 2), Rational(1)};
  const DelaunayMargin plane = delaunay_margin(Dimension(2), ratio(1, 3), stars, Rational(2));
  EXPECT_EQ(plane.change, Rational(27));
  EXPECT_EQ(plane.allowed, Rational(3));
  EXPECT_EQ(plane.value(), Rational(-24));
  EXPECT_EQ(plane.edge, Rational(2));
  EXPECT_EQ(delaunay_margin(Dimension(3), ratio(1, 3), stars, Rational(2)).change, Rational(28));
}

TEST(DelaunayMargin, of_an_exact_chart_is_all_that_is_allowed) {
  const StarMargins stars{ratio(1, 7), ratio(1, 5), Rational(1)};
  EXPECT_EQ(delaunay_margin(Dimension(3), Rational(0), stars, ratio(6, 7)).value(), ratio(1, 7));
}

TEST(DelaunayMargin, falls_with_distortion_and_radius_and_grows_with_the_rest) {
  const StarMargins stars{ratio(1, 20), ratio(1, 8), Rational(1)};
  const auto value = [](const Rational& kappa, const StarMargins& margins, const Rational& edge) {
    return delaunay_margin(Dimension(2), kappa, margins, edge).value();
  };
  const Rational kappa = ratio(1, 2000), edge = ratio(9, 10);
  const Rational usual = value(kappa, stars, edge);
  EXPECT_LT(value(ratio(1, 1000), stars, edge), usual);
  EXPECT_LT(value(kappa, {stars.protection, stars.thickness, ratio(11, 10)}, edge), usual);
  EXPECT_GT(value(kappa, {ratio(1, 19), stars.thickness, Rational(1)}, edge), usual);
  EXPECT_GT(value(kappa, {stars.protection, ratio(1, 7), Rational(1)}, edge), usual);
  EXPECT_GT(value(kappa, stars, Rational(1)), usual);
}

/// The largest set of points of the hexagonal lattice, of edge 1, whose distances from a place differ, squared, by no
/// more than h from the least.
std::size_t most_nearly_nearest(double h) {
  std::size_t most = 0;
  for (int column = 0; column < 60; ++column) {
    for (int row = 0; row < 60; ++row) {
      const double a = column / 60.0, b = row / 60.0;
      std::vector<double> squares;
      for (int i = -2; i <= 3; ++i) {
        for (int j = -2; j <= 3; ++j) squares.push_back((i - a) * (i - a) + (i - a) * (j - b) + (j - b) * (j - b));
      }
      const double least = *std::min_element(squares.begin(), squares.end());
      const auto count = std::count_if(squares.begin(), squares.end(), [&](double x) { return x <= least + h; });
      most = std::max(most, static_cast<std::size_t>(count));
    }
  }
  return most;
}

/// What the margin is for: sets of points whose powers the metric may make equal are simplices. With protection 0.57,
/// thickness 0.43, circumradius 0.578, edge 1.
TEST(DelaunayMargin, leaves_the_triangles_of_a_lattice) {
  const StarMargins stars{ratio(57, 100), ratio(43, 100), ratio(578, 1000)};
  const auto margin = [&](const Rational& kappa) { return delaunay_margin(Dimension(2), kappa, stars, Rational(1)); };
  const Rational kappa = ratio(7, 100);
  EXPECT_GT(margin(kappa).value(), Rational(0));
  EXPECT_LT(margin(ratio(2, 25)).value(), Rational(0));
  const Rational h = Rational(4) * kappa * square(stars.circumradius / (Rational(1) - kappa));
  EXPECT_EQ(most_nearly_nearest(approximate_double(h)), 3U);
  EXPECT_GT(most_nearly_nearest(0.51), 3U);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
