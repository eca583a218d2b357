#include "kernel/manifold/gluing/interval_matrix.hpp"

#include <gtest/gtest.h>

#include "kernel/number/rounding_guard.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

template <std::size_t m>
IntervalMatrix<m> matrix_of(const std::array<std::array<double, m>, m>& entries) {
  IntervalMatrix<m> result;
  for (std::size_t row = 0; row < m; ++row) {
    for (std::size_t k = 0; k < m; ++k) result[row][k] = Interval::exactly(entries[row][k]);
  }
  return result;
}

template <std::size_t m>
void expect_inverse(const std::array<std::array<double, m>, m>& entries) {
  const RoundingGuard guard;
  const IntervalMatrix<m> a = matrix_of<m>(entries);
  const IntervalMatrix<m> one = product(a, inverse_of(a));
  for (std::size_t row = 0; row < m; ++row) {
    for (std::size_t k = 0; k < m; ++k) {
      const double expected = row == k ? 1 : 0;
      EXPECT_LE(one[row][k].lower(), expected);
      EXPECT_GE(one[row][k].upper(), expected);
      EXPECT_LT(one[row][k].upper() - one[row][k].lower(), 1e-12);
    }
  }
}

TEST(IntervalMatrix, times_its_inverse_is_one) {
  expect_inverse<2>({{{3, 1}, {-2, 5}}});
  expect_inverse<3>({{{3, 1, 0.25}, {-2, 5, 1}, {0.5, -1, 2}}});
}

TEST(IntervalMatrix, has_no_inverse_that_is_known_if_the_determinant_may_be_0) {
  const RoundingGuard guard;
  const auto inverse = inverse_of(matrix_of<2>({{{1, 2}, {2, 4}}}));
  EXPECT_FALSE(inverse[0][0].upper() < 1e300);
}

TEST(IntervalMatrix, norms_are_bounded_from_above_and_not_by_much) {
  const RoundingGuard guard;
  // The singular values are 4 and 3.
  EXPECT_GE(norm_above(matrix_of<2>({{{0, -4}, {3, 0}}})), 4);
  EXPECT_LE(norm_above(matrix_of<2>({{{0, -4}, {3, 0}}})), 4.3);
  EXPECT_GE(length_above(std::array{Interval(3), Interval(4)}), 5);
  EXPECT_LE(length_above(std::array{Interval(3), Interval(4)}), 5 + 1e-12);
  const auto moved = applied(matrix_of<2>({{{1, 2}, {3, 4}}}), std::array{Interval(1), Interval(-1)});
  EXPECT_EQ(moved[0].lower(), -1);
  EXPECT_EQ(moved[1].upper(), -1);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
