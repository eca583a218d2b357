#include "kernel/chart/curved_functions.hpp"

#include <gtest/gtest.h>

#include <random>

#include "kernel/number/rounding_guard.hpp"
#include "kernel/number/scalar.hpp"
#include "tests/kernel/number/arb_reference.hpp"
#include "tests/support/ratio.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

constexpr std::array curvatures{Curvature::negative, Curvature::zero, Curvature::positive};

ArbReference square_root_of(const Rational& s) { return ArbReference(s).with(arb_sqrt); }

/// What the functions are, by Arb.
ArbReference reference_cosine(Curvature curvature, const Rational& s) {
  if (curvature == Curvature::zero) return ArbReference(Rational(1));
  return square_root_of(s).with(curvature == Curvature::positive ? arb_cos : arb_cosh);
}

ArbReference reference_sine_ratio(Curvature curvature, const Rational& s) {
  if (curvature == Curvature::zero || s == Rational(0)) return ArbReference(Rational(1));
  const ArbReference root = square_root_of(s);
  return root.with(curvature == Curvature::positive ? arb_sin : arb_sinh) / root;
}

ArbReference reference_arctangent_ratio(Curvature curvature, const Rational& q) {
  if (curvature == Curvature::zero || q == Rational(0)) return ArbReference(Rational(1));
  const ArbReference root = square_root_of(q);
  return root.with(curvature == Curvature::positive ? arb_atan : arb_atanh) / root;
}

/// The enclosure of a value at an exact argument contains it, is narrow, and would not contain it if it were moved.
/// `condition` is how much a relative error of the argument may grow.
template <class Function, class Reference>
void expect_narrow_enclosures(const Function& function, const Reference& reference, const Rational& s,
                              const Rational& condition = Rational(1)) {
  for (const Curvature curvature : curvatures) {
    const ArbReference value = reference(curvature, s);
    Interval small(0);
    {
      const RoundingGuard guard;
      small = function(curvature, scalar_from<Interval>(s));
    }
    const Rational lower = Rational::exactly(small.lower());
    const Rational upper = Rational::exactly(small.upper());
    ASSERT_TRUE(lies_between(value, lower, upper)) << "s = " << approximate_double(s);
    const Rational size = maximum(Rational(1), absolute(upper)) * condition;
    EXPECT_LE(upper - lower, size * Rational::power_of_two(-48)) << "s = " << approximate_double(s);
    const Rational step = size * Rational::power_of_two(-46);
    EXPECT_FALSE(lies_between(value, lower + step, upper + step));

    const BigInterval big = function(curvature, BigInterval(s));
    ASSERT_TRUE(lies_between(value, big.lower(), big.upper())) << "s = " << approximate_double(s);
    EXPECT_LE(big.upper() - big.lower(), size * Rational::power_of_two(-118));
  }
}

constexpr auto cosine_function = [](Curvature k, const auto& s) { return cosine_of_root(k, s); };
constexpr auto sine_function = [](Curvature k, const auto& s) { return sine_ratio(k, s); };
constexpr auto arctangent_function = [](Curvature k, const auto& q) { return arctangent_ratio(k, q); };

TEST(CurvedFunctions, are_enclosed_at_both_ends_of_every_series_and_between) {
  std::vector<Rational> arguments{Rational(0),
                                  Rational::power_of_two(-1000),
                                  Rational::power_of_two(-60),
                                  ratio(1, 16),
                                  ratio(1, 64),
                                  Rational(4),
                                  ratio(401, 100),
                                  ratio(98, 10)};
  std::mt19937_64 random(5);
  for (int trial = 0; trial < 200; ++trial)
    arguments.push_back(ratio(static_cast<long>(random() % 4000), 1000) *
                        Rational::power_of_two(-static_cast<long>(random() % 12)));
  for (const Rational& s : arguments) {
    expect_narrow_enclosures(cosine_function, reference_cosine, s);
    expect_narrow_enclosures(sine_function, reference_sine_ratio, s);
  }
}

TEST(CurvedFunctions, arctangents_are_enclosed_up_to_the_ends_of_their_domain) {
  std::vector<Rational> arguments{
      Rational(0),       Rational::power_of_two(-1000), ratio(1, 64), ratio(65, 4096), ratio(1, 2), ratio(99, 100),
      ratio(9999, 10000)};
  std::mt19937_64 random(6);
  for (int trial = 0; trial < 200; ++trial)
    arguments.push_back(ratio(static_cast<long>(random() % 1000), 1001) *
                        Rational::power_of_two(-static_cast<long>(random() % 12)));
  for (const Rational& q : arguments)
    expect_narrow_enclosures(arctangent_function, reference_arctangent_ratio, q, Rational(4) / (Rational(1) - q));
}

TEST(CurvedFunctions, the_arctangent_takes_every_size) {
  for (const long exponent : {0L, 3L, 40L, 900L}) {
    const Rational q = Rational(3) * Rational::power_of_two(exponent);
    const ArbReference value = reference_arctangent_ratio(Curvature::positive, q);
    const RoundingGuard guard;
    const Interval ours = arctangent_ratio(Curvature::positive, scalar_from<Interval>(q));
    const Rational lower = Rational::exactly(ours.lower());
    const Rational upper = Rational::exactly(ours.upper());
    EXPECT_TRUE(lies_between(value, lower, upper));
    EXPECT_LE(upper - lower, upper * Rational::power_of_two(-40));
  }
}

template <class Function, class Reference>
void expect_inclusion(const Function& function, const Reference& reference, const Rational& least,
                      const Rational& greatest) {
  for (const Curvature curvature : curvatures) {
    Interval small(0);
    {
      const RoundingGuard guard;
      small = function(
          curvature, Interval::between(scalar_from<Interval>(least).lower(), scalar_from<Interval>(greatest).upper()));
    }
    const BigInterval big = function(curvature, BigInterval::between(least, greatest));
    for (int step = 0; step <= 8; ++step) {
      const ArbReference value = reference(curvature, least + (greatest - least) * ratio(step, 8));
      EXPECT_TRUE(lies_between(value, Rational::exactly(small.lower()), Rational::exactly(small.upper())));
      EXPECT_TRUE(lies_between(value, big.lower(), big.upper()));
    }
  }
}

TEST(CurvedFunctions, wide_arguments_contain_all_values) {
  for (const auto& [least, greatest] : std::vector<std::pair<Rational, Rational>>{{Rational(0), ratio(1, 20)},
                                                                                  {ratio(1, 20), Rational(3)},
                                                                                  {Rational(3), Rational(9)},
                                                                                  {Rational(8), Rational(60)}}) {
    expect_inclusion(cosine_function, reference_cosine, least, greatest);
    expect_inclusion(sine_function, reference_sine_ratio, least, greatest);
  }
  expect_inclusion(arctangent_function, reference_arctangent_ratio, Rational(0), ratio(9, 10));
  expect_inclusion(arctangent_function, reference_arctangent_ratio, ratio(1, 100), ratio(1, 3));
}

TEST(CurvedFunctions, are_open_where_their_argument_may_leave_the_domain) {
  const RoundingGuard guard;
  EXPECT_EQ(arctangent_ratio(Curvature::negative, Interval::between(0, 1)).upper(), HUGE_VAL);
  EXPECT_LE(arctangent_ratio(Curvature::positive, Interval::between(1, HUGE_VAL)).lower(), 0);
  EXPECT_LE(cosine_of_root(Curvature::positive, Interval::between(9, HUGE_VAL)).lower(), -1);
  EXPECT_GE(cosine_of_root(Curvature::positive, Interval::between(9, HUGE_VAL)).upper(), 1);
  EXPECT_EQ(sine_ratio(Curvature::negative, Interval::between(9, HUGE_VAL)).upper(), HUGE_VAL);
  // Negative parts are cut off: a square is not negative.
  EXPECT_GE(cosine_of_root(Curvature::negative, Interval::between(-1, 0)).lower(), 1 - 0x1p-50);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
