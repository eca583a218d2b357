#include "proofs/checker/arithmetic/interval.hpp"

#include <gtest/gtest.h>

#include <random>

#include "proofs/checker/arithmetic/rational.hpp"
#include "tests/checker/support/exact_double.hpp"
#include "tests/checker/upwards.hpp"

namespace delcert::checker_tests {
namespace {

using checker::Interval;
using checker::Rational;
using checker::Verdict;

/// Doubles of all magnitudes, small integers, and neighbours of powers of two.
double hard_double(std::mt19937_64& random) {
  const double sign = random() % 2 == 0 ? 1 : -1;
  switch (random() % 5) {
    case 0:
      return sign * static_cast<double>(random() % 5);
    case 1:
      return sign * std::ldexp(1 + 0x1p-52, static_cast<int>(random() % 8) - 4);
    case 2:
      return sign * std::ldexp(static_cast<double>(random() >> 11), static_cast<int>(random() % 1000) - 550);
    case 3:
      return sign * std::ldexp(1.0, -1074 + static_cast<int>(random() % 4));
    default:
      return sign * std::ldexp(static_cast<double>(random() >> 11), -53);
  }
}

struct Sample {
  Interval interval;
  Rational exact;
};

Sample sample(std::mt19937_64& random) {
  const double a = hard_double(random), b = hard_double(random);
  const Interval interval = Interval::between(std::min(a, b), std::max(a, b));
  switch (random() % 3) {
    case 0:
      return {interval, exact(a)};
    case 1:
      return {interval, exact(b)};
    default:
      return {interval, (exact(a) + exact(b)) / Rational(2)};
  }
}

class IntervalOperations : public testing::Test {
 protected:
  const test::Upwards upwards;
};

TEST_F(IntervalOperations, contain_the_exact_results) {
  std::mt19937_64 random(1);
  for (int k = 0; k < 200000; ++k) {
    const Sample a = sample(random), b = sample(random);
    EXPECT_TRUE(contains(a.interval + b.interval, a.exact + b.exact));
    EXPECT_TRUE(contains(a.interval - b.interval, a.exact - b.exact));
    EXPECT_TRUE(contains(a.interval * b.interval, a.exact * b.exact));
    EXPECT_TRUE(contains(square(a.interval), a.exact * a.exact));
    EXPECT_TRUE(contains(-a.interval, -a.exact));
    EXPECT_TRUE(contains(maximum(a.interval, b.interval), maximum(a.exact, b.exact)));
    if (b.exact.sign() != 0) {
      EXPECT_TRUE(contains(a.interval / b.interval, a.exact / b.exact));
      EXPECT_TRUE(contains(checker::enclosure(a.exact / b.exact), a.exact / b.exact));
    }
    if (a.exact.sign() >= 0) {
      const double root = upper_root(a.interval);
      EXPECT_TRUE(std::isinf(root) || less(exact(root) * exact(root), a.exact) == Verdict::refuted);
    }
    const Verdict filtered = less(a.interval, b.interval);
    EXPECT_TRUE(filtered == Verdict::undecided || filtered == less(a.exact, b.exact));
    if (HasFailure()) FAIL() << "case " << k;
  }
}

TEST_F(IntervalOperations, with_infinite_and_zero_endpoints_contain_what_they_stand_for) {
  const Interval huge = Interval::between(-1e300, 1e300) * Interval::between(-1e300, 1e300);
  EXPECT_TRUE(std::isinf(huge.lower()) && std::isinf(huge.upper()));
  for (const Interval& other : {Interval(0), Interval(1), Interval::between(-1, 2), huge}) {
    for (const Interval& result : {huge * other, other * huge, huge + other, huge - huge, other / huge,
                                   Interval(1) / (huge * other), square(huge)}) {
      EXPECT_FALSE(std::isnan(result.lower()) || std::isnan(result.upper()));
      EXPECT_TRUE(contains(result, Rational(0)) || contains(result, Rational(1)));
    }
  }
  const Interval half_line = Interval::between(0, 1) / Interval(0);
  EXPECT_TRUE(contains(half_line, Rational(-1)) && contains(half_line, Rational(1)));
}

// 0 times an infinite endpoint once hid the bound 0 of a product.
TEST_F(IntervalOperations, of_an_overflowing_inverse_keep_the_bound_zero) {
  const Interval quotient = Interval::between(0, 1) / Interval::between(0x1p-1074, 2);
  EXPECT_TRUE(contains(quotient, Rational(0)));
  EXPECT_TRUE(contains(quotient, exact(1) / exact(0x1p-1074)));
}

TEST_F(IntervalOperations, are_tight_where_doubles_are_exact) {
  const Interval sum = Interval(3) * Interval(5) - square(Interval(4)) / Interval(2);
  EXPECT_EQ(sum.lower(), 7);
  EXPECT_EQ(sum.upper(), 7);
  EXPECT_EQ(less(Interval(2), Interval(2)), Verdict::refuted);
  EXPECT_EQ(less(Interval::between(1, 2), Interval(2)), Verdict::undecided);
}

}  // namespace
}  // namespace delcert::checker_tests
