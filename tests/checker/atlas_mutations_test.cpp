// Certificates of the sphere by two charts, changed at random; and the oracle that judges them.

#include <gtest/gtest.h>

#include <iostream>
#include <random>

#include "kernel/number/exact_text.hpp"
#include "tests/checker/atlas_documents.hpp"
#include "tests/checker/atlas_oracle.hpp"
#include "tests/checker/exact_formula.hpp"
#include "tests/checker/mutation_campaign.hpp"
#include "tests/checker/support/forgeries.hpp"
#include "tests/checker/support/run_checker.hpp"
#include "tests/checker/upwards.hpp"
#include "tests/support/ratio.hpp"

namespace delcert::checker_tests {
namespace {

using test::ratio;

TEST(AtlasOracle, values_of_formulas_are_exact) {
  const std::vector<std::string> names = {"x", "y"};
  const auto value = [&](const std::string& formula) {
    return exact_value(formula, names, {ratio(1, 3), Rational(-2)});
  };
  EXPECT_EQ(value("x/(x^2+y^2)"), ratio(3, 37));
  EXPECT_EQ(value("-y^2-010*x"), ratio(-22, 3));
  EXPECT_EQ(value("abs(y)-abs(x)"), ratio(5, 3));
  EXPECT_FALSE(value("1/(y+2)").has_value());
  EXPECT_FALSE(value("0*(1/(y+2))").has_value());
  for (const char* wrong : {"x+", "(x", "z", "x y", "x^y", ""})
    EXPECT_THROW((void)value(wrong), std::exception) << wrong;
}

TEST(AtlasOracle, finds_nothing_false_in_what_is_true) {
  EXPECT_EQ(fault_of_sphere_by_charts(sealed(sphere_document())), "");
  EXPECT_EQ(fault_of_sphere_by_charts(sealed(coarse_sphere_document())), "");
  EXPECT_EQ(fault_of_sphere_by_charts(sealed(torus_document())), "another atlas");
}

/// The twin of the mutations: they would be noticed if the checker accepted what is false.
TEST(AtlasOracle, finds_false_the_forgeries_that_a_checker_without_a_rule_accepts) {
  int number = 0;
  for (const Forgery& forgery : atlas_forgeries()) {
    if (forgery.bytes.find("\"sphere-2-stereographic\"") == std::string::npos) continue;
    SCOPED_TRACE(forgery.name);
    ASSERT_EQ(run_checker(forgery.bytes, forgery.rule).status, 0);
    const std::string fault = fault_of_sphere_by_charts(forgery.bytes);
    std::cout << forgery.rule << ": " << forgery.name << ": " << fault << "\n";
    EXPECT_NE(fault, "");
    ++number;
  }
  EXPECT_GE(number, 12);
}

/// Numbers that are changed at random, by a third or more, so that the whole checker rejects them; one without the rule
/// accepts them.
TEST(AtlasOracle, finds_false_what_a_checker_without_a_rule_accepts_of_random_numbers) {
  struct Number {
    std::string rule, path;
    bool is_lower;     // a lower bound
    Rational room{1};  // that the checker leaves
  };
  std::mt19937_64 random(11);
  int accepted = 0, found = 0;
  for (const Number& number :
       {Number{"1.protection", "/levels/1/protection", true}, Number{"1.thickness", "/levels/1/thickness", true},
        Number{"5.blend", "/levels/5/contraction", false, Rational(16)}}) {
    int found_here = 0;
    for (int k = 0; k < 3; ++k) {
      Json document = coarse_sphere_document();
      Json& stated = document[Json::json_pointer(number.path)];
      const Rational factor = ratio(static_cast<long>(1 + random() % 20), 32) / number.room;
      const Rational truth = parse_exact(stated.get<std::string>());
      stated = exact_text(number.is_lower ? truth / factor : truth * factor);
      const std::string text = sealed(document);
      if (run_checker(text).status != 1 || run_checker(text, number.rule).status != 0) continue;
      ++accepted;
      if (!fault_of_sphere_by_charts(text).empty()) ++found_here;
    }
    EXPECT_GT(found_here, 0) << number.path;
    found += found_here;
  }
  std::cout << "of " << accepted << " that a checker without a rule accepts the oracle finds " << found << " false\n";
  EXPECT_GT(2 * found, accepted);
}

/// Half of them in the manifold block, the parameters and the levels only.
TEST(MutationsOfAtlases, sealed_anew_are_accepted_only_if_nothing_false_is_found) {
  Json document = coarse_sphere_document();
  document["software"] = Json{{"delcert", "test"}};
  const std::string text = sealed(document);
  const test::Upwards upwards;
  run_campaign({.name = "a sphere by charts",
                .text = text,
                .fault = fault_of_sphere_by_charts,
                .few = 60,
                .seed = 10,
                .head = text.find("\"net\":")});
}

}  // namespace
}  // namespace delcert::checker_tests
