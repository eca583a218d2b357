#include "proofs/prover/bernstein.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <stdexcept>

#include "tests/proofs/prover/prove_text.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

using test::ratio;

const RingPointer ring = std::make_shared<const PolynomialRing>(std::vector<std::string>{"x", "y"});
const Polynomial x = Polynomial::variable(ring, 0);
const Polynomial y = Polynomial::variable(ring, 1);
Polynomial number(const Rational& value) { return {ring, value}; }

Rational value(const Polynomial& p, const Rational& at_x, const Rational& at_y) {
  Rational sum(0);
  for (const auto& term : p.terms()) {
    sum += term.coefficient * power(at_x, static_cast<long>(term.exponents[0])) *
           power(at_y, static_cast<long>(term.exponents[1]));
  }
  return sum;
}

Rational binomial(unsigned long n, unsigned long k) {
  Rational result(1);
  for (unsigned long i = 0; i < k; ++i) result = result * Rational(n - i) / Rational(i + 1);
  return result;
}

/// Σ b_I Π C(d, j) t^j (1 − t)^(d − j) at a point of the unit square.
Rational value(const BernsteinTensor& tensor, const Rational& s, const Rational& t) {
  Rational sum(0);
  std::size_t at = 0;
  for (unsigned long i = 0; i <= tensor.degrees()[0]; ++i) {
    for (unsigned long j = 0; j <= tensor.degrees()[1]; ++j, ++at) {
      fmpz* coefficient = const_cast<fmpz*>(tensor.coefficients().at(at));
      mpz_t raw;
      mpz_init(raw);
      fmpz_get_mpz(raw, coefficient);
      const Rational b{Integer(raw)};
      mpz_clear(raw);
      const auto basis = [](unsigned long d, unsigned long k, const Rational& u) {
        return binomial(d, k) * power(u, static_cast<long>(k)) * power(Rational(1) - u, static_cast<long>(d - k));
      };
      sum += b * basis(tensor.degrees()[0], i, s) * basis(tensor.degrees()[1], j, t);
    }
  }
  return sum;
}

constexpr std::size_t many = 10000;
const std::vector<OpenEnds> closed{{}, {}};
const UnitMap unit{Rational(0), Rational(1)};

TEST(Bernstein, signs_multiply) {
  EXPECT_EQ(product(Sign::negative, Sign::negative), Sign::positive);
  EXPECT_EQ(product(Sign::negative, Sign::nonnegative), Sign::nonpositive);
  EXPECT_EQ(product(Sign::zero, Sign::unknown), Sign::zero);
  EXPECT_EQ(product(Sign::positive, Sign::unknown), Sign::unknown);
  EXPECT_EQ(even_power(Sign::unknown), Sign::nonnegative);
  EXPECT_EQ(even_power(Sign::negative), Sign::positive);
  EXPECT_EQ(opposite(Sign::nonpositive), Sign::nonnegative);
  EXPECT_EQ(name_of(Sign::nonpositive), "nonpositive");
}

TEST(Bernstein, maps_of_the_unit_interval) {
  const UnitMap bounded{ratio(1, 2), Rational(3)};
  EXPECT_EQ(*bounded.at(ratio(1, 5)), Rational(1));
  EXPECT_EQ(bounded.inverse(Rational(1)), ratio(1, 5));
  const UnitMap up{Rational(2), std::nullopt};
  EXPECT_EQ(*up.at(ratio(1, 2)), Rational(3));
  EXPECT_FALSE(up.at(Rational(1)));
  EXPECT_EQ(up.inverse(Rational(3)), ratio(1, 2));
  const UnitMap down{std::nullopt, Rational(2)};
  EXPECT_EQ(*down.at(ratio(1, 2)), Rational(1));
  EXPECT_EQ(*down.at(Rational(1)), Rational(2));
  EXPECT_FALSE(down.at(Rational(0)));
  EXPECT_EQ(down.inverse(Rational(1)), ratio(1, 2));
}

TEST(Bernstein, faces_that_belong_to_the_box_decide_strictness) {
  const auto sign = [](const Polynomial& p, const std::vector<OpenEnds>& open) {
    return BernsteinTensor(p, {unit, unit}, many).sign(open);
  };
  EXPECT_EQ(sign(x + y, closed), Sign::nonnegative);
  EXPECT_EQ(sign(x + y, {{true, false}, {}}), Sign::positive);
  EXPECT_EQ(sign(x * y, {{true, false}, {}}), Sign::nonnegative);
  EXPECT_EQ(sign(x * y, {{true, false}, {true, false}}), Sign::positive);
  EXPECT_EQ(sign(-(x * y), {{true, true}, {true, true}}), Sign::negative);
  EXPECT_EQ(sign(x * (number(1) - x), {{true, true}, {}}), Sign::positive);
  EXPECT_EQ(sign(x * (number(1) - x), {{true, false}, {}}), Sign::nonnegative);
  EXPECT_EQ(sign(x - y, closed), Sign::unknown);
  EXPECT_EQ(sign(number(-2), closed), Sign::negative);
}

TEST(Bernstein, parts_add_up) {
  const Polynomial p = x * x - x + number(ratio(26, 100));
  const BernsteinTensor whole(p, {unit, unit}, many);
  EXPECT_EQ(whole.sign(closed), Sign::unknown);
  EXPECT_EQ(whole.left_of(0, ratio(1, 2)).sign(closed), Sign::positive);
  EXPECT_EQ(whole.right_of(0, ratio(1, 2)).sign(closed), Sign::positive);
  EXPECT_EQ(whole.left_of(0, ratio(1, 3)).sign(closed), Sign::positive);
}

TEST(Bernstein, ranges_without_end) {
  const UnitMap up{Rational(1), std::nullopt};
  const std::vector<OpenEnds> open{{false, true}, {}};
  EXPECT_EQ(BernsteinTensor(x * x - x, {up, unit}, many).sign(open), Sign::nonnegative);
  EXPECT_EQ(BernsteinTensor(x * x - x + number(1), {up, unit}, many).sign(open), Sign::positive);
  EXPECT_EQ(BernsteinTensor(number(1000) - x, {up, unit}, many).sign(open), Sign::unknown);
  const UnitMap down{std::nullopt, Rational(-1)};
  EXPECT_EQ(BernsteinTensor(x * x * x, {down, unit}, many).sign({{true, false}, {}}), Sign::negative);
  EXPECT_EQ(BernsteinTensor(x + number(1), {down, unit}, many).sign({{true, false}, {}}), Sign::nonpositive);
  EXPECT_EQ(BernsteinTensor(x + number(1), {down, unit}, many).sign({{true, true}, {}}), Sign::negative);
}

TEST(Bernstein, too_many_coefficients_are_refused) {
  EXPECT_THROW(BernsteinTensor(x.power(99) * y.power(99), {unit, unit}, 9999), std::length_error);
  EXPECT_NO_THROW(BernsteinTensor(x.power(9) * y.power(9), {unit, unit}, 100));
}

TEST(Bernstein, variation_shows_which_variable_matters) {
  const BernsteinTensor tensor(number(8) * x + y, {unit, unit}, many);
  EXPECT_GT(tensor.approximate_variation(0), 4 * tensor.approximate_variation(1));
}

RC_GTEST_PROP(Bernstein, coefficients_are_those_of_the_polynomial, ()) {
  Polynomial p = number(1) + x.power(2) + y.power(2);
  for (int i = 0; i < 6; ++i) {
    p = p + number(ratio(*rc::gen::inRange(-9, 9), *rc::gen::inRange(1, 5))) *
                x.power(static_cast<unsigned long>(*rc::gen::inRange(0, 4))) *
                y.power(static_cast<unsigned long>(*rc::gen::inRange(0, 3)));
  }
  const UnitMap bounded{ratio(*rc::gen::inRange(-9, 0), 4), ratio(*rc::gen::inRange(1, 9), 4)};
  const Rational end = ratio(*rc::gen::inRange(-9, 9), 4);
  const bool up = *rc::gen::arbitrary<bool>();
  const UnitMap other = up ? UnitMap{end, std::nullopt} : UnitMap{std::nullopt, end};
  BernsteinTensor tensor(p, {bounded, other}, many);
  // On a part of the square, to which the tensor is restricted.
  const Rational cut = ratio(*rc::gen::inRange(1, 4), 4);
  const bool left = *rc::gen::arbitrary<bool>();
  const std::size_t variable = *rc::gen::inRange<std::size_t>(0, 2);
  tensor = left ? tensor.left_of(variable, cut) : tensor.right_of(variable, cut);
  std::optional<Rational> scale;
  for (const Rational& u : {ratio(1, 5), ratio(1, 2), ratio(6, 7)}) {
    Rational at[2] = {u, ratio(2, 3)};
    const Rational part[2] = {at[0], at[1]};
    at[variable] = left ? cut * at[variable] : cut + (Rational(1) - cut) * at[variable];
    const Rational weight = power(up ? Rational(1) - at[1] : at[1], static_cast<long>(tensor.degrees()[1]));
    const Rational expected = value(p, *bounded.at(at[0]), *other.at(at[1])) * weight;
    const Rational found = value(tensor, part[0], part[1]);
    if (expected == Rational(0)) {
      RC_ASSERT(found == Rational(0));
      continue;
    }
    RC_ASSERT(found / expected > Rational(0));
    if (scale) RC_ASSERT(found / expected == *scale);
    scale = found / expected;
  }
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
