#include "proofs/tables/worst_ratios.hpp"

#include <gtest/gtest.h>

#include "support/error.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

TEST(WorstRatios, are_the_greatest_over_the_shapes_of_each_dimension) {
  const WorstRatios ratios = parse_worst_ratios(
      R"([{"claim": "a", "conclusion": "b", "k": 1, "m": 1, "lower": 0.5, "upper": 0.5, "evaluations": 3, "note": "holds"},
          {"claim": "a", "conclusion": "b", "k": 1, "m": 2, "lower": 0.75, "upper": 1, "evaluations": 3, "note": "holds"},
          {"claim": "a", "conclusion": "b", "k": 2, "m": 2, "lower": 0.25, "upper": 0.5, "evaluations": 3, "note": "holds"},
          {"claim": "a", "conclusion": "c", "k": 1, "m": 1, "lower": 1, "upper": 1, "evaluations": 3, "note": "equality, exactly"},
          {"claim": "a", "conclusion": "c", "k": 1, "m": 2, "lower": 0.5, "upper": 0.5, "evaluations": 3, "note": "holds"},
          {"claim": "a", "conclusion": "e", "k": 0, "m": 3, "lower": 2, "upper": 2, "evaluations": 3, "note": "REFUTED"},
          {"claim": "a", "conclusion": "d", "k": 1, "m": 1}])",
      "x.json");
  ASSERT_EQ(ratios.size(), 3U);
  EXPECT_EQ(ratios.at("a/b").at("k=1").lower, Rational(3) / Rational(4));
  EXPECT_EQ(ratios.at("a/b").at("k=2").lower, Rational(1) / Rational(4));
  EXPECT_FALSE(ratios.at("a/b").at("k=1").is_equality);
  EXPECT_EQ(ratios.at("a/c").at("k=1").lower, Rational(1));
  EXPECT_TRUE(ratios.at("a/c").at("k=1").is_equality);
  EXPECT_EQ(ratios.at("a/e").at("m=3").lower, Rational(2));
}

TEST(WorstRatios, other_json_is_refused_with_the_name_of_the_file) {
  for (const char* text : {"", "{", "{}", "[3]", "[{}]", R"([{"claim": "a", "conclusion": "b", "lower": "x"}])",
                           R"([{"claim": "a", "conclusion": "b", "lower": 0.5}])",
                           R"([{"claim": "a", "conclusion": "b", "lower": 1e999, "note": "holds"}])"}) {
    try {
      (void)parse_worst_ratios(text, "x.json");
      FAIL() << text;
    } catch (const InputError& error) {
      EXPECT_TRUE(std::string(error.what()).starts_with("x.json: ")) << error.what();
    }
  }
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
