#include "properties/attack/tighten.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "properties/attack/attempt.hpp"
#include "tests/properties/attack/small_claims.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

using test::claim_about_simplices;

/// True but loose: R ≤ Δ/(2Υ), with equality for edges.
Claim loose_claim() {
  return claim_about_simplices(
      "loose", "[[show]]\nname = \"radius\"\nclaim = \"circumradius(s) <= longest_edge(s)/thickness(s)\"\n");
}

TEST(Tighten, the_best_constant_of_a_loose_claim_is_found) {
  const auto found = tighten(loose_claim(), 0, {1, 2}, 40, 1, no_progress());
  ASSERT_TRUE(found.has_value());
  EXPECT_EQ(found->verdict, Verdict::proved);
  EXPECT_LE(found->ratio.lower, 0.5);
  EXPECT_GE(found->ratio.upper, 0.5);
  EXPECT_FALSE(found->is_equality);
  EXPECT_GE(found->evaluations, 10U);
}

TEST(Tighten, equality_is_recognised_exactly_and_only_where_it_is) {
  const Claim equal =
      claim_about_simplices("a", "[[show]]\nclaim = \"2*circumradius(s) <= longest_edge(s)/thickness(s)\"\n");
  EXPECT_TRUE(tighten(equal, 0, {1, 1}, 20, 1, no_progress()).value().is_equality);
  const Claim nearly = claim_about_simplices(
      "a", "[[show]]\nclaim = \"2*circumradius(s) <= (1 + 1/2^200)*longest_edge(s)/thickness(s)\"\n");
  const auto found = tighten(nearly, 0, {1, 1}, 20, 1, no_progress());
  EXPECT_FALSE(found.value().is_equality);
  EXPECT_EQ(found->verdict, Verdict::proved);
}

TEST(Tighten, the_search_is_better_than_its_random_start_and_finds_what_refutes) {
  const Claim claim =
      claim_about_simplices("a",
                            "[[show]]\nclaim = \"longest_edge(s) <= 1999/2000*3/2*shortest_edge(s) or k = 1\"\n"
                            "[[show]]\nclaim = \"thickness(s) <= 2/5\"\n");
  // The regular triangle has thickness √3/4 = 0.433…, which is the greatest.
  const auto found = tighten(claim, 1, {2, 2}, 1500, 1, no_progress());
  ASSERT_TRUE(found.has_value());
  EXPECT_EQ(found->verdict, Verdict::refuted);
  EXPECT_GT(found->ratio.lower, 1.08);
  EXPECT_LT(found->ratio.upper, 1.0826);
  EXPECT_EQ(attempt(claim, found->bindings).conclusions.at(1).verdict, Verdict::refuted);
}

TEST(Tighten, bounds_that_stay_wide_do_not_attract_the_search) {
  // The first ratio is 0, which no enclosure tells: its upper bound is some 2³⁵⁰, and grows with the radius.
  const Claim claim = claim_about_simplices("a",
                                            "[[show]]\nclaim = \"abs(circumradius(s) - circumradius(s)) <= 1/2^600 and "
                                            "thickness(s) <= 2/5\"\n");
  const auto found = tighten(claim, 0, {2, 2}, 1500, 1, no_progress());
  ASSERT_TRUE(found.has_value());
  EXPECT_GT(found->ratio.upper, 0x1p200);
  EXPECT_GT(found->ratio.lower, 1.08);
}

TEST(Tighten, the_same_seed_gives_the_same) {
  const auto points = [] {
    const auto found = tighten(loose_claim(), 0, {2, 3}, 60, 5, no_progress());
    return object_of<SimplexObject>(std::get<ObjectPointer>(found.value().bindings.at("s"))).points();
  };
  EXPECT_EQ(points(), points());
}

TEST(Tighten, any_number_of_evaluations_ends) {
  for (const std::uint64_t evaluations : {0U, 1U, 2U, 5U, 9U}) {
    const auto found = tighten(loose_claim(), 0, {2, 2}, evaluations, 1, no_progress());
    EXPECT_LE(found ? found->evaluations : 0, evaluations + 8) << evaluations;
  }
}

TEST(Tighten, what_the_progress_throws_passes_through) {
  for (const std::size_t when : {1U, 30U, 90U}) {
    const Progress interrupt = [&](std::string_view, std::size_t done, std::size_t) {
      if (done >= when) throw std::runtime_error("interrupted");
    };
    try {
      (void)tighten(loose_claim(), 0, {2, 2}, 100, 1, interrupt);
      FAIL() << when;
    } catch (const std::runtime_error& error) {
      EXPECT_STREQ(error.what(), "interrupted");
    }
  }
}

TEST(Tighten, without_an_instance_or_a_ratio_nothing_is_found) {
  const Claim never = claim_about_simplices("a", "given = [\"k = 0\"]\n[[show]]\nclaim = \"k <= 1\"\n");
  EXPECT_FALSE(tighten(never, 0, {2, 2}, 20, 1, no_progress()).has_value());
  const Claim no_ratio = claim_about_simplices("a", "[[show]]\nclaim = \"is_nondegenerate(s)\"\n");
  EXPECT_FALSE(tighten(no_ratio, 0, {2, 2}, 20, 1, no_progress()).has_value());
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
