#include "kernel/formula/trigonometric_polynomial.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "kernel/formula/formula_error.hpp"
#include "kernel/formula/plain_formula.hpp"
#include "tests/support/message_of.hpp"
#include "tests/support/ratio.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

const std::vector<std::string> names = {"u", "v"};

TrigonometricPolynomial read(const std::string& text) {
  return trigonometric_polynomial_of(*parse_plain_formula(text, names), names);
}

/// In doubles.
double value(const TrigonometricPolynomial& f, double u, double v) {
  double result = 0;
  for (const auto& [k, wave] : f.waves()) {
    const double at = k[0] * u + k[1] * v;
    result += approximate_double(wave.cosine) * std::cos(at) + approximate_double(wave.sine) * std::sin(at);
  }
  return result;
}

TEST(TrigonometricPolynomial, has_the_values_of_its_formula) {
  const auto f = read("(2 + cos(v))^3*sin(2*u - v) - 3/4*sin(-u)*cos(v)/5 + (1 - sin(u))*(1 + sin(u))");
  for (const double u : {0.3, -2.0, 5.0}) {
    for (const double v : {0.0, 1.7}) {
      const double expected = std::pow(2 + std::cos(v), 3) * std::sin(2 * u - v) +
                              0.75 * std::sin(u) * std::cos(v) / 5 + std::cos(u) * std::cos(u);
      EXPECT_NEAR(value(f, u, v), expected, 1e-12);
      constexpr double step = 1e-6;
      EXPECT_NEAR(value(f.derivative(0), u, v), (value(f, u + step, v) - value(f, u - step, v)) / (2 * step), 1e-7);
      EXPECT_NEAR(value(f.derivative(1), u, v), (value(f, u, v + step) - value(f, u, v - step)) / (2 * step), 1e-7);
    }
  }
}

TEST(TrigonometricPolynomial, is_written_in_one_way) {
  EXPECT_TRUE(read("cos(u)^2 + sin(u)^2 - 1").waves().empty());
  EXPECT_TRUE(read("sin(u - v) + sin(v - u)").waves().empty());
  EXPECT_TRUE(read("cos(2*u) - 1 + 2*sin(u)^2").waves().empty());
  // The sine of 0 is no wave, whichever products it comes from.
  EXPECT_EQ(read("sin(u)*cos(u)").waves().size(), 1U);
  EXPECT_TRUE(read("sin(0*u)").waves().empty());
  const auto waves = read("cos(v - u)/2").waves();
  ASSERT_EQ(waves.size(), 1U);
  EXPECT_EQ(waves.begin()->first, (std::vector<int>{1, -1}));
  EXPECT_EQ(waves.begin()->second.cosine, ratio(1, 2));
}

std::string refusal(const std::string& text) {
  return message_of<FormulaError>([&] { (void)read(text); });
}

TEST(TrigonometricPolynomial, is_not_every_formula) {
  EXPECT_TRUE(mentions(refusal("u"), "the variable u outside"));
  EXPECT_TRUE(mentions(refusal("sqrt(2)"), "sqrt where"));
  EXPECT_TRUE(mentions(refusal("cos(u/2)"), "no sum of variables"));
  EXPECT_TRUE(mentions(refusal("cos(u*v)"), "no sum of variables"));
  EXPECT_TRUE(mentions(refusal("cos(u + 1)"), "no sum of variables"));
  EXPECT_TRUE(mentions(refusal("cos(1/2*u)"), "no small integer"));
  EXPECT_TRUE(mentions(refusal("1/cos(u)"), "a division by what is no number"));
  EXPECT_TRUE(mentions(refusal("cos(u)/(1 - 1)"), "a division by 0"));
  EXPECT_TRUE(mentions(refusal("(cos(u) + cos(v) + cos(u + v))^100"), "more than 1000 waves"));
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
