// Formulas that are read, with first and second derivatives worked out for a program, against the same functions
// written in C++ on balls of Arb with derivatives by the rules for jets: at points that lie in boxes, and on boxes
// around points.

#include <gtest/gtest.h>

#include <random>
#include <string>

#include "kernel/formula/formula_map.hpp"
#include "kernel/number/rounding_guard.hpp"
#include "tests/oracles/arb_jet.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

struct Function {
  const char* formula;
  ArbJet (*jet)(const ArbJet& x, const ArbJet& y, const ArbJet& z);
};

ArbJet squared(const ArbJet& a) { return a * a; }

const Function functions[] = {
    {"(x^2 + y^2 + z^2 + 3)^2 - 16*(x^2 + y^2)",
     [](const ArbJet& x, const ArbJet& y, const ArbJet& z) {
       return squared(x * x + y * y + z * z + 3) - 16 * (x * x + y * y);
     }},
    {"(x^2 - x^4 - y^2)^2 + z^2/2 - 1/40",
     [](const ArbJet& x, const ArbJet& y, const ArbJet& z) {
       return squared(x * x - x * x * x * x - y * y) + z * z / 2 - ArbJet(1) / 40;
     }},
    {"exp(-(x - 1)^2 - y^2 - z^2) + exp(-(x + 1)^2 - y^2 - z^2) - 1/2",
     [](const ArbJet& x, const ArbJet& y, const ArbJet& z) {
       const ArbJet rest = y * y + z * z;
       return exp(0 - squared(x - 1) - rest) + exp(0 - squared(x + 1) - rest) - ArbJet(1) / 2;
     }},
    {"sin(x*y)*cos(z) - x*y/(2 + z^2)*sqrt(4 + x*z)",
     [](const ArbJet& x, const ArbJet& y, const ArbJet& z) {
       return sin(x * y) * cos(z) - x * y / (2 + z * z) * sqrt(4 + x * z);
     }},
};

using Ends = std::pair<Rational, Rational>;

bool meet(const Ends& a, const Ends& b) { return a.first <= b.second && b.first <= a.second; }

/// How many of f, Df and D²f, 13 numbers, are apart: enclosures by the formula on the one box, by jets on the other.
int disagreements(const std::string& formula, const Function& function, const std::array<Interval, 3>& box,
                  const std::array<Interval, 3>& box_of_jets) {
  const FormulaMap map({"x", "y", "z"}, {formula});
  std::array<Interval, 13> found;
  {
    const RoundingGuard guard;
    FormulaEvaluation<Interval> evaluation(map);
    EXPECT_TRUE(evaluation.second(box.data(), &found[0], &found[1], &found[4])) << formula;
  }
  std::array<ArbJet, 3> place;
  for (std::size_t axis = 0; axis < 3; ++axis)
    place[axis] = ArbJet::variable(axis, box_of_jets[axis].lower(), box_of_jets[axis].upper());
  const auto ends = function.jet(place[0], place[1], place[2]).ends();
  int result = 0;
  for (std::size_t at = 0; at < found.size(); ++at) {
    const Ends ours{Rational::exactly(found[at].lower()), Rational::exactly(found[at].upper())};
    if (!meet(ours, ends[at])) ++result;
  }
  return result;
}

/// A box between −3/2 and 3/2, and a point of it.
std::pair<std::array<Interval, 3>, std::array<Interval, 3>> box_and_point(std::mt19937_64& random) {
  std::pair<std::array<Interval, 3>, std::array<Interval, 3>> result;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double lower = std::ldexp(static_cast<double>(random() % 2049) - 1024, -10);
    const double width = std::ldexp(static_cast<double>(random() % 513), random() % 2 == 0 ? -10 : -30);
    const double inside = lower + std::ldexp(static_cast<double>(random() % 257), -8) * width;
    result.first[axis] = Interval::between(lower, lower + width);
    result.second[axis] = Interval::between(inside, inside);
  }
  return result;
}

TEST(FormulaDerivatives, on_boxes_contain_those_of_arb_at_their_points) {
  std::mt19937_64 random(1);
  for (const Function& function : functions) {
    for (int trial = 0; trial < 100; ++trial) {
      const auto [box, point] = box_and_point(random);
      EXPECT_EQ(disagreements(function.formula, function, box, point), 0) << function.formula;
    }
  }
}

TEST(FormulaDerivatives, at_points_are_in_those_of_arb_on_boxes) {
  std::mt19937_64 random(2);
  for (const Function& function : functions) {
    for (int trial = 0; trial < 100; ++trial) {
      const auto [box, point] = box_and_point(random);
      EXPECT_EQ(disagreements(function.formula, function, point, box), 0) << function.formula;
    }
  }
}

TEST(FormulaDerivatives, of_another_function_are_other_ones) {
  // The twin. A term of which f, Df and D²f have a millionth changes all of them but for the second derivatives along
  // the axes.
  std::mt19937_64 random(3);
  for (const Function& function : functions) {
    int different = 0;
    for (int trial = 0; trial < 100; ++trial) {
      const auto point = box_and_point(random).second;
      different += disagreements(function.formula + std::string(" + x*y*z/1000000"), function, point, point);
    }
    EXPECT_GT(different, 900) << function.formula;
    EXPECT_LE(different, 1000) << function.formula;
  }
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
