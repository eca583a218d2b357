#include "kernel/formula/formula_map.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "kernel/formula/formula_error.hpp"
#include "kernel/number/rounding_guard.hpp"
#include "kernel/number/scalar.hpp"
#include "tests/support/ratio.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

const std::vector<std::string> xyz{"x", "y", "z"};

/// f, Df, D²f of one map at a place.
template <class S>
struct Values {
  std::vector<S> f, df, ddf;
};

template <class S>
Values<S> values_at(const FormulaMap& map, const std::vector<S>& x) {
  const std::size_t n = map.variable_count();
  const std::size_t q = map.function_count();
  Values<S> result{std::vector<S>(q), std::vector<S>(q * n), std::vector<S>(q * n * n)};
  FormulaEvaluation<S> evaluation(map);
  EXPECT_TRUE(evaluation.second(x.data(), result.f.data(), result.df.data(), result.ddf.data()));
  // The programs of lower order say the same.
  Values<S> lower = result;
  EXPECT_TRUE(evaluation.value(x.data(), lower.f.data()));
  EXPECT_TRUE(evaluation.first(x.data(), lower.f.data(), lower.df.data()));
  return result;
}

FormulaMap several() {
  return {xyz,
          {"(x^2 + y^2 + z^2 + 3)^2 - 16*(x^2 + y^2)", "x*y/(2 + z^2) - sqrt(1 + x^2)", "sin(x*y) + cos(z)*exp(x - y)",
           "-(x - y)^3*z^5/7"}};
}

TEST(FormulaMap, has_the_derivatives_that_one_works_out_by_hand) {
  const FormulaMap map(xyz, {"x^2*y - 3*z", "(x + y)^3"});
  const Values<double> at = values_at<double>(map, {2, 3, 5});
  EXPECT_EQ(at.f, (std::vector<double>{-3, 125}));
  EXPECT_EQ(at.df, (std::vector<double>{12, 4, -3, 75, 75, 0}));
  EXPECT_EQ(at.ddf, (std::vector<double>{6, 4, 0, 4, 0, 0, 0, 0, 0, 30, 30, 0, 30, 30, 0, 0, 0, 0}));
}

TEST(FormulaMap, has_the_derivatives_that_differences_tend_to) {
  const BigInterval::Precision precision(PrecisionBits{400});
  const FormulaMap map = several();
  std::mt19937_64 random(7);
  const Rational step = Rational::power_of_two(-60);
  for (int trial = 0; trial < 20; ++trial) {
    std::vector<Rational> x;
    for (int k = 0; k < 3; ++k) x.push_back(ratio(static_cast<long>(random() % 401) - 200, 100));
    const auto shifted = [&](std::size_t axis, const Rational& by) {
      std::vector<BigInterval> result;
      for (std::size_t k = 0; k < 3; ++k) result.emplace_back(k == axis ? x[k] + by : x[k]);
      return values_at<BigInterval>(map, result);
    };
    const auto here = shifted(0, Rational(0));
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto after = shifted(axis, step);
      const auto before = shifted(axis, -step);
      // (g(x + h) − g(x − h))/2h differs from g′(x) by h²·g‴/6, and third and fourth derivatives are less than 2⁴⁰
      // here.
      const auto expect_near = [&](const BigInterval& high, const BigInterval& low, const BigInterval& derivative) {
        const Rational slope = (high.lower() - low.lower()) / (step + step);
        EXPECT_LT(absolute(slope - derivative.lower()), Rational::power_of_two(-75));
        EXPECT_LT(derivative.upper() - derivative.lower(), Rational::power_of_two(-300));
      };
      for (std::size_t k = 0; k < map.function_count(); ++k) {
        expect_near(after.f[k], before.f[k], here.df[k * 3 + axis]);
        for (std::size_t i = 0; i < 3; ++i)
          expect_near(after.df[k * 3 + i], before.df[k * 3 + i], here.ddf[(k * 3 + i) * 3 + axis]);
      }
    }
  }
}

TEST(FormulaMap, encloses_on_boxes_what_it_is_at_points) {
  const FormulaMap map = several();
  std::mt19937_64 random(8);
  for (int trial = 0; trial < 200; ++trial) {
    std::vector<Interval> box;
    std::vector<BigInterval> point;
    for (int k = 0; k < 3; ++k) {
      const double lower = (static_cast<double>(random() % 4001) - 2000) / 1024;
      const double width = static_cast<double>(random() % 1025) / 1024 / (trial % 2 == 0 ? 1 : 1024);
      box.push_back(Interval::between(lower, lower + width));
      const Rational share = ratio(static_cast<long>(random() % 5), 4);
      point.emplace_back(Rational::exactly(lower) + share * Rational::exactly(width));
    }
    const RoundingGuard guard;
    const auto on_box = values_at<Interval>(map, box);
    const auto at_point = values_at<BigInterval>(map, point);
    const auto expect_inside = [](const std::vector<Interval>& outer, const std::vector<BigInterval>& inner) {
      for (std::size_t k = 0; k < outer.size(); ++k) {
        EXPECT_LE(Rational::exactly(outer[k].lower()), inner[k].upper());
        EXPECT_GE(Rational::exactly(outer[k].upper()), inner[k].lower());
      }
    };
    expect_inside(on_box.f, at_point.f);
    expect_inside(on_box.df, at_point.df);
    expect_inside(on_box.ddf, at_point.ddf);
  }
}

TEST(FormulaMap, is_the_same_in_doubles_but_for_rounding) {
  const FormulaMap map = several();
  const auto approximate = values_at<double>(map, {0.5, -0.25, 1.5});
  std::vector<BigInterval> point;
  for (const double x : {0.5, -0.25, 1.5}) point.emplace_back(Rational::exactly(x));
  const auto exact = values_at<BigInterval>(map, point);
  for (std::size_t k = 0; k < approximate.ddf.size(); ++k)
    EXPECT_NEAR(approximate.ddf[k], approximate_double(exact.ddf[k].lower()), 1e-12);
  for (std::size_t k = 0; k < approximate.f.size(); ++k)
    EXPECT_NEAR(approximate.f[k], approximate_double(exact.f[k].lower()), 1e-12);
}

TEST(FormulaMap, says_where_a_value_may_not_be_defined) {
  const FormulaMap map({"x"}, {"1/x + sqrt(x + 1)"});
  double f = 0;
  FormulaEvaluation<double> doubles(map);
  double x = 0;
  EXPECT_FALSE(doubles.value(&x, &f));
  x = -1;
  EXPECT_FALSE(doubles.value(&x, &f));
  x = 3;
  EXPECT_TRUE(doubles.value(&x, &f));
  EXPECT_NEAR(f, 7.0 / 3, 1e-14);
  const RoundingGuard guard;
  FormulaEvaluation<Interval> intervals(map);
  Interval value;
  Interval box = Interval::between(-0x1p-10, 1);
  EXPECT_FALSE(intervals.value(&box, &value));
  box = Interval::between(-1, -0.5);
  EXPECT_FALSE(intervals.value(&box, &value));
  box = Interval::between(-0x1.ffffp-1, -0.5);
  EXPECT_TRUE(intervals.value(&box, &value));
  FormulaEvaluation<BigInterval> big(map);
  BigInterval big_value;
  BigInterval big_box = BigInterval::between(Rational(-1), Rational(2));
  EXPECT_FALSE(big.value(&big_box, &big_value));
  big_box = BigInterval::between(Rational(1), Rational(2));
  EXPECT_TRUE(big.value(&big_box, &big_value));
}

TEST(FormulaMap, asks_for_values_that_it_does_not_use) {
  const FormulaMap map({"x"}, {"x + 0*sqrt(x)"});
  FormulaEvaluation<double> evaluation(map);
  double x = -1;
  double f = 0;
  EXPECT_FALSE(evaluation.value(&x, &f));
  x = 1;
  EXPECT_TRUE(evaluation.value(&x, &f));
}

TEST(FormulaMap, works_out_no_more_than_it_has_to) {
  // Of x²+y²+z² the six second derivatives are constants.
  const FormulaMap map(xyz, {"x^2 + y^2 + z^2"});
  EXPECT_EQ(map.program(0).steps.size(), 8);
  EXPECT_EQ(map.program(2).steps.size(), 8 + 3);
  // The squares of the torus are there once.
  EXPECT_LE(FormulaMap(xyz, {"(x^2 + y^2 + z^2 + 3)^2 - 16*(x^2 + y^2)"}).program(2).steps.size(), 60);
}

TEST(FormulaMap, names_formula_and_place_of_what_it_refuses) {
  const auto error_of = [](const std::vector<std::string>& formulas) {
    try {
      (void)FormulaMap(xyz, formulas);
    } catch (const FormulaError& error) {
      return std::to_string(error.offset()) + " " + error.what();
    }
    return std::string("accepted");
  };
  EXPECT_EQ(error_of({"x", "y + x^z"}), "6 formula 2: an exponent is a whole number from 0 to 100");
  EXPECT_EQ(error_of({"1/(2 - 2)"}), "1 a division by 0");
  EXPECT_EQ(error_of({"y + sqrt(1 - 1)", "x"}), "4 formula 1: the root of a number that is not positive");
  EXPECT_EQ(error_of({"x", "y"}), "accepted");
}

TEST(FormulaMap, has_canonical_texts) {
  EXPECT_EQ(FormulaMap(xyz, {"x ^ 2 - ( 1 )", "- ( y )"}).canonical_texts(), (std::vector<std::string>{"x^2-1", "-y"}));
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
