// Proofs by sums of squares that the prover writes are accepted, and with one thing changed rejected.

#include "proofs/replay/squares.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <nlohmann/json.hpp>

#include "tests/proofs/replay/replayed_step.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

using Json = nlohmann::ordered_json;
using test::logged;
using test::replayed;

const char* const means =
    "forall = { a = '[0, infinity)', b = '[0, infinity)', c = '[0, infinity)' }\n"
    "claim = '((a + b + c)/3)^3 >= a*b*c'";
const char* const line =
    "forall = { x = '(-infinity, infinity)', y = '(-infinity, infinity)' }\ngiven = ['x + y >= 1']\n"
    "claim = 'x^2 + y^2 >= 1/2'";
const char* const strict =
    "forall = { x = '(-infinity, infinity)', y = '(-infinity, infinity)' }\ngiven = ['x + y >= 1']\n"
    "claim = 'x^2 + y^2 > 1/2 - 1/2^30'";

std::string changed(const char* lines, const std::function<void(Json&)>& change) {
  Json step = logged(lines);
  EXPECT_EQ(replayed(step), "accepted");
  change(step["goals"][0]["squares"]);
  return replayed(step);
}

/// The sign that has squares.
Json& with_terms(Json& squares) {
  for (Json& sign : squares["signs"]) {
    if (sign.contains("terms")) return sign;
  }
  return squares["signs"].at(0);
}

TEST(ReplayedSquares, are_accepted_as_the_prover_writes_them) {
  for (const char* lines : {means, line, strict}) EXPECT_EQ(replayed(logged(lines)), "accepted") << lines;
}

TEST(ReplayedSquares, have_to_add_up) {
  const auto message = "c / a: goal 1: squares of which the sum is another polynomial";
  EXPECT_EQ(changed(means, [](Json& squares) { with_terms(squares)["terms"].erase(0); }), message);
  EXPECT_EQ(changed(means, [](Json& squares) { with_terms(squares)["terms"][0]["weight"] = "7/3"; }), message);
  EXPECT_EQ(changed(means, [](Json& squares) { with_terms(squares)["terms"][0]["base"] = "a"; }), message);
  EXPECT_EQ(changed(means, [](Json& squares) { with_terms(squares)["terms"][0]["times"] = Json::array(); }), message);
}

TEST(ReplayedSquares, have_positive_weights) {
  EXPECT_EQ(changed(line,
                    [](Json& squares) {
                      Json& terms = with_terms(squares)["terms"];
                      terms.push_back({{"weight", "-1"}, {"base", "x"}, {"times", Json::array()}});
                      terms.push_back({{"weight", "1"}, {"base", "x"}, {"times", Json::array()}});
                    }),
            "c / a: goal 1: a square with a weight that is not positive");
}

TEST(ReplayedSquares, are_multiplied_by_what_the_hypotheses_grant_only) {
  EXPECT_EQ(changed(line,
                    [](Json& squares) {
                      squares["constraints"].push_back({"comparison", 1, false});
                    }),
            "c / a: goal 1: a comparison that no hypothesis grants");
  EXPECT_EQ(changed(line,
                    [](Json& squares) {
                      squares["constraints"].push_back({"lower", "x"});
                    }),
            "c / a: goal 1: an end of a range that has none");
  EXPECT_EQ(changed(line,
                    [](Json& squares) {
                      squares["constraints"].push_back({"comparison", 0, true});
                    }),
            "c / a: goal 1: a comparison that is turned, but no equation");
  EXPECT_EQ(changed(means,
                    [](Json& squares) {
                      squares["constraints"].push_back({"upper", "a"});
                    }),
            "c / a: goal 1: an end of a range that has none");
}

TEST(ReplayedSquares, have_to_be_strict_where_the_conclusion_is) {
  EXPECT_EQ(changed(strict, [](Json& squares) { with_terms(squares)["sign"] = 1; }),
            "c / a: goal 1: squares that do not show the conclusion");
  EXPECT_EQ(changed(line, [](Json& squares) { with_terms(squares)["sign"] = 2; }),
            "c / a: goal 1: squares that may vanish together");
  EXPECT_EQ(changed(line, [](Json& squares) { with_terms(squares)["sign"] = -1; }),
            "c / a: goal 1: squares of which the sum is another polynomial");
}

TEST(ReplayedSquares, have_to_be_there_for_each_factor) {
  EXPECT_EQ(changed(line, [](Json& squares) { squares["signs"] = Json::array(); }),
            "c / a: goal 1: squares that do not show the conclusion");
  EXPECT_EQ(changed(line, [](Json& squares) { with_terms(squares).erase("terms"); }),
            "c / a: goal 1: a sign that the ranges do not show");
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
