#include "proofs/formula/simplex_vocabulary.hpp"

#include "tests/proofs/formula/vocabulary_checks.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

const Rational zero(0);

/// Legs of 3 and 4.
Bindings right_triangle() { return {{"s", simplex({{zero, zero}, {Rational(3), zero}, {zero, Rational(4)}})}}; }

TEST(SimplexVocabulary, LengthsOfARightTriangle) {
  const Bindings s = right_triangle();
  expect_equal("longest_edge(s)", "5", s);
  expect_equal("shortest_edge(s)", "3", s);
  expect_equal("edge(s, 1, 2)", "5", s);
  expect_equal("edge(s, 1, 1)", "0", s);
  expect_equal("altitude(s, 0)", "12/5", s);
  expect_equal("altitude(s, 1)", "3", s);
  expect_equal("thickness(s)", "6/25", s);
  expect_equal("circumradius(s)", "5/2", s);
}

TEST(SimplexVocabulary, SingularValuesOfARightTriangleAreItsLegs) {
  const Bindings s = right_triangle();
  expect_equal("largest_singular_value(s)", "4", s);
  expect_equal("smallest_singular_value(s)", "3", s);
  expect_equal("singular_value(s, 2)", "3", s);
  EXPECT_THROW((void)verdict("singular_value(s, 3) > 0", s), InputError);
  EXPECT_THROW((void)verdict("singular_value(s, 0) > 0", s), InputError);
}

TEST(SimplexVocabulary, TheDualBasisIsOrthogonalToTheFacets) {
  // w_1 = (1/3, 0), w_2 = (0, 1/4), w_0 = −w_1 − w_2.
  const Bindings s = right_triangle();
  expect_equal("dual_length(s, 1)", "1/3", s);
  expect_equal("dual_length(s, 2)", "1/4", s);
  expect_equal("dual_length(s, 0)", "5/12", s);
  for (const std::string i : {"0", "1", "2"}) expect_equal("altitude_times_dual_length(s, " + i + ")", "1", s);
  expect_equal("dual_product(s, 1, 1)", "1", s);
  expect_equal("dual_product(s, 1, 2)", "0", s);
  expect_equal("dual_product(s, 0, 2)", "-1", s);
  expect_equal("dual_product(s, 2, 0)", "0", s);
}

TEST(SimplexVocabulary, TheDualBasisNeedsNoCoordinates) {
  const Bindings s{{"s", regular(3, Rational(2))}};
  expect_equal("altitude_times_dual_length(s, 2)", "1", s);
  expect_equal("dual_product(s, 2, 2)", "1", s);
  expect_equal("dual_product(s, 2, 3)", "0", s);
  expect_equal("circumradius(s)^2", "3/4", s);
}

TEST(SimplexVocabulary, WhatADegenerateSimplexLacksStaysUndecided) {
  const Bindings s{{"s", simplex({{zero, zero}, {Rational(1), Rational(1)}, {Rational(3), Rational(3)}})}};
  EXPECT_EQ(verdict("is_nondegenerate(s)", s), Verdict::refuted);
  EXPECT_EQ(verdict("has_circumcentre(s)", s), Verdict::refuted);
  EXPECT_EQ(verdict("circumradius(s) > 0", s), Verdict::undecided);
  EXPECT_EQ(verdict("dual_product(s, 1, 1) = 1", s), Verdict::undecided);
  EXPECT_EQ(verdict("altitude_times_dual_length(s, 1) = 1", s), Verdict::undecided);
  expect_equal("thickness(s)", "0", s);
}

TEST(SimplexVocabulary, FacesAreCounted) {
  const Bindings s{{"s", regular(3, Rational(1))}};
  expect_equal("dimension(s)", "3", s);
  expect_equal("dimension(opposite_facet(s, 1))", "2", s);
  // Each kind of face of a regular simplex has one thickness: 1 for edges, √3/4 for triangles, √6/9 for itself.
  EXPECT_EQ(verdict("forall f in facets(s): thickness(f)^2 = 3/16", s), Verdict::proved);
  EXPECT_EQ(verdict("forall f in faces(s): thickness(f)^2 >= 2/27", s), Verdict::proved);
  EXPECT_EQ(verdict("forall f in proper_faces(s): thickness(f)^2 >= 3/16", s), Verdict::proved);
  EXPECT_EQ(verdict("forall f in faces(s): thickness(f)^2 >= 3/16", s), Verdict::refuted);
  EXPECT_EQ(verdict("exists p in vertices(s): p = 3", s), Verdict::proved);
  EXPECT_EQ(verdict("exists p in vertices(s): p = 4", s), Verdict::refuted);
  EXPECT_THROW((void)verdict("altitude(s, 4) > 0", s), InputError);
}

TEST(SimplexVocabulary, GoodAndFlake) {
  // Thickness √3/4: good for Γ₀² ≤ √3/4, a flake for larger Γ₀.
  const Bindings s{{"s", regular(2, Rational(1))}};
  EXPECT_EQ(verdict("is_good(s, 13/20)", s), Verdict::proved);
  EXPECT_EQ(verdict("is_good(s, 2/3)", s), Verdict::refuted);
  EXPECT_EQ(verdict("is_flake(s, 2/3)", s), Verdict::proved);
  EXPECT_EQ(verdict("is_flake(s, 13/20)", s), Verdict::refuted);
  // Every vertex has the distance 1 from the ends of its facet, whose radius is 1/2.
  EXPECT_EQ(verdict("has_hoop_property(s, 2)", s), Verdict::proved);
  EXPECT_EQ(verdict("has_hoop_property(s, 199/100)", s), Verdict::refuted);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
