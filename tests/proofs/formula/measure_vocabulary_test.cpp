#include "proofs/formula/measure_vocabulary.hpp"

#include "tests/proofs/formula/vocabulary_checks.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

const Rational zero(0);
const Rational one(1);

/// Legs of 3 and 4, in the plane z = 0 of space; x above its incentre, y below the vertex at the right angle.
Bindings right_triangle() {
  return {{"s", simplex({{zero, zero, zero}, {Rational(3), zero, zero}, {zero, Rational(4), zero}})},
          {"x", point({one, one, Rational(2)})},
          {"y", point({zero, zero, Rational(-5)})}};
}

Bindings corner() {
  return {{"s", simplex({{zero, zero, zero}, {one, zero, zero}, {zero, one, zero}, {zero, zero, one}})},
          {"x", point({one, one, one})}};
}

TEST(MeasureVocabulary, VolumesOfTrianglesAndTetrahedra) {
  expect_equal("volume(s)", "6", right_triangle());
  expect_equal("volume(s)", "1/6", corner());
  expect_equal("volume(s)", "sqrt(3)/4", {{"s", regular(2, one)}});
  expect_equal("volume(opposite_facet(s, 0))", "sqrt(3)/2", corner());
  expect_equal("volume(face(s, 0, 0))", "1", corner());
  expect_equal("volume(s)", "0", {{"s", simplex({{zero, zero}, {one, one}, {Rational(3), Rational(3)}})}});
}

/// r = k·V/(sum of the facets' volumes).
TEST(MeasureVocabulary, TheInradiusIsTheVolumeByTheFacets) {
  expect_equal("inradius(s)", "1", right_triangle());
  for (const Bindings& s : {right_triangle(), corner(), Bindings{{"s", regular(4, one)}}}) {
    expect_equal("inradius(s)*sum(f in facets(s): volume(f))", "dimension(s)*volume(s)", s);
  }
  EXPECT_EQ(verdict("inradius(s) < circumradius(s)", corner()), Verdict::proved);
  EXPECT_EQ(verdict("inradius(s) > 0", {{"s", simplex({{zero, zero}, {one, one}, {Rational(3), Rational(3)}})}}),
            Verdict::undecided);
  EXPECT_EQ(verdict("inradius(face(s, 0, 0)) > 0", corner()), Verdict::undecided);
}

TEST(MeasureVocabulary, DihedralAngles) {
  // Of a triangle they are its angles, each at the vertex that is opposite neither side.
  expect_equal("dihedral_cosine(s, 1, 2)", "0", right_triangle());
  expect_equal("dihedral_cosine(s, 0, 1)", "4/5", right_triangle());
  expect_equal("dihedral_cosine(s, 0, 2)", "3/5", right_triangle());
  for (int k = 2; k <= 5; ++k) {
    expect_equal("dihedral_cosine(s, 0, 1)", "1/" + std::to_string(k),
                 {{"s", regular(static_cast<std::size_t>(k), one)}});
  }
  expect_equal("dihedral_cosine(s, 1, 2)", "0", corner());
  expect_equal("dihedral_cosine(s, 0, 2)", "1/sqrt(3)", corner());
  // Obtuse, so negative: 120°.
  const Bindings flat{{"s", simplex({{zero, zero}, {Rational(2), zero}, {Rational(-1), one}})}};
  EXPECT_EQ(verdict("dihedral_cosine(s, 1, 2) < 0", flat), Verdict::proved);
  EXPECT_THROW((void)verdict("dihedral_cosine(s, 1, 1) > 0", corner()), InputError);
  EXPECT_EQ(verdict("dihedral_cosine(face(s, 0, 1), 0, 1) > 0", corner()), Verdict::undecided);
}

TEST(MeasureVocabulary, BarycentricCoordinatesAreThoseOfTheProjection) {
  expect_equal("barycentric_coordinate(s, x, 0)", "5/12", right_triangle());
  expect_equal("barycentric_coordinate(s, x, 1)", "1/3", right_triangle());
  expect_equal("barycentric_coordinate(s, x, 2)", "1/4", right_triangle());
  expect_equal("barycentric_coordinate(s, x, 0)", "-2", corner());
  expect_equal("sum(i in vertices(s): barycentric_coordinate(s, x, i))", "1", corner());
  expect_equal("barycentric_coordinate(s, centroid(s), 2)", "1/4", corner());
  for (const std::string i : {"0", "1", "2"}) {
    expect_equal("barycentric_coordinate(s, vertex(s, " + i + "), " + i + ")", "1", right_triangle());
  }
  EXPECT_THROW((void)verdict("barycentric_coordinate(s, x, 3) > 0", right_triangle()), InputError);
  const Bindings degenerate{{"s", simplex({{zero, zero}, {one, one}, {Rational(3), Rational(3)}})},
                            {"x", point({zero, one})}};
  EXPECT_EQ(verdict("barycentric_coordinate(s, x, 0) = 0", degenerate), Verdict::undecided);
}

TEST(MeasureVocabulary, DistancesFromAffineHulls) {
  expect_equal("distance_to_affine_hull(s, x)", "2", right_triangle());
  expect_equal("distance_to_affine_hull(s, y)", "5", right_triangle());
  expect_equal("distance_to_affine_hull(opposite_facet(s, 2), x)", "sqrt(5)", right_triangle());
  expect_equal("distance_to_affine_hull(opposite_facet(s, 0), vertex(s, 0))", "altitude(s, 0)", corner());
  const Bindings degenerate{{"s", simplex({{zero, zero}, {one, one}, {Rational(3), Rational(3)}})},
                            {"x", point({zero, one})}};
  expect_equal("distance_to_affine_hull(s, x)", "1/sqrt(2)", degenerate);
}

TEST(MeasureVocabulary, TheSideOfAHyperplane) {
  expect_equal("signed_distance_to_hyperplane(s, x)", "2", right_triangle());
  expect_equal("signed_distance_to_hyperplane(s, y)", "-5", right_triangle());
  expect_equal("signed_distance_to_hyperplane(s, centroid(s))", "0", right_triangle());
  EXPECT_THROW((void)verdict("signed_distance_to_hyperplane(s, x) > 0", corner()), InputError);
}

TEST(MeasureVocabulary, AnglesBetweenHulls) {
  // The diagonal of a unit cube against its faces and against an axis.
  const Bindings cube{{"s", simplex({{zero, zero, zero}, {one, one, one}})},
                      {"f", simplex({{zero, zero, zero}, {one, zero, zero}, {zero, one, zero}})},
                      {"g", simplex({{zero, zero, one}, {one, zero, one}, {zero, one, Rational(2)}})}};
  expect_equal("hull_angle_sine(s, f)", "1/sqrt(3)", cube);
  expect_equal("hull_angle_sine(s, face(f, 0, 1))", "sqrt(2/3)", cube);
  // Two planes at 45°: enclosed, so not decided with equality, but next to it on both sides.
  EXPECT_EQ(verdict("hull_angle_sine(g, f) < sqrt(1/2) + 1/2^200", cube), Verdict::proved);
  EXPECT_EQ(verdict("hull_angle_sine(g, f) > sqrt(1/2) - 1/2^200", cube), Verdict::proved);
  EXPECT_EQ(verdict("hull_angle_sine(g, f) <= sqrt(1/2) - 1/2^60", cube), Verdict::refuted);
  EXPECT_EQ(verdict("hull_angle_sine(f, f) = 0", cube), Verdict::proved);
  // A plane has a line that is orthogonal to any line.
  expect_equal("hull_angle_sine(f, s)", "1", cube);
}

TEST(MeasureVocabulary, WhatHasNoPlaceInSpaceIsRefused) {
  EXPECT_THROW((void)verdict("coordinate(vertex(s, 0), 0) = 0", {{"s", regular(2, one)}}), InputError);
  EXPECT_THROW((void)verdict("distance_to_affine_hull(s, x) = 0", {{"s", regular(2, one)}, {"x", point({zero, one})}}),
               InputError);
  EXPECT_THROW((void)verdict("coordinate(x, 3) = 0", right_triangle()), InputError);
  EXPECT_THROW((void)verdict("distance_to_affine_hull(s, x) = 0",
                             {{"s", simplex({{zero, zero}, {one, one}})}, {"x", point({zero})}}),
               InputError);
  expect_equal("coordinate(x, 2)", "2", right_triangle());
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
