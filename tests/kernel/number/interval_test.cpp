#include "kernel/number/interval.hpp"

#include <gtest/gtest.h>

#include "kernel/number/rounding_guard.hpp"
#include "kernel/number/scalar.hpp"
#include "tests/kernel/number/random_numbers.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

constexpr double infinity = std::numeric_limits<double>::infinity();

Interval made_of(const std::array<double, 2>& endpoints) { return Interval::between(endpoints[0], endpoints[1]); }

std::string shown(const Interval& interval) {
  std::array<char, 80> text{};
  std::snprintf(text.data(), text.size(), "[%a, %a]", interval.lower(), interval.upper());
  return text.data();
}

bool is_well_formed(const Interval& interval) { return interval.lower() <= interval.upper(); }

TEST(Interval, every_operation_encloses_the_exact_results_for_arguments_in_the_operands) {
  RandomNumbers random(1);
  for (int round = 0; round < 40000; ++round) {
    const auto first = random.hard_endpoints();
    const auto second = random.hard_endpoints();
    const Interval a = made_of(first);
    const Interval b = made_of(second);
    Interval sum;
    Interval difference;
    Interval product;
    Interval quotient;
    Interval negative;
    Interval power;
    Interval size;
    Interval least;
    Interval greatest;
    Interval root;
    {
      const RoundingGuard guard;
      sum = a + b;
      difference = a - b;
      product = a * b;
      quotient = a / b;
      negative = -a;
      power = square(a);
      size = absolute(a);
      least = minimum(a, b);
      greatest = maximum(a, b);
      root = square_root(a);
    }
    const std::string operands = shown(a) + " " + shown(b);
    for (int sample = 0; sample < 3; ++sample) {
      const Rational x = random.between(first);
      const Rational y = random.between(second);
      ASSERT_TRUE(contains(sum, x + y)) << operands;
      ASSERT_TRUE(contains(difference, x - y)) << operands;
      ASSERT_TRUE(contains(product, x * y)) << operands;
      ASSERT_TRUE(y == Rational(0) || contains(quotient, x / y)) << operands;
      ASSERT_TRUE(contains(negative, -x)) << operands;
      ASSERT_TRUE(contains(power, square(x))) << operands;
      ASSERT_TRUE(contains(size, absolute(x))) << operands;
      ASSERT_TRUE(contains(least, minimum(x, y))) << operands;
      ASSERT_TRUE(contains(greatest, maximum(x, y))) << operands;
      ASSERT_TRUE(x < Rational(0) || contains_root(root, x)) << operands;
    }
    for (const Interval& result : {sum, difference, product, quotient, negative, power, size, least, greatest, root})
      ASSERT_TRUE(is_well_formed(result)) << operands << " " << shown(result);
  }
}

// Enclosing alone could be had from the whole line: from points, endpoints are the doubles next to the exact result.
TEST(Interval, results_from_points_are_as_narrow_as_doubles_allow) {
  RandomNumbers random(2);
  const auto is_tight = [](const Interval& interval, const Rational& exact) {
    if (!contains(interval, exact)) return false;
    if (interval.lower() == interval.upper()) return true;
    return std::nextafter(interval.lower(), infinity) == interval.upper() &&
           (std::isinf(interval.lower()) || Rational::exactly(interval.lower()) != exact) &&
           (std::isinf(interval.upper()) || Rational::exactly(interval.upper()) != exact);
  };
  for (int round = 0; round < 40000; ++round) {
    const double first = random.hard_double();
    const double second = random.hard_double();
    const Rational x = Rational::exactly(first);
    const Rational y = Rational::exactly(second);
    const Interval a = Interval::exactly(first);
    const Interval b = Interval::exactly(second);
    Interval sum;
    Interval difference;
    Interval product;
    Interval quotient;
    Interval root;
    {
      const RoundingGuard guard;
      sum = a + b;
      difference = a - b;
      product = a * b;
      quotient = a / b;
      root = square_root(absolute(a));
    }
    const std::string operands = shown(a) + " " + shown(b);
    ASSERT_TRUE(is_tight(sum, x + y)) << operands << shown(sum);
    ASSERT_TRUE(is_tight(difference, x - y)) << operands << shown(difference);
    ASSERT_TRUE(is_tight(product, x * y)) << operands << shown(product);
    ASSERT_TRUE(second == 0 || is_tight(quotient, x / y)) << operands << shown(quotient);
    ASSERT_TRUE(contains_root(root, absolute(x))) << operands;
    ASSERT_TRUE(root.lower() == root.upper() || std::nextafter(root.lower(), infinity) == root.upper()) << operands;
  }
}

TEST(Interval, encloses_across_zero_within_two_powers_of_two_for_every_power) {
  // A point and the same point moved by 2^-k: what distinguishes them is lost, never inverted.
  for (int k = 1; k <= 1074; k += 13) {
    const Rational little = Rational::power_of_two(-k);
    Interval difference;
    {
      const RoundingGuard guard;
      difference = (Interval(1) + scalar_from<Interval>(little)) - Interval(1);
    }
    ASSERT_TRUE(contains(difference, little)) << k;
    ASSERT_NE(less(Interval(0), difference), Verdict::refuted) << k;
    ASSERT_EQ(less(Interval(0), difference), k <= 52 ? Verdict::proved : Verdict::undecided) << k;
  }
}

TEST(Interval, unbounded_operands_give_neither_nan_nor_a_wrong_enclosure) {
  const std::array<Interval, 6> unbounded = {Interval::between(-infinity, infinity), Interval::between(0, infinity),
                                             Interval::between(-infinity, 0),        Interval::between(1, infinity),
                                             Interval::between(-infinity, -1),       Interval::between(-2, infinity)};
  const std::array<Interval, 8> others = {Interval(0),
                                          Interval(1),
                                          Interval(-3),
                                          Interval::between(0, 1),
                                          Interval::between(-1, 0),
                                          Interval::between(-1, 2),
                                          unbounded[0],
                                          unbounded[3]};
  const std::array<Rational, 7> samples = {-1000000, -3, -1, 0, 1, 2, Rational::power_of_two(1023)};
  for (const Interval& a : unbounded) {
    for (const Interval& b : others) {
      std::array<Interval, 7> results;
      Interval root;
      {
        const RoundingGuard guard;
        results = {a + b, a - b, b - a, a * b, b * a, minimum(a, b), maximum(a, b)};
        root = square_root(a);
      }
      const std::string operands = shown(a) + " " + shown(b);
      for (const Interval& result : results) EXPECT_TRUE(is_well_formed(result)) << operands << shown(result);
      EXPECT_TRUE(is_well_formed(root)) << operands;
      for (const Rational& x : samples) {
        for (const Rational& y : samples) {
          if (!contains(a, x) || !contains(b, y)) continue;
          const std::array<Rational, 7> exact = {x + y, x - y, y - x, x * y, y * x, minimum(x, y), maximum(x, y)};
          for (std::size_t i = 0; i < exact.size(); ++i) EXPECT_TRUE(contains(results[i], exact[i])) << operands << i;
        }
      }
      Interval quotient;
      Interval inverse_quotient;
      Interval power;
      {
        const RoundingGuard guard;
        quotient = a / b;
        inverse_quotient = b / a;
        power = square(a);
      }
      EXPECT_TRUE(is_well_formed(quotient)) << operands << shown(quotient);
      EXPECT_TRUE(is_well_formed(inverse_quotient)) << operands << shown(inverse_quotient);
      EXPECT_TRUE(is_well_formed(power)) << operands << shown(power);
      for (const Rational& x : samples)
        for (const Rational& y : samples)
          if (contains(a, x) && contains(b, y)) {
            EXPECT_TRUE(y == Rational(0) || contains(quotient, x / y)) << operands;
            EXPECT_TRUE(x == Rational(0) || contains(inverse_quotient, y / x)) << operands;
            EXPECT_TRUE(contains(power, square(x))) << operands;
          }
    }
  }
}

// CGAL 5.5.1 compiled for SSE 4.1 forgets that 0 times anything is 0; wrong_flags builds this file so as well.
TEST(Interval, products_of_an_end_at_zero_with_an_unbounded_factor_contain_zero) {
  const RoundingGuard guard;
  for (const double zero : {0.0, -0.0}) {
    for (const Interval& a :
         {Interval::between(-2, zero), Interval::between(zero, 3), Interval::between(-infinity, zero),
          Interval::between(zero, infinity), Interval::between(zero, zero)}) {
      for (const Interval& b : {Interval::between(1, infinity), Interval::between(2, infinity),
                                Interval::between(-infinity, -1), Interval::between(-infinity, infinity)}) {
        EXPECT_TRUE(contains(a * b, Rational(0))) << shown(a) << shown(b) << shown(a * b);
        EXPECT_TRUE(contains(b * a, Rational(0))) << shown(b) << shown(a) << shown(b * a);
      }
    }
  }
}

TEST(Interval, division_by_an_interval_around_zero_is_unbounded) {
  const RoundingGuard guard;
  for (const Interval& divisor :
       {Interval(0), Interval::between(-1, 1), Interval::between(0, 1), Interval::between(-1, 0)}) {
    const Interval quotient = Interval(1) / divisor;
    EXPECT_TRUE(quotient.upper() == infinity || quotient.lower() == -infinity) << shown(divisor);
  }
}

TEST(Interval, square_root_cuts_off_what_is_negative) {
  const RoundingGuard guard;
  EXPECT_EQ(square_root(Interval::between(-2, 4)).lower(), 0.0);
  EXPECT_EQ(square_root(Interval::between(-2, 4)).upper(), 2.0);
  EXPECT_EQ(square_root(Interval::between(-2, -1)).upper(), 0.0);
}

TEST(Interval, verdicts_hold_for_all_arguments_and_are_undecided_only_where_some_differ) {
  RandomNumbers random(3);
  for (int round = 0; round < 40000; ++round) {
    const auto first = random.hard_endpoints();
    const auto second = random.below(2) == 0 ? random.hard_endpoints() : std::array<double, 2>{first[1], first[1]};
    const Interval a = made_of(first);
    const Interval b = made_of(second);
    const bool some_less = first[0] < second[1];
    const bool some_not = first[1] >= second[0];
    const Verdict expected = !some_not ? Verdict::proved : !some_less ? Verdict::refuted : Verdict::undecided;
    ASSERT_EQ(less(a, b), expected) << shown(a) << shown(b);
    ASSERT_EQ(less_equal(b, a), negation(expected)) << shown(a) << shown(b);
    const bool has_zero = first[0] <= 0 && 0 <= first[1];
    const bool is_point = first[0] == 0 && first[1] == 0;
    ASSERT_EQ(is_zero(a), !has_zero ? Verdict::refuted : is_point ? Verdict::proved : Verdict::undecided) << shown(a);
  }
}

TEST(Interval, compound_assignments_are_the_operations) {
  const RoundingGuard guard;
  Interval x = Interval(2);
  x += Interval(3);
  x *= Interval(4);
  x -= Interval(6);
  EXPECT_EQ(x.lower(), 14.0);
  EXPECT_EQ(x.upper(), 14.0);
  EXPECT_EQ(is_zero(Interval()), Verdict::proved);
}

/// A stream of operations that is the same everywhere, as a hash of all endpoints.
std::uint64_t hash_of_a_stream_of_operations() {
  RandomNumbers random(4);
  std::uint64_t hash = 0xcbf29ce484222325U;
  const auto add = [&hash](double endpoint) {
    // One zero: which of the two comes out of a minimum depends on the order of the operands.
    const auto bits = endpoint == 0 ? 0 : std::bit_cast<std::uint64_t>(endpoint);
    for (unsigned byte = 0; byte < 8; ++byte) hash = (hash ^ (bits >> (8 * byte) & 0xffU)) * 0x100000001b3U;
  };
  std::array<Interval, 16> pool;
  for (Interval& entry : pool) entry = made_of(random.hard_endpoints());
  for (int step = 0; step < 200000; ++step) {
    const Interval fresh = made_of(random.hard_endpoints());
    const Interval a = pool[random.below(pool.size())];
    const Interval b = pool[random.below(pool.size())];
    Interval result;
    {
      const RoundingGuard guard;
      switch (random.below(10)) {
        case 0:
          result = a + b;
          break;
        case 1:
          result = a - b;
          break;
        case 2:
          result = a * b;
          break;
        case 3:
          result = a / b;
          break;
        case 4:
          result = square(a);
          break;
        case 5:
          result = square_root(a);
          break;
        case 6:
          result = absolute(a);
          break;
        case 7:
          result = minimum(a, b);
          break;
        case 8:
          result = maximum(a, b);
          break;
        default:
          result = fresh;
      }
    }
    add(result.lower());
    add(result.upper());
    // Infinities would take over the pool.
    pool[random.below(pool.size())] = std::isfinite(result.lower()) && std::isfinite(result.upper()) ? result : fresh;
  }
  return hash;
}

TEST(Interval, endpoints_are_the_same_for_every_compiler_and_optimisation) {
  EXPECT_EQ(hash_of_a_stream_of_operations(), 0x148e7ae497300fbeU);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
