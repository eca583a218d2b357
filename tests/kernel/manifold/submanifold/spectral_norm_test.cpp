#include "kernel/manifold/submanifold/spectral_norm.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "kernel/number/rounding_guard.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

/// The norm of a matrix, row by row, each entry widened by as much.
double norm_above(const std::vector<double>& entries, std::size_t columns, double wider = 0) {
  const RoundingGuard guard;
  std::vector<Interval> enclosed;
  for (const double entry : entries) enclosed.push_back(Interval::exactly(entry) + Interval::between(-wider, wider));
  return spectral_norm(enclosed, columns).upper();
}

/// The greatest |Ax| on directions of the space of three columns: from below.
double norm_below(const std::vector<double>& a) {
  double result = 0;
  constexpr int steps = 60;
  for (int i = 0; i <= steps; ++i) {
    for (int k = 0; k <= 2 * steps; ++k) {
      const double theta = M_PI * i / steps;
      const double phi = M_PI * k / steps;
      const std::array x{std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)};
      double squared = 0;
      for (std::size_t row = 0; row < a.size() / 3; ++row)
        squared += std::pow(a[3 * row] * x[0] + a[3 * row + 1] * x[1] + a[3 * row + 2] * x[2], 2);
      result = std::max(result, std::sqrt(squared));
    }
  }
  return result;
}

double frobenius(const std::vector<double>& a) {
  double squared = 0;
  for (const double entry : a) squared += entry * entry;
  return std::sqrt(squared);
}

TEST(SpectralNorm, is_that_of_a_matrix_whose_norm_is_known) {
  // The eigenvalues of AᵀA are 15 ± √221.
  const double exact = std::sqrt(15 + std::sqrt(221.0));
  EXPECT_GE(norm_above({1, 2, 3, 4}, 2), exact * (1 - 1e-15));
  EXPECT_LT(norm_above({1, 2, 3, 4}, 2), exact * 1.001);
  EXPECT_GE(norm_above({3, 0, 0, 0, -3, 0, 0, 0, 3}, 3), 3);
  EXPECT_LT(norm_above({3, 0, 0, 0, -3, 0, 0, 0, 3}, 3), 3.03);  // 3^(1/128)
  EXPECT_EQ(norm_above({3, 4}, 2), 5);
  EXPECT_EQ(norm_above({3, 4}, 1), 5);
  EXPECT_EQ(norm_above({0, 0, 0, 0}, 2), 0);
  EXPECT_EQ(norm_above({1, std::numeric_limits<double>::infinity(), 0, 0}, 2), std::numeric_limits<double>::infinity());
}

TEST(SpectralNorm, is_above_what_vectors_show_and_below_the_norm_of_Frobenius) {
  for (int seed = 1; seed < 40; ++seed) {
    for (const std::size_t rows : {1U, 2U, 3U, 5U}) {
      std::vector<double> a;
      for (std::size_t at = 0; at < 3 * rows; ++at) a.push_back(std::sin(seed * 7.3 + static_cast<double>(at * at)));
      const double bound = norm_above(a, 3);
      const double seen = norm_below(a);
      EXPECT_GE(bound, seen);
      EXPECT_LT(bound, seen * 1.02);
      EXPECT_LE(bound, frobenius(a) * (1 + 1e-14));
      // Half of it would be refuted by a vector.
      EXPECT_LT(bound / 2, seen);
    }
  }
}

TEST(SpectralNorm, is_a_bound_for_all_matrices_with_entries_in_the_intervals) {
  const std::vector<double> a{1, 0.25, -2, 0.5, 1.5, 0, -0.25, 0, 1};
  std::vector<double> other = a;
  for (std::size_t at = 0; at < other.size(); ++at) other[at] += other[at] < 0 ? -0.125 : 0.125;
  EXPECT_GE(norm_above(a, 3, 0.125), norm_below(other));
  EXPECT_LT(norm_above(a, 3), norm_below(other));
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
