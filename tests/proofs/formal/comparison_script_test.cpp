#include "proofs/formal/comparison_script.hpp"

#include "tests/proofs/prover/prove_text.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

ComparisonScript script(const std::string& lines, bool squared = false) {
  const Step step = test::step(lines);
  FormalParameters parameters = formal_parameters(step);
  if (squared) parameters.front().is_squared = true;
  return comparison_script(expanded(step, step.claim.formula), parameters);
}

TEST(ComparisonScript, a_quotient_of_signed_products) {
  const auto found = script("forall = { xi = '(0, 1/4]' }\nclaim = '1/(1 + xi) >= 4/5'");
  ASSERT_TRUE(found.tactics);
  EXPECT_NE(found.tactics->find("apply Rle_ge; apply (le_by _ _ "), std::string::npos) << *found.tactics;
}

TEST(ComparisonScript, equations_only_if_they_hold_everywhere) {
  EXPECT_TRUE(script("forall = { x = '[0, 1]' }\nclaim = '(1 + x)^2 = 1 + 2*x + x^2'").tactics);
  EXPECT_FALSE(script("forall = { x = '[0, 1]' }\nclaim = '(1 + x)^2 = 1 + x^2'").tactics);
}

TEST(ComparisonScript, asks_for_squares_where_there_are_roots) {
  const std::string lines = "forall = { k = 'integer [1, infinity)' }\nclaim = 'sqrt(k) <= k'";
  const auto first = script(lines);
  EXPECT_FALSE(first.tactics);
  EXPECT_EQ(first.wanted_squares, std::set<std::size_t>{0});
  const auto second = script(lines, true);
  ASSERT_TRUE(second.tactics);
  EXPECT_NE(second.tactics->find("sqrt (root_k * root_k) = "), std::string::npos) << *second.tactics;
}

TEST(ComparisonScript, nothing_for_what_is_false_strict_at_a_tie_or_no_polynomial) {
  EXPECT_FALSE(script("forall = { xi = '(0, 1/3]' }\nclaim = '1/(1 + xi) >= 4/5'").tactics);
  EXPECT_FALSE(script("forall = { xi = '(0, 1/4]' }\nclaim = '1/(1 + xi) > 4/5'").tactics);
  EXPECT_TRUE(script("forall = { xi = '(0, 1/4)' }\nclaim = '1/(1 + xi) > 4/5'").tactics);
  EXPECT_FALSE(script("forall = { x = '[1, 2]' }\nclaim = 'log2(x) <= 1'").tactics);
  EXPECT_FALSE(script("forall = { x = '[-1, 1]' }\nclaim = '1/x <= 1/x + 1'").tactics) << "the divisor may be 0";
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
