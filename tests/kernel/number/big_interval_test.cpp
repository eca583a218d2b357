#include "kernel/number/big_interval.hpp"

#include <gtest/gtest.h>

#include <stdexcept>
#include <thread>
#include <vector>

#include "kernel/number/rounding_guard.hpp"
#include "kernel/number/scalar.hpp"
#include "tests/kernel/number/random_numbers.hpp"
#include "tests/support/contains.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

static_assert(Scalar<BigInterval>);
static_assert(std::is_nothrow_move_constructible_v<BigInterval>);

Rational fraction(long numerator, long denominator) { return Rational(numerator) / Rational(denominator); }

bool contains_root(const BigInterval& interval, const Rational& x) {
  return interval.lower() >= Rational(0) && square(interval.lower()) <= x && x <= square(interval.upper());
}

/// Numbers that no precision at hand holds exactly, besides the hard doubles.
std::array<Rational, 2> hard_endpoints(RandomNumbers& random) {
  const auto doubles = random.hard_endpoints();
  const Rational a = Rational::exactly(doubles[0]);
  const Rational b = Rational::exactly(doubles[1]);
  if (random.below(2) == 0) return {a, b};
  const Rational third = fraction(static_cast<long>(random.below(7)) + 1, 3);
  return {a * third, b * third};
}

TEST(BigInterval, every_operation_encloses_the_exact_results_at_every_precision) {
  RandomNumbers random(21);
  for (int round = 0; round < 8000; ++round) {
    constexpr std::array<unsigned, 4> precisions = {2, 53, 128, 512};
    const BigInterval::Precision precision(PrecisionBits{precisions[random.below(precisions.size())]});
    const auto first = hard_endpoints(random);
    const auto second = hard_endpoints(random);
    const BigInterval a = BigInterval::between(first[0], first[1]);
    const BigInterval b = BigInterval::between(second[0], second[1]);
    const BigInterval quotient = a / b;
    const BigInterval root = square_root(a);
    for (int sample = 0; sample < 3; ++sample) {
      const Rational x = random.between(first[0], first[1]);
      const Rational y = random.between(second[0], second[1]);
      ASSERT_TRUE(contains(a, x));
      ASSERT_TRUE(contains(a + b, x + y));
      ASSERT_TRUE(contains(a - b, x - y));
      ASSERT_TRUE(contains(a * b, x * y));
      ASSERT_TRUE(y == Rational(0) || contains(quotient, x / y));
      ASSERT_TRUE(contains(-a, -x));
      ASSERT_TRUE(contains(square(a), square(x)));
      ASSERT_TRUE(contains(absolute(a), absolute(x)));
      ASSERT_TRUE(contains(minimum(a, b), minimum(x, y)));
      ASSERT_TRUE(contains(maximum(a, b), maximum(x, y)));
      ASSERT_TRUE(x < Rational(0) || contains_root(root, x));
    }
  }
}

TEST(BigInterval, results_from_points_are_as_narrow_as_the_precision_allows) {
  RandomNumbers random(22);
  for (int round = 0; round < 4000; ++round) {
    const BigInterval::Precision precision(PrecisionBits{200});
    const Rational x = Rational::exactly(random.hard_double()) + fraction(1, 3);
    const Rational y = Rational::exactly(random.hard_double());
    const BigInterval a(x);
    const auto is_narrow = [](const BigInterval& interval) {
      const Rational width = interval.upper() - interval.lower();
      const Rational size = maximum(absolute(interval.upper()), absolute(interval.lower()));
      return width <= size * Rational::power_of_two(-190);
    };
    ASSERT_TRUE(is_narrow(a));
    ASSERT_TRUE(is_narrow(a * BigInterval(y)));
    ASSERT_TRUE(is_narrow(square(a)));
    ASSERT_TRUE(is_narrow(square_root(absolute(a))));
    ASSERT_TRUE(y == Rational(0) || is_narrow(a / BigInterval(y)));
  }
}

TEST(BigInterval, what_doubles_confuse_is_told_apart_as_far_as_the_precision_reaches) {
  for (long k = 1; k <= 600; k += 7) {
    const BigInterval moved = BigInterval(1) + BigInterval(Rational::power_of_two(-k));
    EXPECT_EQ(less(BigInterval(1), moved), k <= 127 ? Verdict::proved : Verdict::undecided) << k;
    const BigInterval::Precision precision(PrecisionBits{640});
    EXPECT_EQ(less(BigInterval(1), BigInterval(1) + BigInterval(Rational::power_of_two(-k))), Verdict::proved) << k;
  }
}

TEST(BigInterval, precision_nests_and_is_restored_and_is_checked) {
  EXPECT_EQ(BigInterval::working_precision(), PrecisionBits{128});
  {
    const BigInterval::Precision outer(PrecisionBits{256});
    {
      const BigInterval::Precision inner(PrecisionBits{64});
      EXPECT_EQ(BigInterval::working_precision(), PrecisionBits{64});
      EXPECT_THROW(static_cast<void>(BigInterval::Precision(PrecisionBits{1})), std::domain_error);
      EXPECT_THROW(static_cast<void>(BigInterval::Precision(PrecisionBits{(1U << 20U) + 1})), std::domain_error);
      EXPECT_EQ(BigInterval::working_precision(), PrecisionBits{64});
    }
    EXPECT_EQ(BigInterval::working_precision(), PrecisionBits{256});
    EXPECT_EQ(mpfi_get_prec((BigInterval(1) / BigInterval(3)).mpfi()), 256);
  }
  EXPECT_EQ(BigInterval::working_precision(), PrecisionBits{128});
}

// The default precision of Boost's mpfi_float is one for all threads.
TEST(BigInterval, precision_of_one_thread_is_none_of_another_ones_business) {
  const BigInterval::Precision precision(PrecisionBits{300});
  std::vector<unsigned> seen(4);
  std::vector<std::thread> threads;
  for (unsigned index = 0; index < seen.size(); ++index) {
    threads.emplace_back([index, &seen] {
      bool all_right = BigInterval::working_precision() == PrecisionBits{128};
      for (int round = 0; round < 2000; ++round) {
        const BigInterval::Precision own(PrecisionBits{100 + index});
        all_right = all_right && mpfi_get_prec((BigInterval(1) / BigInterval(3)).mpfi()) == 100 + index;
      }
      seen[index] = all_right ? 100 + index : 0;
    });
  }
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(seen, (std::vector<unsigned>{100, 101, 102, 103}));
  EXPECT_EQ(BigInterval::working_precision(), PrecisionBits{300});
}

TEST(BigInterval, unbounded_results_stay_unbounded_and_are_never_nan) {
  const BigInterval line = BigInterval(1) / BigInterval(0);
  const BigInterval half_line = square(line);
  const BigInterval zero(0);
  EXPECT_FALSE(line.is_bounded());
  EXPECT_TRUE(contains(line, -1000000) && contains(line, 1000000));
  EXPECT_TRUE(contains(half_line, 0) && contains(half_line, 1000000));
  EXPECT_THROW(static_cast<void>(line.lower()), std::domain_error);
  EXPECT_THROW(static_cast<void>(half_line.upper()), std::domain_error);
  const std::vector<BigInterval> operands = {line, half_line,      -half_line,
                                             zero, BigInterval(2), BigInterval::between(-1, 1)};
  for (const BigInterval& a : operands) {
    for (const BigInterval& b : operands) {
      for (const BigInterval& result :
           {a + b, a - b, a * b, a / b, minimum(a, b), maximum(a, b), square(a), square_root(a), absolute(a), -a})
        EXPECT_EQ(mpfi_nan_p(result.mpfi()), 0);
      for (const Rational& x : {Rational(-5), Rational(-1), Rational(0), fraction(1, 2), Rational(2), Rational(7)}) {
        for (const Rational& y : {Rational(-5), Rational(-1), Rational(0), fraction(1, 2), Rational(2), Rational(7)}) {
          if (!contains(a, x) || !contains(b, y)) continue;
          EXPECT_TRUE(contains(a + b, x + y));
          EXPECT_TRUE(contains(a - b, x - y));
          EXPECT_TRUE(contains(a * b, x * y));
          EXPECT_TRUE(y == Rational(0) || contains(a / b, x / y));
          EXPECT_TRUE(contains(minimum(a, b), minimum(x, y)));
          EXPECT_TRUE(contains(maximum(a, b), maximum(x, y)));
        }
      }
    }
  }
}

TEST(BigInterval, division_by_an_interval_that_touches_zero_is_unbounded) {
  for (const BigInterval& divisor :
       {BigInterval(0), BigInterval::between(-1, 1), BigInterval::between(0, 1), BigInterval::between(-1, 0)})
    EXPECT_FALSE((BigInterval(1) / divisor).is_bounded());
  EXPECT_TRUE((BigInterval(1) / BigInterval::between(1, 2)).is_bounded());
}

TEST(BigInterval, square_root_cuts_off_what_is_negative) {
  const BigInterval root = square_root(BigInterval::between(-2, 4));
  EXPECT_TRUE(root.lower() == Rational(0) && root.upper() == Rational(2));
  EXPECT_EQ(is_zero(square_root(BigInterval::between(-2, -1))), Verdict::proved);
}

TEST(BigInterval, verdicts_hold_for_all_arguments_and_are_undecided_only_where_some_differ) {
  RandomNumbers random(23);
  for (int round = 0; round < 10000; ++round) {
    const BigInterval::Precision precision(PrecisionBits{1200});
    const auto first = random.hard_endpoints();
    const auto second = random.below(2) == 0 ? random.hard_endpoints() : std::array<double, 2>{first[1], first[1]};
    const BigInterval a = BigInterval::between(Rational::exactly(first[0]), Rational::exactly(first[1]));
    const BigInterval b = BigInterval::between(Rational::exactly(second[0]), Rational::exactly(second[1]));
    const bool some_less = first[0] < second[1];
    const bool some_not = first[1] >= second[0];
    const Verdict expected = !some_not ? Verdict::proved : !some_less ? Verdict::refuted : Verdict::undecided;
    ASSERT_EQ(less(a, b), expected);
    ASSERT_EQ(less_equal(b, a), negation(expected));
    const bool has_zero = first[0] <= 0 && 0 <= first[1];
    const bool is_point = first[0] == 0 && first[1] == 0;
    ASSERT_EQ(is_zero(a), !has_zero ? Verdict::refuted : is_point ? Verdict::proved : Verdict::undecided);
  }
}

TEST(BigInterval, a_rounding_guard_around_it_changes_nothing) {
  const BigInterval outside = square_root(BigInterval(fraction(2, 3))) / BigInterval(7);
  const RoundingGuard guard;
  const BigInterval inside = square_root(BigInterval(fraction(2, 3))) / BigInterval(7);
  EXPECT_TRUE(outside.lower() == inside.lower() && outside.upper() == inside.upper());
}

TEST(BigInterval, copies_and_moves_keep_value_and_precision) {
  const BigInterval::Precision wide(PrecisionBits{256});
  BigInterval a(fraction(1, 3));
  const BigInterval::Precision narrow(PrecisionBits{64});
  BigInterval b = a;
  EXPECT_TRUE(b.lower() == a.lower() && b.upper() == a.upper());
  EXPECT_EQ(mpfi_get_prec(b.mpfi()), 256);
  const Rational lower = a.lower();
  const BigInterval c = std::move(a);
  EXPECT_TRUE(c.lower() == lower);
  a = c;
  EXPECT_TRUE(a.lower() == lower);
  a = BigInterval(5);
  const BigInterval& alias = a;
  a = alias;
  EXPECT_TRUE(a.lower() == Rational(5));
  b += a;
  b -= a;
  b *= BigInterval(3);
  EXPECT_TRUE(contains(b, 1));
  EXPECT_EQ(mpfi_get_prec(b.mpfi()), 64);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
