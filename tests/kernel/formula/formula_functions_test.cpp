#include "kernel/formula/formula_functions.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "kernel/number/rounding_guard.hpp"
#include "tests/kernel/number/arb_reference.hpp"
#include "tests/support/ratio.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

using Function = Interval (*)(const Interval&);
using Reference = void (*)(arb_ptr, arb_srcptr, slong);

Interval value_of(Function ours, double lower, double upper) {
  const RoundingGuard guard;
  return ours(Interval::between(lower, upper));
}

/// Whether the enclosure of the values on [lower, upper] contains the value at x, by Arb; and whether the enclosure
/// moved by its width and a bit, the twin, does.
void expect_contained(Function ours, Reference theirs, double lower, double upper, double x) {
  const ArbReference reference = ArbReference(Rational::exactly(x)).with(theirs);
  const Interval value = value_of(ours, lower, upper);
  const Rational low = Rational::exactly(value.lower());
  const Rational high = Rational::exactly(value.upper());
  EXPECT_TRUE(lies_between(reference, low, high)) << lower << " " << upper << " " << x;
  const Rational shift = high - low + Rational::power_of_two(-1000);
  EXPECT_FALSE(lies_between(reference, low + shift, high + shift)) << lower << " " << upper << " " << x;
}

TEST(FormulaFunctions, enclose_what_another_library_says) {
  std::mt19937_64 random(5);
  const auto unit = [&] { return static_cast<double>(random() % (1U << 30U)) / static_cast<double>(1U << 29U) - 1; };
  for (int trial = 0; trial < 400; ++trial) {
    const double size = std::ldexp(1.0, static_cast<int>(random() % 40) - 12);
    const double lower = unit() * size;
    const double upper = lower + (trial % 4 == 0 ? 0 : std::fabs(unit()) * (trial % 2 == 0 ? 3 : 1e-3));
    const double x = trial % 3 == 0 ? upper : lower + (upper - lower) / 2;
    expect_contained(sine, arb_sin, lower, upper, x);
    expect_contained(cosine, arb_cos, lower, upper, x);
    if (std::fabs(upper) < 700 && std::fabs(lower) < 700) expect_contained(exponential, arb_exp, lower, upper, x);
  }
}

TEST(FormulaFunctions, are_tight_at_points) {
  std::mt19937_64 random(6);
  for (int trial = 0; trial < 200; ++trial) {
    const double x = static_cast<double>(static_cast<long>(random() % 200001) - 100000) / 4096;
    for (const Function function : {Function(sine), Function(cosine)}) {
      const Interval value = value_of(function, x, x);
      EXPECT_LE(value.upper() - value.lower(), 0x1p-49) << x;
    }
    const Interval value = value_of(exponential, x, x);
    EXPECT_LE(value.upper() - value.lower(), 0x1p-48 * value.upper()) << x;
  }
}

TEST(FormulaFunctions, reach_their_extremes_where_they_have_them_and_only_there) {
  EXPECT_EQ(value_of(sine, 1.5, 1.6).upper(), 1);
  EXPECT_LT(value_of(sine, 1.5, 1.57).upper(), 1);
  EXPECT_EQ(value_of(sine, 4.7, 4.8).lower(), -1);
  EXPECT_GT(value_of(sine, 1.5, 4.7).lower(), -1);
  EXPECT_EQ(value_of(cosine, -0.1, 0.1).upper(), 1);
  EXPECT_LT(value_of(cosine, 0.1, 0.2).upper(), 1);
  EXPECT_EQ(value_of(cosine, 3, 3.2).lower(), -1);
  EXPECT_GT(value_of(cosine, -0.1, 3.1).lower(), -1);
  EXPECT_EQ(value_of(sine, -100, 100).lower(), -1);
  EXPECT_EQ(value_of(sine, -100, 100).upper(), 1);
}

TEST(FormulaFunctions, are_exact_at_nought_and_hold_at_infinity) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(value_of(sine, 0, 0).lower(), 0);
  EXPECT_EQ(value_of(sine, 0, 0).upper(), 0);
  EXPECT_EQ(value_of(exponential, -infinity, infinity).lower(), 0);
  EXPECT_EQ(value_of(exponential, -infinity, infinity).upper(), infinity);
  EXPECT_EQ(value_of(exponential, 800, 900).upper(), infinity);
  EXPECT_GT(value_of(exponential, 800, 900).lower(), 1e300);
  EXPECT_EQ(value_of(cosine, -infinity, infinity).upper(), 1);
}

TEST(FormulaFunctions, are_near_the_value_in_doubles) {
  for (int k = -300; k <= 300; ++k) {
    const double x = k / 37.0;
    EXPECT_NEAR(approximate_sine(x), std::sin(x), 1e-14);
    EXPECT_NEAR(approximate_cosine(x), std::cos(x), 1e-14);
    EXPECT_NEAR(approximate_exponential(x) / std::exp(x), 1, 1e-13);
    // The mode is what it was.
    EXPECT_EQ(1 + 0x1p-60, 1);
  }
}

TEST(WholePower, is_the_set_of_powers) {
  const auto check = [](double lower, double upper, unsigned exponent, double least, double greatest) {
    const RoundingGuard guard;
    const Interval result = whole_power(Interval::between(lower, upper), exponent);
    EXPECT_EQ(result.lower(), least) << exponent;
    EXPECT_EQ(result.upper(), greatest) << exponent;
    const BigInterval big =
        whole_power(BigInterval::between(Rational::exactly(lower), Rational::exactly(upper)), exponent);
    EXPECT_EQ(big.lower(), Rational::exactly(least));
    EXPECT_EQ(big.upper(), Rational::exactly(greatest));
  };
  check(-1, 2, 1, -1, 2);
  check(-1, 2, 2, 0, 4);
  check(-1, 2, 3, -1, 8);
  check(-3, 2, 4, 0, 81);
  check(-3, 2, 5, -243, 32);
  check(-3, 2, 6, 0, 729);
  check(-3, -2, 6, 64, 729);
  check(-3, -2, 7, -2187, -128);
  check(2, 3, 7, 128, 2187);
  EXPECT_EQ(whole_power(-2.0, 9), -512);
  EXPECT_EQ(whole_power(-2.0, 10), 1024);
}

TEST(WholePower, is_rounded_outwards) {
  const RoundingGuard guard;
  const Rational x = Rational::exactly(0x1.921fb54442d18p+1);
  for (unsigned exponent = 2; exponent < 30; ++exponent) {
    const Interval result = whole_power(Interval::exactly(0x1.921fb54442d18p+1), exponent);
    const Rational exact = power(x, static_cast<long>(exponent));
    EXPECT_LT(Rational::exactly(result.lower()), exact);
    EXPECT_GT(Rational::exactly(result.upper()), exact);
  }
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
