#include "proofs/checker/arithmetic/decimal.hpp"

#include <gtest/gtest.h>

#include <random>
#include <regex>

#include "proofs/checker/arithmetic/exact_number.hpp"
#include "tests/checker/support/forgeries.hpp"
#include "tests/checker/support/run_checker.hpp"
#include "tests/checker/support/samples.hpp"
#include "tests/checker/support/space_form_samples.hpp"
#include "tests/checker/upwards.hpp"

namespace delcert::checker_tests {
namespace {

using checker::exact_value;
using checker::Rational;
using checker::rounded_down;
using checker::rounded_up;
using checker::Verdict;

/// The exact value of a decimal number as printf's %g writes it.
Rational read_back(const std::string& text) {
  static const std::regex shape(R"re((-?)([0-9]+)(?:\.([0-9]+))?(?:e([+-])([0-9]+))?)re");
  std::smatch match;
  EXPECT_TRUE(std::regex_match(text, match, shape)) << text;
  const Rational ten(10);
  Rational value = exact_value(match[2].str() + match[3].str()) / power(ten, static_cast<int>(match[3].length()));
  const int exponent = match[5].matched ? std::stoi(match[5].str()) : 0;
  value = match[4].str() == "-" ? value / power(ten, exponent) : value * power(ten, exponent);
  return match[1].length() > 0 ? -value : value;
}

bool at_most(const Rational& a, const Rational& b) { return less(b, a) == Verdict::refuted; }

TEST(Decimal, of_bounds_is_on_the_safe_side_and_near) {
  const test::Upwards upwards;
  std::mt19937_64 random(1);
  for (int k = 0; k < 20000; ++k) {
    Rational x = exact_value(std::to_string(random())) / exact_value(std::to_string(1 + random()));
    x = k % 3 == 0 ? x * power(Rational(2), static_cast<int>(random() % 200))
                   : x / power(Rational(2), static_cast<int>(random() % 60));
    if (k % 2 == 0) x = -x;
    const Rational below = read_back(rounded_down(x)), above = read_back(rounded_up(x));
    EXPECT_TRUE(at_most(below, x) && at_most(x, above)) << rounded_down(x) << " " << rounded_up(x);
    const Rational size = x.sign() < 0 ? -x : x;
    EXPECT_TRUE(at_most((above - below) * Rational(100000), size)) << rounded_down(x) << " " << rounded_up(x);
  }
}

TEST(Decimal, of_few_digits_is_exact) {
  for (const char* text : {"0", "1", "-3", "0.5", "0.130000", "123456", "1.5e+06", "-1e-05", "0.0001"}) {
    const Rational x = read_back(text);
    EXPECT_EQ(read_back(rounded_down(x)), x) << rounded_down(x);
    EXPECT_EQ(rounded_down(x), rounded_up(x));
  }
  EXPECT_EQ(rounded_down(exact_value("1/8")), "0.125");
  EXPECT_EQ(rounded_down(exact_value("1/3")), "0.333333");
  EXPECT_EQ(rounded_up(exact_value("1/3")), "0.333334");
  EXPECT_EQ(rounded_up(exact_value("-1/3")), "-0.333333");
  EXPECT_EQ(rounded_up(exact_value("9999999")), "1e+07");
  EXPECT_EQ(rounded_down(exact_value("9999999")), "9.99999e+06");
  EXPECT_EQ(rounded_up(exact_value("999999/10000000000")), "9.99999e-05");
}

/// What a line of the report says after the words, read back.
Rational printed(const std::string& output, const std::string& words) {
  const std::size_t place = output.find(words);
  EXPECT_NE(place, std::string::npos) << words << "\n" << output;
  std::smatch match;
  const std::string rest = output.substr(place + words.size());
  EXPECT_TRUE(std::regex_search(rest, match, std::regex(R"re(^-?[0-9][0-9.]*(e[+-][0-9]+)?)re"))) << rest;
  return read_back(match.str());
}

Rational stated(const Json& value) { return exact_value(value.get<std::string>()); }

/// Lower bounds that are printed are at most those that were certified, upper ones at least.
void expect_safe(const Json& document) {
  const CheckerRun run = run_checker_with(temporary_file(sealed(document)));
  ASSERT_EQ(run.status, 0) << run.output;
  const Json &levels = document["levels"], &parameters = document["parameters"];
  const auto lower = [&](const std::string& level, const std::string& words, const Rational& value) {
    const std::string line = run.output.substr(run.output.find("level " + level + " "));
    EXPECT_TRUE(at_most(printed(line, words + " >= "), value)) << words << "\n" << line;
  };
  const auto upper = [&](const std::string& level, const std::string& words, const Rational& value) {
    const std::string line = run.output.substr(run.output.find("level " + level + " "));
    EXPECT_TRUE(at_most(value, printed(line, words + " <= "))) << words << "\n" << line;
  };
  if (levels.contains("1")) {
    lower("1", "protection", stated(levels["1"]["protection"]));
    lower("1", "thickness", stated(levels["1"]["thickness"]));
    upper("1", "circumradius", stated(levels["1"]["circumradius"]));
  }
  if (levels.contains("0") && levels["0"].contains("density")) {
    lower("0", "separation", stated(parameters["separation"]) * stated(parameters["sampling_radius"]));
    upper("0", "density", stated(levels["0"]["density"]));
    upper("4", "radius", stated(levels["4"]["circumradius"]));
  } else if (levels.contains("0")) {
    lower("0", "separation", stated(parameters["separation"]));
    upper("0", "perturbation", stated(parameters["perturbation"]));
  }
}

TEST(Decimal, bounds_in_reports_are_on_the_safe_side) {
  for (const Sample* sample : {&wide_torus(), &narrow_torus(), &skewed_torus(), &circle(), &disc()})
    expect_safe(sample->document());
  for (const SpaceFormSample* sample : {&icosphere(), &projective_plane(), &klein_bottle(), &bolza_surface()})
    expect_safe(sample->document());
  // 0.130000… rounded to the nearest, or up, would be printed as more than it is.
  for (int k = 1; k <= 20; ++k) {
    Json document = circle().document();
    document["levels"]["1"]["thickness"] = std::to_string(100000 * k - 1) + "/" + std::to_string(10000000 + k);
    document["levels"]["1"]["protection"] = std::to_string(100000 * k - 1) + "/" + std::to_string(1000000000 + k);
    expect_safe(document);
  }
}

}  // namespace
}  // namespace delcert::checker_tests
