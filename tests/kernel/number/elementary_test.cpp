#include "kernel/number/elementary.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "kernel/number/rounding_guard.hpp"
#include "tests/kernel/number/arb_reference.hpp"
#include "tests/support/ratio.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

template <class Ours, class Theirs>
void expect_enclosure(const Ours& ours, const Theirs& theirs, const Rational& x) {
  const ArbReference reference = ArbReference(x).with(theirs);
  for (const unsigned bits : {24U, 53U, 128U, 300U}) {
    const BigInterval::Precision precision(PrecisionBits{bits});
    const BigInterval value = ours(BigInterval(x));
    ASSERT_TRUE(lies_between(reference, value.lower(), value.upper()));
    const Rational width = value.upper() - value.lower();
    const Rational allowed =
        maximum(Rational(1), absolute(value.upper())) *
        Rational::power_of_two(6 + 2 * binary_exponent(maximum(Rational(1), absolute(x))) - static_cast<long>(bits));
    EXPECT_LE(width, allowed * Rational(1000));
    // The twin that must fail: the same interval moved by twice its width.
    if (width > Rational(0)) {
      EXPECT_FALSE(lies_between(reference, value.lower() + width + width, value.upper() + width + width));
    }
  }
}

TEST(Elementary, agrees_with_another_library) {
  std::mt19937_64 random(3);
  for (int trial = 0; trial < 60; ++trial) {
    const Rational unit = ratio(static_cast<long>(random() % 199) - 99, 100);
    const Rational x = unit * Rational(4);
    expect_enclosure(sine, arb_sin, x);
    expect_enclosure(cosine, arb_cos, x);
    expect_enclosure(hyperbolic_sine, arb_sinh, x);
    expect_enclosure(hyperbolic_cosine, arb_cosh, x);
    expect_enclosure(arctangent, arb_atan, x);
    expect_enclosure(area_tangent, arb_atanh, unit);
    expect_enclosure(arccosine, arb_acos, unit);
    expect_enclosure(area_cosine, arb_acosh, ratio(101, 100) + absolute(x));
  }
}

TEST(Elementary, encloses_pi) {
  const ArbReference pi =
      ArbReference().with([](arb_ptr result, arb_srcptr, slong bits) { arb_const_pi(result, bits); });
  const BigInterval ours = half_turn();
  EXPECT_TRUE(lies_between(pi, ours.lower(), ours.upper()));
  EXPECT_LE(ours.upper() - ours.lower(), Rational::power_of_two(-125));
  EXPECT_FALSE(lies_between(pi, ratio(22, 7), ratio(23, 7)));
}

TEST(Elementary, cuts_off_what_cannot_be_and_opens_up_at_poles) {
  const BigInterval wide = BigInterval::between(Rational(-2), ratio(1, 2));
  EXPECT_GE(arccosine(wide).upper(), half_turn().lower());
  EXPECT_EQ(area_cosine(BigInterval::between(Rational(0), Rational(1))).upper(), Rational(0));
  EXPECT_FALSE(area_tangent(BigInterval(1)).is_bounded());
  EXPECT_TRUE(area_tangent(BigInterval(ratio(99, 100))).is_bounded());
}

TEST(Elementary, takes_intervals_apart_and_together) {
  const BigInterval x = BigInterval::between(ratio(1, 3), ratio(2, 3));
  EXPECT_EQ(lower_end(x).upper(), x.lower());
  EXPECT_EQ(upper_end(x).lower(), x.upper());
  const BigInterval both = hull(upper_end(x), lower_end(x));
  EXPECT_EQ(both.lower(), x.lower());
  EXPECT_EQ(both.upper(), x.upper());
}

TEST(Elementary, goes_to_doubles_outwards_and_back_exactly) {
  const auto check = [] {
    const Interval third = in_doubles(BigInterval(ratio(1, 3)));
    EXPECT_LT(Rational::exactly(third.lower()), ratio(1, 3));
    EXPECT_GT(Rational::exactly(third.upper()), ratio(1, 3));
    EXPECT_EQ(std::nextafter(third.lower(), 1.0), third.upper());
    const BigInterval back = in_big(third);
    EXPECT_EQ(back.lower(), Rational::exactly(third.lower()));
    EXPECT_EQ(back.upper(), Rational::exactly(third.upper()));
    EXPECT_FALSE(in_big(Interval::between(0, HUGE_VAL)).is_bounded());
  };
  check();
  const RoundingGuard guard;
  check();
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
