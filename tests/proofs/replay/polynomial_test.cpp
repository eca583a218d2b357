#include "proofs/replay/polynomial.hpp"

#include <gtest/gtest.h>

namespace delcert::replay {
namespace DELCERT_THIS_FILE {

const Variables variables({"x", "y"});

Polynomial polynomial(const std::string& text) { return Polynomial::read(text, variables); }

Side side(const char* lower, bool lower_open, const char* upper, bool upper_open) {
  Side result;
  if (lower != nullptr) result.lower = Number::read(lower);
  if (upper != nullptr) result.upper = Number::read(upper);
  result.lower_open = lower_open;
  result.upper_open = upper_open;
  return result;
}

const Side unit = side("0", false, "1", false);
const Side half_open = side("0", true, "1", false);

TEST(ReplayPolynomials, are_read) {
  EXPECT_EQ(polynomial("-1/2*x^2*y + 3"),
            Polynomial(variables, Number(3)) - Polynomial(variables, Number::read("1/2")) * polynomial("x").power(2) *
                                                   Polynomial::variable(1, variables));
  EXPECT_THROW((void)polynomial("x +"), Malformed);
  EXPECT_THROW((void)polynomial("z"), Malformed);
  EXPECT_TRUE(polynomial("x^2").depends_on(0) && !polynomial("x^2").depends_on(1));
  EXPECT_TRUE(polynomial("2*x").has_integer_coefficients() && !polynomial("1/2*x").has_integer_coefficients());
}

TEST(ReplayPolynomials, have_signs_on_boxes) {
  EXPECT_EQ(polynomial("x + y").sign_on({unit, unit}), 1);
  EXPECT_EQ(polynomial("x + y").sign_on({half_open, unit}), 2);
  EXPECT_EQ(polynomial("-x*y").sign_on({half_open, unit}), -1);
  EXPECT_EQ(polynomial("-x*y").sign_on({half_open, half_open}), -2);
  EXPECT_EQ(polynomial("x - y").sign_on({unit, unit}), std::nullopt);
  EXPECT_EQ(polynomial("x - x").sign_on({unit, unit}), 0);
  EXPECT_EQ(polynomial("x^2 - x + 1").sign_on({side("1", false, nullptr, true), unit}), 2);
  EXPECT_EQ(polynomial("x^2 - x").sign_on({side("1", false, nullptr, true), unit}), 1);
  EXPECT_EQ(polynomial("x^3").sign_on({side(nullptr, true, "-1", false), unit}), -2);
  EXPECT_EQ(polynomial("x + 1").sign_on({side(nullptr, true, "-1", false), unit}), -1);
  EXPECT_EQ(polynomial("x + 1").sign_on({side(nullptr, true, "-1", true), unit}), -2);
  EXPECT_EQ(polynomial("x - 1/2").sign_on({side("1/2", false, "1/2", false), unit}), 0);
}

TEST(ReplayPolynomials, of_squared_parameters_run_through_their_roots) {
  Side squared = side("2", false, "4", false);
  squared.is_squared = true;
  const Side root = variable_side(squared);
  EXPECT_TRUE(*root.lower * *root.lower < Number(2) && root.lower_open);
  EXPECT_TRUE(*root.upper == Number(2) && !root.upper_open);
  squared.lower = Number(-1);
  EXPECT_THROW((void)variable_side(squared), Rejected);
}

TEST(ReplayFractions, are_read_from_terms) {
  const std::vector<std::vector<Side>> boxes{{half_open, unit}};
  FractionReader reader(variables, boxes);
  const Fraction fraction = reader.read(*read_statement("(/ (- (^ x 2) (^ y 2)) (- x y))"));
  EXPECT_EQ(fraction.numerator, polynomial("x + y") * fraction.denominator);
  ASSERT_EQ(reader.divisors.size(), 1U);
  EXPECT_EQ(reader.divisors[0], polynomial("x - y"));
  const Fraction root = reader.read(*read_statement("(sqrt (^ (- x 2) 2))"));
  EXPECT_EQ(root.numerator, polynomial("2 - x") * root.denominator);
  EXPECT_THROW((void)reader.read(*read_statement("(sqrt (^ (- x y) 2))")), Rejected);
  EXPECT_THROW((void)reader.read(*read_statement("(sqrt x)")), Rejected);
  EXPECT_THROW((void)reader.read(*read_statement("(log2 x)")), Rejected);
  EXPECT_THROW((void)reader.read(*read_statement("(/ x (- x x))")), Rejected);
  EXPECT_THROW((void)reader.read(*read_statement("(^ 2 x)")), Rejected);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::replay
