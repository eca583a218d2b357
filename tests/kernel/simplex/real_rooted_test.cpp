#include "kernel/simplex/real_rooted.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/kernel/number/random_numbers.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

/// The product of all q·x − p over the roots p/q.
std::vector<Integer> polynomial_with(const std::vector<Rational>& roots) {
  std::vector<Integer> result{1};
  for (const Rational& root : roots) {
    std::vector<Integer> next(result.size() + 1, Integer(0));
    for (std::size_t power = 0; power < result.size(); ++power) {
      next[power + 1] += result[power] * root.denominator();
      next[power] -= result[power] * root.numerator();
    }
    result = std::move(next);
  }
  return result;
}

/// Sorted, the intervals enclose the sorted roots one by one.
void expect_enclosed(std::vector<BigInterval> enclosures, std::vector<Rational> roots) {
  ASSERT_EQ(enclosures.size(), roots.size());
  std::sort(roots.begin(), roots.end());
  std::sort(enclosures.begin(), enclosures.end(),
            [](const BigInterval& a, const BigInterval& b) { return a.lower() < b.lower(); });
  for (std::size_t at = 0; at < roots.size(); ++at) {
    EXPECT_LE(enclosures[at].lower(), roots[at]);
    EXPECT_LE(roots[at], enclosures[at].upper());
  }
}

TEST(SeparatedRoots, of_random_products_are_enclosed_to_about_the_precision) {
  RandomNumbers random(7);
  for (int round = 0; round < 200; ++round) {
    std::vector<Rational> roots;
    for (std::size_t count = 1 + random.below(6); roots.size() < count;) {
      const Rational root = Rational(static_cast<long>(random.below(2001)) - 1000) / Rational(random.below(50) + 1);
      if (root != Rational(0) && std::find(roots.begin(), roots.end(), root) == roots.end()) roots.push_back(root);
    }
    const auto found = separated_roots(polynomial_with(roots));
    ASSERT_TRUE(found.has_value());
    expect_enclosed(*found, roots);
    for (const BigInterval& one : *found) {
      EXPECT_LE(one.upper() - one.lower(), absolute(one.upper()) * Rational::power_of_two(-60));
    }
  }
}

TEST(SeparatedRoots, zero_may_be_repeated_others_may_not) {
  const std::vector<Rational> zeros{0, 0, 3};
  expect_enclosed(separated_roots(polynomial_with(zeros)).value(), zeros);
  EXPECT_FALSE(separated_roots(polynomial_with({2, 2, 3})).has_value());
  const Rational close = Rational(2) + Rational::power_of_two(-400);
  EXPECT_FALSE(separated_roots(polynomial_with({2, close})).has_value());
}

TEST(LocatedRoots, are_next_to_integers_with_their_multiplicities) {
  RandomNumbers random(8);
  for (int round = 0; round < 200; ++round) {
    std::vector<Rational> roots;
    for (std::size_t count = 1 + random.below(6); roots.size() < count;) {
      const Rational root = Rational(static_cast<long>(random.below(201)) - 100) / Rational(random.below(3) + 1);
      const std::size_t copies = 1 + random.below(2);
      for (std::size_t copy = 0; copy < copies; ++copy) roots.push_back(root);
    }
    const auto found = located_roots(polynomial_with(roots), 100);
    expect_enclosed(found, roots);
    for (const BigInterval& one : found) EXPECT_EQ(one.upper() - one.lower(), Rational(1));
  }
}

TEST(LocatedRoots, at_the_ends_and_nearly_equal_are_found) {
  const std::vector<Rational> roots{-5, -5, 5, Rational(5) - Rational::power_of_two(-300)};
  expect_enclosed(located_roots(polynomial_with(roots), 5), roots);
  expect_enclosed(located_roots(polynomial_with({0}), 0), {0});
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
