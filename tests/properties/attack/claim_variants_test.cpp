#include "properties/attack/claim_variants.hpp"

#include <gtest/gtest.h>

#include "proofs/formula/decision.hpp"
#include "tests/properties/attack/small_claims.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

using test::claim_about_simplices;
using test::right_claim;
using test::triangle_bindings;

const Rational half = Rational(1) / Rational(2);

TEST(ClaimVariants, twins_have_one_conclusion_moved_or_one_hypothesis_less) {
  const Claim claim = right_claim();
  const Claim moved = twin_of_conclusion(claim, 0);
  EXPECT_EQ(moved.name, "right/radius-twin");
  EXPECT_EQ(moved.conclusions.at(0).text, "eta*circumradius(s) <= longest_edge(s)/4");
  EXPECT_EQ(moved.hypotheses.size(), 1U);
  const Claim dropped = twin_of_hypothesis(claim, 0);
  EXPECT_EQ(dropped.name, "right/without-small");
  EXPECT_TRUE(dropped.hypotheses.empty());
  EXPECT_EQ(dropped.conclusions.at(0).text, claim.conclusions.at(0).text);
}

TEST(ClaimVariants, a_strict_statement_is_refuted_exactly_where_there_is_equality) {
  const Claim claim = claim_about_simplices(
      "a",
      "[[show]]\nclaim = \"2*circumradius(s) >= longest_edge(s) and (forall f in faces(s): thickness(f) <= 1)\"\n");
  const Bindings right = triangle_bindings(0, 1);
  const Bindings acute = triangle_bindings(half, 1);
  const auto strict = made_strict(claim.conclusions[0].formula);
  Scene equality(right);
  EXPECT_EQ(decide_statement(*claim.conclusions[0].formula, equality), Verdict::proved);
  EXPECT_EQ(decide_statement(*strict, equality), Verdict::refuted);
  // Vertices and edges have thickness 1: without them the acute triangle has no equality.
  const Claim radius = claim_about_simplices("b", "[[show]]\nclaim = \"2*circumradius(s) >= longest_edge(s)\"\n");
  Scene right_angle(right);
  EXPECT_EQ(decide_statement(*made_strict(radius.conclusions[0].formula), right_angle), Verdict::refuted);
  Scene inequality(acute);
  EXPECT_EQ(decide_statement(*made_strict(radius.conclusions[0].formula), inequality), Verdict::proved);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
