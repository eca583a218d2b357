#include "proofs/checker/arithmetic/formula_map.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "tests/checker/support/exact_double.hpp"
#include "tests/checker/upwards.hpp"

namespace delcert::checker_tests {
namespace {

using namespace checker;

const std::vector<std::string_view> variables = {"x", "y", "long_name2"};

Matrix<Interval> point(double x, double y, double z) {
  Matrix<Interval> result(3, 1);
  result[0] = Interval::between(x, x);
  result[1] = Interval::between(y, y);
  result[2] = Interval::between(z, z);
  return result;
}

double middle(const Interval& x) { return (x.lower() + x.upper()) / 2; }

struct FormulaOfChecker : testing::Test, test::Upwards {};

/// The value at a point, from its formula, and as an expression of C++ has it.
struct Example {
  const char* formula;
  double (*value)(double x, double y, double z);
};

const Example examples[] = {
    {"x+y*long_name2", [](double x, double y, double z) { return x + y * z; }},
    {"-x^2*y", [](double x, double y, double) { return -(x * x) * y; }},
    {"x*-y^3", [](double x, double y, double) { return -x * y * y * y; }},
    {"--x", [](double x, double, double) { return x; }},
    {"x-y-1", [](double x, double y, double) { return x - y - 1; }},
    {"x/y/2", [](double x, double y, double) { return x / y / 2; }},
    {"x/(y/2)", [](double x, double y, double) { return x / (y / 2); }},
    {"(x+y)^5", [](double x, double y, double) { return std::pow(x + y, 5); }},
    {"x^0+y^1", [](double, double y, double) { return 1 + y; }},
    {"sqrt(x^2+long_name2)", [](double x, double, double z) { return std::sqrt(x * x + z); }},
    {"exp(x*y)-cos(long_name2)", [](double x, double y, double z) { return std::exp(x * y) - std::cos(z); }},
    {"sin(x)*sin(x)*y", [](double x, double y, double) { return std::sin(x) * std::sin(x) * y; }},
    {"1/(1+x^2)", [](double x, double, double) { return 1 / (1 + x * x); }},
    {"(2*x-3/7)*(y-x)/(x+long_name2)^3",
     [](double x, double y, double z) { return (2 * x - 3.0 / 7) * (y - x) / std::pow(x + z, 3); }},
};

TEST_F(FormulaOfChecker, has_the_values_and_derivatives_that_differences_give) {
  for (const Example& example : examples) {
    SCOPED_TRACE(example.formula);
    const FormulaMap map(variables, {example.formula});
    FormulaValues<Interval> values(map);
    FormulaValues<Ball> balls(map);
    const std::array<double, 3> x = {0.625, -0.75, 1.25};
    values.evaluate(point(x[0], x[1], x[2]), 2);
    Matrix<Ball> exact_place(3, 1);
    for (std::size_t k = 0; k < 3; ++k) exact_place[k] = Ball(exact(x[k]));
    balls.evaluate(exact_place, 2);
    const auto near = [](const Interval& enclosure, const Ball& ball, double value, double error) {
      EXPECT_LT(enclosure.upper() - enclosure.lower(), 1e-12);
      EXPECT_NEAR(middle(enclosure), value, error);
      const Interval narrow = ball.enclosure();  // the two enclose the same number
      EXPECT_LE(enclosure.lower(), narrow.upper());
      EXPECT_LE(narrow.lower(), enclosure.upper());
    };
    near(values.value(0), balls.value(0), example.value(x[0], x[1], x[2]), 1e-12);
    constexpr double h = 0x1p-12;
    const auto at = [&](std::size_t k, double s, std::size_t l, double t) {
      std::array<double, 3> y = x;
      y[k] += s * h;
      y[l] += t * h;
      return example.value(y[0], y[1], y[2]);
    };
    for (std::size_t k = 0; k < 3; ++k) {
      near(values.jacobian()(0, k), balls.jacobian()(0, k), (at(k, 1, k, 0) - at(k, -1, k, 0)) / (2 * h), 1e-5);
      for (std::size_t l = 0; l < 3; ++l) {
        const double second = (at(k, 1, l, 1) - at(k, 1, l, -1) - at(k, -1, l, 1) + at(k, -1, l, -1)) / (4 * h * h);
        near(values.second(0, k, l), balls.second(0, k, l), second, 1e-4);
      }
    }
  }
}

TEST_F(FormulaOfChecker, encloses_values_and_derivatives_on_boxes) {
  for (const Example& example : examples) {
    SCOPED_TRACE(example.formula);
    const FormulaMap map(variables, {example.formula});
    FormulaValues<Interval> whole(map), single(map);
    Matrix<Interval> box(3, 1);
    box[0] = Interval::between(0.25, 0.5);
    box[1] = Interval::between(-0.75, -0.5);
    box[2] = Interval::between(1, 1.125);
    whole.evaluate(box, 2);
    for (int at = 0; at < 27; ++at) {
      const double s = at % 3 / 2.0, t = at / 3 % 3 / 2.0, u = at / 9 / 2.0;
      single.evaluate(point(0.25 + s / 4, -0.75 + t / 4, 1 + u / 8), 2);
      const auto meets = [](const Interval& wide, const Interval& narrow) {
        EXPECT_LE(wide.lower(), narrow.lower() + 1e-12);
        EXPECT_GE(wide.upper(), narrow.upper() - 1e-12);
      };
      meets(whole.value(0), single.value(0));
      for (std::size_t k = 0; k < 3; ++k) {
        meets(whole.jacobian()(0, k), single.jacobian()(0, k));
        for (std::size_t l = 0; l < 3; ++l) meets(whole.second(0, k, l), single.second(0, k, l));
      }
    }
  }
}

TEST_F(FormulaOfChecker, what_may_not_be_defined_is_not_enclosed) {
  for (const char* formula : {"1/x", "0*(1/x)", "sqrt(x)", "0*sqrt(x-1)", "(1/x)^0", "0/0", "sqrt(0)"}) {
    const FormulaMap map(variables, {formula});
    FormulaValues<Interval> values(map);
    values.evaluate(point(0, 1, 1), 2);
    EXPECT_TRUE(std::isinf(values.value(0).lower()) && std::isinf(values.value(0).upper())) << formula;
    FormulaValues<Ball> balls(map);
    balls.evaluate(Matrix<Ball>(3, 1), 0);
    EXPECT_EQ(arb_is_finite(balls.value(0).raw()), 0) << formula;
  }
}

TEST_F(FormulaOfChecker, the_same_operation_is_done_once) {
  const FormulaMap map(variables, {"(x^2+y^2)^2-(x^2+y^2)", "x^2+y^2"});
  EXPECT_EQ(map.function_count(), 2U);
  EXPECT_EQ(map.steps().size(), 7U);  // x, x^2, y, y^2, their sum, its square, the difference
}

}  // namespace
}  // namespace delcert::checker_tests
