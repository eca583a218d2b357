#include "kernel/manifold/quotient/number_field.hpp"

#include <gtest/gtest.h>

#include <random>
#include <stdexcept>

#include "tests/kernel/manifold/quotient/samples.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

/// t³ − t² − 2t + 1 at its largest root, 2cos π/7.
FieldElement::Field heptagon_field() {
  return std::make_shared<const NumberField>(parse_polynomial("t^3 - t^2 - 2*t + 1"), ratio(9, 5), Rational(2));
}

FieldElement some_element(const FieldElement::Field& field, std::mt19937_64& random) {
  std::vector<Rational> coefficients;
  for (long k = 0; k < field->degree(); ++k)
    coefficients.push_back(ratio(static_cast<long>(random() % 19) - 9, static_cast<long>(random() % 4) + 1));
  return {field, coefficients};
}

TEST(NumberField, needs_an_irreducible_polynomial_with_one_root_in_the_interval) {
  const auto refusal = [](const std::string& polynomial, const Rational& lower, const Rational& upper) {
    return message_of<InputError>([&] { NumberField(parse_polynomial(polynomial), lower, upper); });
  };
  EXPECT_EQ(refusal("t^2 - 2", Rational(1), Rational(2)), "accepted");
  EXPECT_TRUE(mentions(refusal("t^2 - 4", Rational(1), Rational(3)), "field polynomial t^2 - 4 is reducible: t "));
  EXPECT_TRUE(mentions(refusal("t^2 - 2*t + 1", Rational(0), Rational(2)), "is reducible: t - 1 divides it"));
  EXPECT_EQ(refusal("t^2 - 2", Rational(-2), Rational(2)), "field polynomial has 2 roots in [-2, 2], expected one");
  EXPECT_EQ(refusal("t^2 + 2", Rational(-2), Rational(2)), "field polynomial has 0 roots in [-2, 2], expected one");
  EXPECT_EQ(refusal("3", Rational(0), Rational(2)), "field polynomial 3 is constant");
}

TEST(FieldElement, computes_in_the_golden_field) {
  const auto field = golden_field();
  const FieldElement t = element(field, "t");
  EXPECT_EQ(t * t, t + FieldElement(1));
  EXPECT_EQ(FieldElement(1) / t, t - FieldElement(1));
  EXPECT_EQ((FieldElement(2) * t - FieldElement(1)) * (FieldElement(2) * t - FieldElement(1)), FieldElement(5));
  EXPECT_EQ(t.sign(), 1);
  EXPECT_EQ((t - FieldElement(ratio(1618033988, 1000000000))).sign(), 1);
  EXPECT_EQ((t - FieldElement(ratio(1618033989, 1000000000))).sign(), -1);
  EXPECT_EQ((t * t - t - FieldElement(1)).sign(), 0);
  EXPECT_FALSE(t == FieldElement(ratio(1618033988, 1000000000)));
}

TEST(FieldElement, obeys_the_laws_of_a_field) {
  std::mt19937_64 random(1);
  const auto field = heptagon_field();
  for (int trial = 0; trial < 50; ++trial) {
    const FieldElement a = some_element(field, random);
    const FieldElement b = some_element(field, random);
    const FieldElement c = some_element(field, random);
    EXPECT_EQ(a * (b + c), a * b + a * c);
    EXPECT_EQ((a * b) * c, a * (b * c));
    EXPECT_EQ(a - b, -(b - a));
    EXPECT_TRUE((a - a).is_zero());
    if (!b.is_zero()) {
      EXPECT_EQ(a / b * b, a);
    }
    EXPECT_EQ(element(field, a.text()), a);
    EXPECT_EQ(FieldElement(field, a.coefficients()), a);
    // The values in the embedding are those of the algebraic numbers of another library.
    const Algebraic t = real_roots(parse_polynomial("t^3 - t^2 - 2*t + 1")).back();
    Algebraic value(0);
    const auto coefficients = a.coefficients();
    for (auto k = coefficients.size(); k-- > 0;) value = value * t + Algebraic(coefficients[k]);
    const BigInterval enclosure = a.enclosure();
    EXPECT_TRUE(is_proved(less_equal(Algebraic(enclosure.lower()), value)));
    EXPECT_TRUE(is_proved(less_equal(value, Algebraic(enclosure.upper()))));
    EXPECT_EQ(a.sign() > 0, is_proved(less(Algebraic(0), value)));
    EXPECT_EQ(a.sign() == 0, is_proved(is_zero(value)));
  }
}

TEST(FieldElement, decides_signs_that_need_many_bits) {
  const auto field = golden_field();
  // t is between quotients of Fibonacci numbers: the 300th is closer than 2⁻⁴⁰⁰.
  Integer a = 1;
  Integer b = 1;
  for (int k = 0; k < 300; ++k) {
    const Integer next = a + b;
    a = b;
    b = next;
  }
  const FieldElement t = element(field, "t");
  const int below = (t - FieldElement(Rational(b, a))).sign();
  const int above = (t - FieldElement(Rational(Integer(a + b), b))).sign();
  EXPECT_NE(below, 0);
  EXPECT_EQ(below, -above);
}

TEST(FieldElement, rational_elements_belong_to_every_field) {
  const auto field = golden_field();
  EXPECT_EQ(FieldElement(field, {ratio(1, 2)}), FieldElement(ratio(1, 2)));
  EXPECT_EQ(FieldElement(ratio(1, 2)).rational(), ratio(1, 2));
  EXPECT_THROW((void)element(field, "t").rational(), std::domain_error);
  EXPECT_THROW((void)(FieldElement(1) / FieldElement(0)), std::domain_error);
  EXPECT_THROW((void)(element(field, "t") + element(heptagon_field(), "t")), std::logic_error);
  EXPECT_THROW((void)FieldElement(nullptr, {Rational(0), Rational(1)}), std::logic_error);
}

TEST(FieldElement, can_be_moved_and_assigned) {
  const auto field = golden_field();
  FieldElement a = element(field, "t + 1");
  FieldElement b = std::move(a);
  EXPECT_EQ(b.text(), "t + 1");
  a = b;
  EXPECT_EQ(a, b);
  a = FieldElement(3);
  EXPECT_EQ(a.text(), "3");
  EXPECT_TRUE(precedes(a, b) != precedes(b, a));
  EXPECT_FALSE(precedes(b, b));
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
