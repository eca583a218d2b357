#include "proofs/prover/search.hpp"

#include <gtest/gtest.h>

#include "tests/proofs/prover/prove_text.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

/// The search with an oracle that knows nothing unless told otherwise.
SearchResult found(const std::string& lines, const SearchLimits& limits = {}, Verdict told = Verdict::undecided) {
  const Step of = test::step(lines);
  Goal goal = make_goal(of.claim.formula, of.parameters);
  return search(
      goal, [&](const std::vector<Rational>&) { return told; }, limits);
}

std::size_t leaves_of(const SearchResult& result) {
  std::size_t count = 0;
  for (const ProofNode& node : result.nodes) count += node.cut ? 0U : 1U;
  return count;
}

TEST(Search, cuts_until_all_parts_are_proved) {
  const SearchResult result =
      found("forall = { x = '[0, 1]', y = '[0, 1]' }\nclaim = '(x - y)^2 + x*y/10 + 1/100 > 0'");
  EXPECT_EQ(result.verdict, Verdict::proved);
  EXPECT_EQ(result.roots.size(), 1U);
  EXPECT_GT(leaves_of(result), 1U);
  EXPECT_EQ(result.nodes.size(), 2 * leaves_of(result) - 1);
}

TEST(Search, refutes_by_exact_points_only) {
  const std::string wrong = "forall = { x = '[0, 1]' }\nclaim = 'x < 1/2'";
  EXPECT_EQ(found(wrong).verdict, Verdict::undecided);
  const SearchResult result = found(wrong, {}, Verdict::refuted);
  EXPECT_EQ(result.verdict, Verdict::refuted);
  EXPECT_EQ(result.counterexample.size(), 1U);
}

TEST(Search, gives_up_at_its_limits) {
  const std::string hard = "forall = { x = '[0, 1]', y = '[0, 1]' }\nclaim = '(3*x - 1)^2 + (3*y - 1)^2 >= 0'";
  const SearchResult result = found(hard);
  EXPECT_EQ(result.verdict, Verdict::undecided);
  EXPECT_LE(result.left.size(), SearchLimits{}.left);
  EXPECT_FALSE(result.left.empty());
  const SearchResult sooner = found(hard, {10, 1000, 3, 40});
  EXPECT_EQ(sooner.verdict, Verdict::undecided);
  EXPECT_LE(sooner.boxes, 13U) << "one more for each of its rounds";
}

TEST(Search, leaves_polynomials_alone_that_are_too_large) {
  const std::string high = "forall = { x = '[0, 1]', y = '[0, 1]' }\nclaim = 'x^9*y^9 + 2 > 0'";
  EXPECT_EQ(found(high, {100, 1000, 8, 3}).verdict, Verdict::proved);
  EXPECT_EQ(found(high, {100, 50, 8, 3}).verdict, Verdict::undecided);
}

TEST(Search, takes_integers_one_by_one) {
  const SearchResult result =
      found("forall = { k = 'integer [1, infinity)' }\nclaim = '(2*k - 5)*(2*k - 7) >= 1/2 or k = 3'");
  EXPECT_EQ(result.verdict, Verdict::proved);
}

TEST(Search, leaves_single_points_to_the_exact_decision) {
  const std::string tie = "forall = { k = 'integer [2, 2]' }\nclaim = 'log2(3*k) - log2(3) <= 1'";
  EXPECT_EQ(found(tie).verdict, Verdict::undecided);
  const SearchResult result = found(tie, {}, Verdict::proved);
  EXPECT_EQ(result.verdict, Verdict::proved);
  EXPECT_TRUE(result.nodes.at(result.roots.at(0)).is_exact);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
