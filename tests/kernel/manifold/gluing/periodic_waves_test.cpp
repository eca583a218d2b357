#include "kernel/manifold/gluing/periodic_waves.hpp"

#include <gtest/gtest.h>

#include "kernel/number/rounding_guard.hpp"
#include "tests/kernel/manifold/gluing/samples.hpp"
#include "tests/kernel/number/arb_reference.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

ArbReference reference_cosine(const Rational& t) { return ArbReference(Rational(2) * t).with(arb_cos_pi); }
ArbReference reference_sine(const Rational& t) { return ArbReference(Rational(2) * t).with(arb_sin_pi); }

const std::vector<Rational> arguments{ratio(1, 7),
                                      ratio(-1, 7),
                                      ratio(3, 8),
                                      ratio(5, 9),
                                      ratio(99, 100),
                                      ratio(1000003, 7),
                                      Rational::power_of_two(-60),
                                      ratio(249, 1000),
                                      ratio(251, 1000),
                                      ratio(-123457, 11)};

TEST(PeriodicWaves, are_enclosed_narrowly_on_both_rungs) {
  for (const Rational& t : arguments) {
    const auto small = [&] {
      const RoundingGuard guard;
      return wave_at<Interval>(t);
    }();
    const auto big = wave_at<BigInterval>(t);
    const auto check = [&](const Interval& filter, const BigInterval& fine, const ArbReference& value) {
      const Rational lower = Rational::exactly(filter.lower());
      const Rational upper = Rational::exactly(filter.upper());
      EXPECT_TRUE(lies_between(value, lower, upper)) << approximate_double(t);
      EXPECT_LE(upper - lower, Rational::power_of_two(-48));
      // Not if it were elsewhere.
      EXPECT_FALSE(lies_between(value, lower + Rational::power_of_two(-46), upper + Rational::power_of_two(-46)));
      EXPECT_TRUE(lies_between(value, fine.lower(), fine.upper())) << approximate_double(t);
      EXPECT_LE(fine.upper() - fine.lower(), Rational::power_of_two(-118));
    };
    check(small.cosine, big.cosine, reference_cosine(t));
    check(small.sine, big.sine, reference_sine(t));
  }
}

TEST(PeriodicWaves, are_exact_at_quarters) {
  const RoundingGuard guard;
  const std::array<int, 4> cosines{1, 0, -1, 0};
  const std::array<int, 4> sines{0, 1, 0, -1};
  for (long quarters = -9; quarters < 9; ++quarters) {
    const auto wave = wave_at<Interval>(ratio(quarters, 4));
    const auto at = static_cast<std::size_t>(((quarters % 4) + 4) % 4);
    EXPECT_EQ(wave.cosine.lower(), cosines[at]);
    EXPECT_EQ(wave.cosine.upper(), cosines[at]);
    EXPECT_EQ(wave.sine.lower(), sines[at]);
    EXPECT_EQ(wave.sine.upper(), sines[at]);
  }
}

TEST(PeriodicWaves, are_enclosed_on_intervals) {
  for (const Rational& middle : arguments) {
    for (const Rational& half : {Rational(0), ratio(1, 1000), ratio(1, 20), ratio(1, 4), Rational(3)}) {
      const auto wave = [&] {
        const RoundingGuard guard;
        return wave_within(middle, half);
      }();
      for (long step = -8; step <= 8; ++step) {
        const Rational t = middle + half * ratio(step, 8);
        EXPECT_TRUE(lies_between(reference_cosine(t), Rational::exactly(wave.cosine.lower()),
                                 Rational::exactly(wave.cosine.upper())));
        EXPECT_TRUE(lies_between(reference_sine(t), Rational::exactly(wave.sine.lower()),
                                 Rational::exactly(wave.sine.upper())));
      }
      // Of first order: |cos′| ≤ 2π; and never beyond [−1, 1].
      EXPECT_LE(wave.cosine.upper() - wave.cosine.lower(), 14 * approximate_double(half) + 1e-14);
      EXPECT_LE(wave.cosine.upper(), 1);
      EXPECT_GE(wave.sine.lower(), -1);
    }
  }
  const RoundingGuard guard;
  EXPECT_EQ(wave_within(ratio(1, 3), Rational(3)).sine.lower(), -1);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
