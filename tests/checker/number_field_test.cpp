#include "proofs/checker/arithmetic/number_field.hpp"

#include <gtest/gtest.h>

#include "proofs/checker/arithmetic/exact_number.hpp"
#include "proofs/checker/arithmetic/square_matrix.hpp"
#include "tests/checker/upwards.hpp"

namespace delcert::checker_tests {
namespace {

using checker::exact_value;
using checker::FieldElement;
using checker::NumberField;
using checker::Rational;

class NumberFields : public testing::Test {
 protected:
  const test::Upwards upwards;
};

std::vector<Rational> numbers(const std::vector<std::string>& texts) {
  std::vector<Rational> result;
  for (const std::string& text : texts) result.push_back(exact_value(text));
  return result;
}

TEST_F(NumberFields, know_the_signs_of_elements_that_are_almost_0) {
  const NumberField field(numbers({"-2", "0", "1"}), Rational(1), Rational(2));
  // Convergents of the root of 2 are below and above it in turn.
  Rational p(1), q(1);
  for (int k = 0; k < 400; ++k) {
    const FieldElement difference(field, {-(p / q), Rational(1)});
    EXPECT_EQ(difference.sign(), k % 2 == 0 ? 1 : -1);
    EXPECT_FALSE(difference.is_zero());
    const Rational next = p + Rational(2) * q;
    q = p + q;
    p = next;
  }
}

TEST_F(NumberFields, have_the_root_that_is_meant) {
  const NumberField below(numbers({"-2", "0", "1"}), Rational(-2), Rational(-1));
  EXPECT_EQ(FieldElement(below, numbers({"0", "1"})).sign(), -1);
  // The three roots of t^3 - t^2 - 2t + 1: about -1.25, 0.45, 1.80.
  const std::vector<Rational> cubic = numbers({"1", "-2", "-1", "1"});
  const NumberField first(cubic, exact_value("-3/2"), Rational(-1)),
      second(cubic, exact_value("1/4"), exact_value("1/2")), third(cubic, exact_value("9/5"), Rational(2));
  EXPECT_EQ(FieldElement(first, numbers({"1", "1"})).sign(), -1);
  EXPECT_EQ(FieldElement(second, numbers({"-4/9", "1"})).sign(), 1);
  EXPECT_EQ(FieldElement(third, numbers({"-9/5", "1"})).sign(), 1);
}

TEST_F(NumberFields, divide_and_reduce_exactly) {
  const NumberField field(numbers({"1", "-2", "-1", "1"}), exact_value("9/5"), Rational(2));
  const FieldElement t(field, numbers({"0", "1"})), x(field, numbers({"3", "-1/2", "7"}));
  EXPECT_TRUE((t * t * t - t * t - t - t + FieldElement(1)).is_zero());
  EXPECT_TRUE(x / x == FieldElement(1));
  EXPECT_TRUE((t / x) * x == t);
  EXPECT_TRUE(x / FieldElement(2) + x / FieldElement(2) == x);
  EXPECT_FALSE(x == t);
}

TEST_F(NumberFields, carry_matrices_whose_definiteness_is_decided) {
  const NumberField field(numbers({"-2", "0", "1"}), Rational(1), Rational(2));
  const FieldElement t(field, numbers({"0", "1"}));
  checker::FieldMatrix a = checker::FieldMatrix::identity(2);
  a(0, 0) = t;
  a(1, 1) = t;
  a(0, 1) = a(1, 0) = FieldElement(field, {exact_value("7/5")});
  EXPECT_EQ(is_positive_definite(a), checker::Verdict::proved);  // 2 > 49/25
  a(0, 1) = a(1, 0) = FieldElement(field, {exact_value("17/12")});
  EXPECT_EQ(is_positive_definite(a), checker::Verdict::refuted);  // 2 < 289/144
  EXPECT_TRUE(a.leading_minor(2) == FieldElement(field, {exact_value("-1/144")}));
}

}  // namespace
}  // namespace delcert::checker_tests
