#include "kernel/theorems/bend_bound.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "kernel/number/rounding_guard.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

using Form = std::vector<double>;

template <int m>
double bound_of(const Form& form, std::size_t n, double steepness) {
  const RoundingGuard guard;
  std::vector<Interval> entries;
  for (const double entry : form) entries.push_back(Interval::exactly(entry));
  return bend_bound<m>(entries.data(), n, Interval::exactly(steepness)).upper();
}

double value_of(const Form& form, const std::vector<double>& t) {
  double result = 0;
  for (std::size_t k = 0; k < t.size(); ++k) {
    for (std::size_t l = 0; l < t.size(); ++l) result += form[k * t.size() + l] * t[k] * t[l];
  }
  return result;
}

/// A vector of this length in these axes.
void fill(std::vector<double>& t, std::size_t from, std::size_t to, double length, std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  double squared = 0;
  for (std::size_t axis = from; axis < to; ++axis) {
    t[axis] = normal(random);
    squared += t[axis] * t[axis];
  }
  for (std::size_t axis = from; axis < to; ++axis) t[axis] *= length / std::sqrt(squared);
}

template <int m>
void expect_above_values(std::size_t n) {
  std::mt19937_64 random(n * 10 + m);
  std::normal_distribution<double> normal;
  for (int draw = 0; draw < 50; ++draw) {
    Form form(n * n);
    for (std::size_t k = 0; k < n; ++k) {
      for (std::size_t l = 0; l <= k; ++l) form[k * n + l] = form[l * n + k] = normal(random);
    }
    const double steepness = draw % 2 == 0 ? 0.25 : 1.5;
    const double bound = bound_of<m>(form, n, steepness);
    for (int vector = 0; vector < 200; ++vector) {
      std::vector<double> t(n);
      fill(t, 0, m, 1, random);
      fill(t, m, n, steepness, random);
      EXPECT_LE(std::fabs(value_of(form, t)), bound * (1 + 1e-12));
    }
  }
}

TEST(BendBound, is_above_the_values_at_vectors) {
  expect_above_values<1>(2);
  expect_above_values<1>(4);
  expect_above_values<2>(3);
  expect_above_values<2>(6);
  expect_above_values<3>(5);
}

/// Each block alone: the bound is attained, so that none of its terms can be left out.
TEST(BendBound, is_attained_by_each_block) {
  EXPECT_NEAR(bound_of<1>({3, 0, 0, 0}, 2, 0.5), 3, 1e-12);
  EXPECT_NEAR(bound_of<1>({0, 1, 1, 0}, 2, 0.5), value_of({0, 1, 1, 0}, {1, 0.5}), 1e-12);
  EXPECT_NEAR(bound_of<1>({0, 0, 0, 8}, 2, 0.5), value_of({0, 0, 0, 8}, {1, 0.5}), 1e-12);
  // Of a surface: the greater eigenvalue in size, which is less than the norm of all entries.
  EXPECT_NEAR(bound_of<2>({1, 0, 0, 0, -2, 0, 0, 0, 0}, 3, 0.5), 2, 1e-12);
  EXPECT_NEAR(bound_of<2>({0, 1, 0, 1, 0, 0, 0, 0, 0}, 3, 0.5), 1, 1e-12);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
