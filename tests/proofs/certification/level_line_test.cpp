#include "proofs/certification/level_line.hpp"

#include <gtest/gtest.h>

namespace delcert {
namespace DELCERT_THIS_FILE {

Rational ratio(int numerator, int denominator) { return Rational(Integer(numerator), Integer(denominator)); }

const Rational unit(Integer(1), Integer(10));

TEST(LevelLine, of_the_input_says_which_hypotheses_or_the_density) {
  Claims claims;
  claims.input.emplace().hypotheses_2 = false;
  EXPECT_EQ(level_line(claims, "0", unit), "input: net, Hypotheses 1");
  claims.input->hypotheses_2 = true;
  EXPECT_EQ(level_line(claims, "0", unit), "input: net, Hypotheses 1, Hypotheses 2");
  claims.input->constraints = ParameterConstraints::sharper;
  EXPECT_EQ(level_line(claims, "0", unit), "input: net, Hypotheses 1, the sharper Hypotheses 2");
  claims.input = InputClaim{{}, InputClaim::Density{ratio(1, 8), Rational(0), Rational(0)}, {}};
  EXPECT_EQ(level_line(claims, "0", unit), "input: every point is within 1.250e+00 ε of the net");
}

TEST(LevelLine, of_level_4_says_by_which_route) {
  Claims claims;
  claims.delaunay.emplace();
  EXPECT_EQ(level_line(claims, "4", unit),
            "Delaunay: the complex is the Delaunay complex of the points in the manifold");
  claims.delaunay->restricted = DelaunayClaim::Restricted{true, false, ratio(1, 8)};
  EXPECT_EQ(level_line(claims, "4", unit),
            "Delaunay for the distance in the space around it; every point of the manifold is within 1.250e+00 ε of a "
            "vertex");
  claims.delaunay->restricted->intrinsic = true;
  EXPECT_EQ(level_line(claims, "4", unit),
            "Delaunay for the distance in the space around it and for the length of curves; every point of the "
            "manifold is within 1.250e+00 ε of a vertex");
  claims.delaunay->restricted->extrinsic = false;
  EXPECT_EQ(level_line(claims, "4", unit),
            "Delaunay for the length of curves; every point of the manifold is within 1.250e+00 ε of a vertex");
  claims.delaunay = DelaunayClaim{DelaunayClaim::Balls{ratio(1, 20), ratio(1, 8)}};
  EXPECT_EQ(level_line(claims, "4", unit),
            "Delaunay in the manifold: protection ≥ 5.000e-01 ε, circumradius ≤ 1.250e+00 ε");
}

TEST(LevelLine, of_level_5_says_by_which_route) {
  Claims claims;
  claims.triangulation = TriangulationClaim{"geodesic"};
  EXPECT_EQ(level_line(claims, "5", unit), "triangulation: by geodesic simplices");
  claims.triangulation->riemannian = TriangulationClaim::RiemannianSimplices{ratio(1, 4), ratio(1, 5)};
  EXPECT_EQ(level_line(claims, "5", unit),
            "triangulation: by geodesic simplices, and by Dyer, Vegter and Wintraecken: thickness ≥ 2.500e-01, stars "
            "within 2.000e+00 ε");
  claims.manifold = ManifoldClaim{10, 0, true, {}};
  claims.triangulation = TriangulationClaim{"affine-charts"};
  EXPECT_EQ(level_line(claims, "5", unit),
            "triangulation: by simplices that are straight in the torus, 10 of them with agreeing lifts, one sheet");
}

TEST(LevelLine, of_level_6_says_how_far_metrics_are_apart) {
  Claims claims;
  claims.metric.emplace();
  EXPECT_EQ(level_line(claims, "6", unit), "metric: isometric to the manifold");
  claims.metric = MetricClaim{true, {}, ratio(1, 2), Rational(2), ratio(1, 4)};
  EXPECT_EQ(level_line(claims, "6", unit),
            "metric: self-Delaunay, bi-Lipschitz with factors ≥ 5.000e-01, ≤ 2.000e+00, sine of the angle to tangent "
            "spaces ≤ 2.500e-01");
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
