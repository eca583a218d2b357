#include "proofs/prover/extended_interval.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>

#include "tests/proofs/prover/prove_text.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

using test::ratio;
constexpr PrecisionBits bits{64U};

ExtendedInterval between(const Rational& lower, const Rational& upper) { return {lower, true, upper, true, bits}; }
ExtendedInterval above(const Rational& lower, bool has) { return {lower, has, std::nullopt, false, bits}; }

/// "[1, 2)", with doubles for ends.
std::string text(const ExtendedInterval& x) {
  const auto end = [](const ExtendedInterval::End& e) {
    return e.is_infinite() ? std::string(e.sign() > 0 ? "inf" : "-inf")
                           : std::to_string(static_cast<long>(4 * mpfr_get_d(e.raw(), MPFR_RNDN))) + "/4";
  };
  return (x.lower().open ? "(" : "[") + end(x.lower()) + ", " + end(x.upper()) + (x.upper().open ? ")" : "]");
}

bool contains(const ExtendedInterval& interval, const Rational& x) {
  const int lower = mpfr_cmp_q(interval.lower().raw(), x.gmp());
  const int upper = mpfr_cmp_q(interval.upper().raw(), x.gmp());
  return (lower < 0 || (lower == 0 && !interval.lower().open)) && (upper > 0 || (upper == 0 && !interval.upper().open));
}

TEST(ExtendedInterval, knows_whether_its_ends_are_values) {
  const ExtendedInterval half_open(Rational(0), false, Rational(1), true, bits);
  EXPECT_EQ(text(half_open), "(0/4, 4/4]");
  EXPECT_TRUE(half_open.is_positive());
  EXPECT_EQ(text(half_open + half_open), "(0/4, 8/4]");
  EXPECT_EQ(text(half_open * half_open), "(0/4, 4/4]");
  EXPECT_EQ(text(-half_open), "[-4/4, 0/4)");
  EXPECT_EQ(text(half_open - half_open), "(-4/4, 4/4)");
  EXPECT_EQ(text(*quotient(between(1, 2), half_open)), "[4/4, inf)");
  EXPECT_FALSE(quotient(between(1, 2), between(0, 1)));
  EXPECT_FALSE(quotient(between(1, 2), between(-1, 1)));
  EXPECT_EQ(text(between(0, 1) * half_open), "[0/4, 4/4]");
}

TEST(ExtendedInterval, a_rounded_end_is_open) {
  const ExtendedInterval third(ratio(1, 3), bits);
  EXPECT_TRUE(third.lower().open && third.upper().open && contains(third, ratio(1, 3)));
  EXPECT_TRUE((third * ExtendedInterval(Rational(3), bits) - ExtendedInterval(Rational(1), bits)).contains_zero());
}

TEST(ExtendedInterval, infinity_is_no_value) {
  EXPECT_EQ(text(above(1, true) * between(0, 0)), "[0/4, 0/4]");
  EXPECT_EQ(text(above(1, true) * ExtendedInterval(Rational(0), false, Rational(1), true, bits)), "(0/4, inf)");
  EXPECT_EQ(text(above(1, true) - above(1, true)), "(-inf, inf)");
  EXPECT_EQ(text(*quotient(between(1, 1), above(2, true))), "(0/4, 2/4]");
  EXPECT_EQ(text(ExtendedInterval(bits)), "(-inf, inf)");
}

TEST(ExtendedInterval, powers) {
  EXPECT_EQ(text(power(between(-2, 1), 2UL)), "[0/4, 16/4]");
  EXPECT_EQ(text(power(between(-2, 1), 3UL)), "[-32/4, 4/4]");
  EXPECT_EQ(text(power(between(0, 0), 0UL)), "[4/4, 4/4]");
  EXPECT_EQ(text(*power(above(2, true), above(3, true))), "[32/4, inf)");
  EXPECT_EQ(text(*power(above(1, true), above(3, true))), "[4/4, inf)");
  EXPECT_EQ(text(*power(above(1, false), above(3, true))), "(4/4, inf)");
  EXPECT_EQ(text(*power(between(ratio(1, 2), ratio(1, 2)), above(1, true))), "(0/4, 2/4]");
  EXPECT_EQ(text(*power(ExtendedInterval(Rational(0), false, Rational(1), true, bits), above(1, true))), "(0/4, 4/4]");
  EXPECT_EQ(text(*power(between(2, 4), between(-1, 1))), "[1/4, 16/4]");
  EXPECT_FALSE(power(between(0, 1), between(1, 2)));
}

TEST(ExtendedInterval, roots_logarithms_and_extremes) {
  EXPECT_EQ(text(*square_root(between(4, 9))), "[8/4, 12/4]");
  EXPECT_FALSE(square_root(between(-1, 4)));
  EXPECT_EQ(text(*binary_logarithm(between(1, 8))), "[0/4, 12/4]");
  EXPECT_EQ(text(*binary_logarithm(ExtendedInterval(Rational(0), false, Rational(1), true, bits))), "(-inf, 0/4]");
  EXPECT_FALSE(binary_logarithm(between(0, 1)));
  EXPECT_EQ(text(absolute(between(-3, 2))), "[0/4, 12/4]");
  EXPECT_EQ(text(minimum(between(0, 3), between(1, 2))), "[0/4, 8/4]");
  EXPECT_EQ(text(maximum(between(0, 3), between(1, 2))), "[4/4, 12/4]");
  EXPECT_EQ(text(ExtendedInterval::hull(between(0, 1), between(3, 4))), "[0/4, 16/4]");
  EXPECT_EQ(text(ExtendedInterval::at(above(1, false).lower())), "[4/4, 4/4]");
  EXPECT_EQ(text(between(0, 1).with_open_lower().with_open_upper()), "(0/4, 4/4)");
}

RC_GTEST_PROP(ExtendedInterval, contains_the_values_of_what_it_contains, ()) {
  const auto number = [] { return ratio(*rc::gen::inRange(-40, 40), *rc::gen::inRange(1, 9)); };
  const auto draw = [&](Rational& inside) {
    Rational ends[2] = {number(), number()};
    if (ends[1] < ends[0]) std::swap(ends[0], ends[1]);
    const Rational weight = ratio(*rc::gen::inRange(0, 8), 7);
    inside = ends[0] + weight * (ends[1] - ends[0]);
    return between(ends[0], ends[1]);
  };
  Rational x;
  Rational y;
  const ExtendedInterval a = draw(x);
  const ExtendedInterval b = draw(y);
  RC_ASSERT(contains(a + b, x + y));
  RC_ASSERT(contains(a - b, x - y));
  RC_ASSERT(contains(a * b, x * y));
  RC_ASSERT(contains(absolute(a), absolute(x)));
  RC_ASSERT(contains(minimum(a, b), minimum(x, y)));
  RC_ASSERT(contains(maximum(a, b), maximum(x, y)));
  RC_ASSERT(contains(power(a, 3UL), power(x, 3)));
  RC_ASSERT(contains(power(a, 4UL), power(x, 4)));
  if (const auto q = quotient(a, b)) RC_ASSERT(contains(*q, x / y));
  if (const auto root = square_root(a)) RC_ASSERT(contains(power(*root, 2UL), x));
  if (a.is_positive()) RC_ASSERT(contains(*power(a, ExtendedInterval(Rational(-2), bits)), power(x, -2)));
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
