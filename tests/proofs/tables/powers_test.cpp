#include "proofs/tables/powers.hpp"

#include <gtest/gtest.h>

#include "support/error.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

TEST(Powers, are_read_with_what_was_changed) {
  const auto powers = parse_powers(
      R"([{"claim": "a", "conclusion": "b", "k": 2, "m": 3, "place": "4*x", "kind": "bound", "scale": "64/65", "power": true, "evaluations": 40},
          {"claim": "a", "conclusion": "b", "hypothesis": "h", "k": 0, "m": 3, "place": "y", "kind": "bound", "power": false},
          {"claim": "a", "conclusion": "b", "k": 2, "m": 2, "place": "4*x", "kind": "bound", "power": false, "instance": false}])",
      "x.json");
  ASSERT_EQ(powers.size(), 2U);
  EXPECT_EQ(powers[0].scale, Rational(64) / Rational(65));
  EXPECT_EQ(powers[0].dimension, "k=2");
  EXPECT_EQ(powers[0].evaluations, 40U);
  EXPECT_EQ(powers[1].part, "h");
  EXPECT_EQ(power_by_dimension(powers, "a", "b", "4*x", "bound"), "k=2: × 0.984");
  EXPECT_EQ(power_by_dimension(powers, "a", "h", "y", "bound"), "m=3: no power");
  EXPECT_EQ(power_by_dimension(powers, "a", "b", "4*x", "factor"), "");
}

TEST(Powers, the_page_has_a_line_for_each_place) {
  const std::string page =
      power_page({{"a", "b", "k=1", "x|y", "summand", Rational(1) / Rational(2), true, true, false, 2000},
                  {"a", "b", "k=2", "x|y", "summand", std::nullopt, false, true, false, 200},
                  {"a", "b", "k=1", "k", "factor", std::nullopt, false, true, true, 50},
                  {"a", "h", "k=1", "1/64", "bound", Rational(8), false, false, false, 2000},
                  {"a", "h", "k=2", "1/64", "bound", Rational(4), false, false, false, 2000}});
  EXPECT_NE(page.find("| a / b | `x\\|y` | summand | k=1: × 0.5, k=2: no power | k=1: refuted, k=2: no power | k=1: "
                      "2000, k=2: 200 |\n"
                      "| a / b | `k` | factor | – | k=1: says less | 50 |\n"
                      "| a / h | `1/64` | bound | k=1: × 8, k=2: × 4 | – | 2000 |\n"),
            std::string::npos)
      << page;
}

TEST(Powers, scales_are_rounded_away_from_one) {
  EXPECT_EQ(scale_text(Rational(2) / Rational(3)), "× 0.666");
  EXPECT_EQ(scale_text(Rational(4) / Rational(3)), "× 1.34");
  EXPECT_EQ(scale_text(Rational(1)), "refuted");
}

TEST(Powers, other_json_is_refused_with_the_name_of_the_file) {
  for (const char* text :
       {"", "{}", "[3]", "[{}]",
        R"([{"claim": "a", "conclusion": "b", "k": 1, "m": 1, "place": "x", "kind": "bound", "scale": "1.5"}])",
        R"([{"claim": "a", "conclusion": "b", "k": 1, "m": 1, "place": "x", "kind": "bound", "scale": "-1"}])"}) {
    try {
      (void)parse_powers(text, "x.json");
      FAIL() << text;
    } catch (const InputError& error) {
      EXPECT_TRUE(std::string(error.what()).starts_with("x.json: ")) << error.what();
    }
  }
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
