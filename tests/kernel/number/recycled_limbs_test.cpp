#include "kernel/number/recycled_limbs.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <thread>
#include <type_traits>
#include <vector>

#include "kernel/number/big_interval.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

static_assert(!std::is_copy_constructible_v<RecycledLimbs> && !std::is_move_constructible_v<RecycledLimbs>);

/// 1 + 1/2 + … + 1/count, and its enclosure: numbers of many lengths, which grow and shrink.
Rational harmonic(long count) {
  Rational sum(0);
  for (long n = 1; n <= count; ++n) sum += Rational(1) / Rational(n);
  const BigInterval enclosure(sum);
  EXPECT_LE(enclosure.lower(), sum);
  EXPECT_LE(sum, enclosure.upper());
  return sum;
}

TEST(RecycledLimbs, KeepsBlocksWhileItLivesAndNoLonger) {
  const Rational expected = harmonic(200);
  EXPECT_EQ(RecycledLimbs::kept(), 0U);
  {
    const RecycledLimbs recycled;
    EXPECT_EQ(harmonic(200), expected);
    EXPECT_GT(RecycledLimbs::kept(), 0U);
  }
  EXPECT_EQ(RecycledLimbs::kept(), 0U);
  EXPECT_EQ(harmonic(200), expected);
  EXPECT_EQ(RecycledLimbs::kept(), 0U);
}

/// Of two values that live at the same time, no limb is that of both.
TEST(RecycledLimbs, HandsABlockOutOnce) {
  const RecycledLimbs recycled;
  (void)harmonic(50);
  std::vector<Rational> values;
  for (long n = 1; n <= 500; ++n) values.push_back(power(Rational(3), n) / power(Rational(2), n));
  for (long n = 500; n >= 1; --n) {
    EXPECT_EQ(values.back() * power(Rational(2), n), power(Rational(3), n));
    values.pop_back();
  }
}

TEST(RecycledLimbs, OldAndYoungNumbersMayOutliveIt) {
  const Rational old = harmonic(60);
  auto older = std::make_unique<Rational>(old);
  std::unique_ptr<Rational> younger;
  {
    const RecycledLimbs recycled;
    younger = std::make_unique<Rational>(old * old);
    *older += Rational(1);
    older.reset();
  }
  EXPECT_EQ(*younger / old, old);
  *younger *= old;
  EXPECT_EQ(*younger / old, old * old);
}

TEST(RecycledLimbs, GuardsMayBeNested) {
  const RecycledLimbs outer;
  { const RecycledLimbs inner; }
  (void)harmonic(20);
  EXPECT_GT(RecycledLimbs::kept(), 0U);
}

/// Values go from thread to thread, and threads end: what leaks, the address sanitizer says.
TEST(RecycledLimbs, ThreadsKeepTheirOwn) {
  const RecycledLimbs recycled;
  const Rational expected = harmonic(100);
  for (int round = 0; round < 3; ++round) {
    std::vector<Rational> results(4);
    std::vector<std::thread> threads;
    for (Rational& result : results) threads.emplace_back([&result] { result = harmonic(100); });
    for (std::thread& thread : threads) thread.join();
    for (const Rational& result : results) EXPECT_EQ(result, expected);
  }
}

/// More than a thread keeps of one length.
TEST(RecycledLimbs, DoesNotKeepEverything) {
  const RecycledLimbs recycled;
  { const std::vector<Rational> many(5000, Rational(1) / Rational(3)); }
  EXPECT_LT(RecycledLimbs::kept(), 3000U);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
