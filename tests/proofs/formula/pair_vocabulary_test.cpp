#include "proofs/formula/pair_vocabulary.hpp"

#include "tests/proofs/formula/vocabulary_checks.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

const Rational zero(0);

Bindings right_triangles() {
  // Legs of 1 and 2, stretched to 3 and 2; E = diag(8, 0).
  return {{"s", simplex({{zero, zero}, {Rational(1), zero}, {zero, Rational(2)}})},
          {"t", simplex({{zero, zero}, {Rational(3), zero}, {zero, Rational(2)}})}};
}

TEST(PairVocabulary, DifferencesOfGramMatricesAreThoseOfTheProducts) {
  const Bindings pair = right_triangles();
  expect_equal("gram_entry_difference(s, t, 1, 1)", "8", pair);
  expect_equal("gram_entry_difference(s, t, 1, 2)", "0", pair);
  expect_equal("gram_entry_difference(t, s, 1, 1)", "-8", pair);
  expect_equal("gram_difference_norm(s, t)", "8", pair);
  expect_equal("gram_difference_norm(t, s)", "8", pair);
}

TEST(PairVocabulary, DifferencesAreThoseOfSquaredEdges) {
  // E_12 = (Δd_1² + Δd_2² − Δd_12²)/2 = ½(3 + 3 − 3), and the norm of [[3, 3/2], [3/2, 3]] is 9/2.
  const Bindings pair{{"s", regular(2, Rational(1))}, {"t", regular(2, Rational(4))}};
  expect_equal("gram_entry_difference(s, t, 1, 2)", "3/2", pair);
  expect_equal("gram_difference_norm(s, t)", "9/2", pair);
}

TEST(PairVocabulary, AlignmentIsKnownWhereTheMapIsSymmetricPositive) {
  // The polar factor of diag(3, 1) is I: ‖P̃ − P‖ = 2, which the lengths of the legs also need at least.
  const Bindings pair = right_triangles();
  EXPECT_EQ(verdict("alignment_error(s, t) <= 201/100", pair), Verdict::proved);
  EXPECT_EQ(verdict("alignment_error(s, t) <= 199/100", pair), Verdict::refuted);
  EXPECT_EQ(verdict("vertex_alignment_error(s, t) <= 201/100", pair), Verdict::proved);
  EXPECT_EQ(verdict("vertex_alignment_error(s, t) <= 199/100", pair), Verdict::refuted);
}

TEST(PairVocabulary, CongruentSimplicesAreAlignedExactly) {
  const Bindings pair{{"s", simplex({{zero, zero}, {Rational(3), zero}, {zero, Rational(4)}})},
                      {"t", simplex({{Rational(7), zero}, {Rational(7), Rational(3)}, {Rational(3), zero}})}};
  expect_equal("alignment_error(s, t)", "0", pair);
  expect_equal("vertex_alignment_error(s, t)", "0", pair);
}

TEST(PairVocabulary, WhatIsNoPairIsRefused) {
  Bindings pair = right_triangles();
  pair["e"] = simplex({{zero, zero}, {Rational(1), zero}});
  EXPECT_THROW((void)verdict("gram_difference_norm(s, e) = 0", pair), InputError);
  EXPECT_THROW((void)verdict("alignment_error(s, e) = 0", pair), InputError);
  EXPECT_THROW((void)verdict("gram_entry_difference(s, t, 0, 1) = 0", pair), InputError);
  EXPECT_THROW((void)verdict("gram_entry_difference(s, t, 1, 3) = 0", pair), InputError);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
