#include "proofs/formula/places.hpp"

#include <gtest/gtest.h>

#include "kernel/formula/formula_text.hpp"
#include "proofs/formula/substitution.hpp"
#include "tests/properties/attack/small_claims.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

ExpressionPointer formula(const std::string& text) {
  const Claim claim = test::claim_about_simplices("a", "[[show]]\nclaim = \"" + text + "\"\n");
  return without_definitions(claim.conclusions[0].formula);
}

/// "bound: a + b (-)": the kind, the text, and whether the statement says more if the term is smaller (-) or larger
/// (+).
std::vector<std::string> places(const std::string& text) {
  std::vector<std::string> result;
  for (const Place& place : places_in(*formula(text))) {
    result.push_back(std::string(name_of(place.kind)) + ": " + place.text + (place.stronger_if_smaller ? " -" : " +"));
  }
  return result;
}

using Texts = std::vector<std::string>;

TEST(Places, a_sum_has_summands_and_a_product_factors) {
  EXPECT_EQ(places("circumradius(s) <= 3*thickness(s)/k + 1"),
            (Texts{"bound: 3*thickness(s)/k + 1 -", "summand: 3*thickness(s)/k -", "factor: thickness(s) -",
                   "factor: k +", "summand: 1 -"}));
}

TEST(Places, a_constant_within_is_a_place_of_its_own_and_a_factor_of_the_whole_is_not) {
  EXPECT_EQ(places("circumradius(s) <= 2*(thickness(s)/4)^2"),
            (Texts{"bound: 2*(thickness(s)/4)^2 -", "factor: (thickness(s)/4)^2 -", "factor: thickness(s) -",
                   "constant: 4 +"}));
}

TEST(Places, the_sense_turns_below_minus_divisors_and_on_the_smaller_side) {
  EXPECT_EQ(places("2*k - 3 <= circumradius(s)"),
            (Texts{"bound: 2*k - 3 +", "summand: 2*k +", "factor: k +", "summand: 3 -"}));
  EXPECT_EQ(places("circumradius(s) >= 2*k"), (Texts{"bound: 2*k +", "factor: k +"}));
  EXPECT_EQ(places("circumradius(s) <= k^-2"), (Texts{"bound: k^-2 -"}));
  EXPECT_EQ(places("circumradius(s) <= 2^k"), (Texts{"bound: 2^k -", "constant: 2 -"}));
}

TEST(Places, what_is_bare_on_both_sides_is_a_place_once_and_zero_and_guards_are_none) {
  EXPECT_EQ(places("circumradius(s) <= longest_edge(s)"), (Texts{"bound: longest_edge(s) -"}));
  EXPECT_EQ(places("0 <= thickness(s)"), (Texts{"bound: thickness(s) -"}));
  EXPECT_EQ(places("k <= 2 implies has_circumcentre(s) and not thickness(s) > 2"), Texts());
  EXPECT_EQ(places("forall f in facets(s): thickness(f) >= 1/2"), (Texts{"bound: 1/2 +"}));
}

TEST(Places, definitions_show_their_constants) {
  bool found = false;
  for (const std::string& text : places("circumradius(s) <= 1 + hoop_bound(k, m)"))
    found = found || text == "summand: 2^13*k/m^3 -";
  EXPECT_TRUE(found);
}

TEST(Places, a_place_is_scaled_and_deleted_where_it_is) {
  const ExpressionPointer statement = formula("has_circumcentre(s) and circumradius(s) <= 3*k + thickness(s)");
  const auto all = places_in(*statement);
  ASSERT_EQ(all.size(), 4U);
  EXPECT_EQ(formula_text(*with_place_scaled(statement, all[1], Rational(1) / Rational(8))),
            "has_circumcentre(s) and circumradius(s) <= 1/8*(3*k) + thickness(s)");
  EXPECT_EQ(formula_text(*without_place(statement, all[3])), "has_circumcentre(s) and circumradius(s) <= 3*k + 0");
  EXPECT_EQ(formula_text(*without_place(statement, all[2])),
            "has_circumcentre(s) and circumradius(s) <= 3*1 + thickness(s)");
  const FocusedStatement alone = focused(statement, all[3]);
  EXPECT_EQ(formula_text(*alone.formula), "circumradius(s) <= 3*k + thickness(s)");
  EXPECT_EQ(formula_text(*without_place(alone.formula, alone.place)), "circumradius(s) <= 3*k + 0");
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
