#include "kernel/simplex/spectrum.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "kernel/number/rounding_guard.hpp"
#include "kernel/simplex/inertia.hpp"
#include "tests/kernel/number/random_numbers.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

using Matrix = SymmetricMatrix<Rational>;

/// From the rows of the lower triangle.
Matrix matrix_of(const std::vector<std::vector<Rational>>& rows) {
  Matrix result(rows.size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    for (std::size_t j = 0; j <= i; ++j) result(i, j) = rows[i][j];
  }
  return result;
}

Matrix random_matrix(std::size_t order, RandomNumbers& random) {
  Matrix result(order);
  for (std::size_t i = 0; i < order; ++i) {
    for (std::size_t j = 0; j <= i; ++j) result(i, j) = Rational(static_cast<int>(random.below(41)) - 20) / Rational(7);
  }
  return result;
}

void expect_contains(const Algebraic& exact, const BigInterval& enclosure) {
  EXPECT_NE(less(exact, Algebraic(enclosure.lower())), Verdict::proved);
  EXPECT_NE(less(Algebraic(enclosure.upper()), exact), Verdict::proved);
}

/// Each rung that has eigenvalues encloses the exact ones.
void expect_enclosed_on_every_rung(const Matrix& matrix, bool filter_must_know = true) {
  const auto exact = eigenvalues<Algebraic>(matrix);
  ASSERT_TRUE(exact.has_value());
  ASSERT_EQ(exact->size(), matrix.order());
  for (std::size_t at = 1; at < exact->size(); ++at) EXPECT_NE(less((*exact)[at - 1], (*exact)[at]), Verdict::proved);
  for (const unsigned bits : {16U, 128U, 512U}) {
    const BigInterval::Precision precision(PrecisionBits{bits});
    const auto big = eigenvalues<BigInterval>(matrix);
    ASSERT_TRUE(big.has_value());
    ASSERT_EQ(big->size(), matrix.order());
    for (std::size_t at = 0; at < exact->size(); ++at) expect_contains((*exact)[at], (*big)[at]);
  }
  std::vector<std::pair<double, double>> filter;
  {
    const RoundingGuard guard;
    const auto found = eigenvalues<Interval>(matrix);
    EXPECT_TRUE(found.has_value() || !filter_must_know);
    if (!found) return;
    for (const Interval& one : *found) filter.emplace_back(one.lower(), one.upper());
  }
  ASSERT_EQ(filter.size(), matrix.order());
  for (std::size_t at = 0; at < exact->size(); ++at) {
    EXPECT_NE(less((*exact)[at], Algebraic(Rational::exactly(filter[at].first))), Verdict::proved);
    EXPECT_NE(less(Algebraic(Rational::exactly(filter[at].second)), (*exact)[at]), Verdict::proved);
  }
}

TEST(Spectrum, known_eigenvalues_are_found_exactly) {
  const auto exact = eigenvalues<Algebraic>(matrix_of({{2}, {1, 2}}));
  ASSERT_TRUE(exact.has_value());
  EXPECT_TRUE((*exact)[0].rational() == Rational(3));
  EXPECT_TRUE((*exact)[1].rational() == Rational(1));
  const auto golden = eigenvalues<Algebraic>(matrix_of({{1}, {1, 0}}));
  EXPECT_EQ(is_zero((*golden)[0] * Algebraic(2) - Algebraic(1) - square_root(Algebraic(5))), Verdict::proved);
  EXPECT_EQ(is_zero((*golden)[1] * Algebraic(2) - Algebraic(1) + square_root(Algebraic(5))), Verdict::proved);
}

TEST(Spectrum, the_characteristic_polynomial_is_that_of_the_determinant) {
  // det(xI − A) = x² − 4x + 3
  EXPECT_EQ(characteristic_polynomial(matrix_of({{2}, {1, 2}})),
            (std::vector<Rational>{Rational(3), Rational(-4), Rational(1)}));
  EXPECT_EQ(characteristic_polynomial(Matrix(0)), std::vector<Rational>{Rational(1)});
}

TEST(Spectrum, multiple_eigenvalues_are_there_as_often_as_their_multiplicity) {
  const Matrix all_ones = matrix_of({{1}, {1, 1}, {1, 1, 1}, {1, 1, 1, 1}});
  const auto exact = eigenvalues<Algebraic>(all_ones);
  ASSERT_EQ(exact->size(), 4U);
  EXPECT_TRUE((*exact)[0].rational() == Rational(4));
  for (std::size_t at = 1; at < 4; ++at) EXPECT_EQ(is_zero((*exact)[at]), Verdict::proved);
  expect_enclosed_on_every_rung(all_ones);
  expect_enclosed_on_every_rung(matrix_of({{3}, {0, 3}, {0, 0, -3}}));
  expect_enclosed_on_every_rung(Matrix(3), false);
}

TEST(Spectrum, nearly_singular_and_badly_scaled_matrices_are_enclosed) {
  for (const long exponent : {-20L, -60L, -200L}) {
    const Rational tiny = Rational::power_of_two(exponent);
    expect_enclosed_on_every_rung(matrix_of({{1}, {1, Rational(1) + tiny}}), false);
    expect_enclosed_on_every_rung(matrix_of({{tiny}, {tiny, Rational(1)}, {0, tiny, square(tiny)}}), false);
    expect_enclosed_on_every_rung(matrix_of({{Rational(1) / tiny}, {1, tiny}}), false);
  }
}

TEST(Spectrum, the_filter_is_as_narrow_as_it_says) {
  RandomNumbers random(3);
  for (int round = 0; round < 50; ++round) {
    const Matrix matrix = random_matrix(2 + static_cast<std::size_t>(round) % 4, random);
    const RoundingGuard guard;
    const auto found = eigenvalues<Interval>(matrix);
    ASSERT_TRUE(found.has_value());
    const double size = std::max(std::abs(found->front().upper()), std::abs(found->back().lower()));
    for (const Interval& one : *found) EXPECT_LE(one.upper() - one.lower(), 0x1p-30 * size);
  }
}

TEST(Spectrum, random_matrices_are_enclosed_on_every_rung_and_agree_with_the_inertia) {
  RandomNumbers random(7);
  for (int round = 0; round < 30; ++round) {
    const Matrix matrix = random_matrix(1 + static_cast<std::size_t>(round) % 5, random);
    expect_enclosed_on_every_rung(matrix);
    const auto signs = inertia(matrix);
    ASSERT_TRUE(signs.has_value());
    std::size_t positive = 0;
    std::size_t negative = 0;
    const auto exact = eigenvalues<Algebraic>(matrix);
    for (const Algebraic& one : *exact) {
      if (is_proved(less(Algebraic(0), one))) ++positive;
      if (is_proved(less(one, Algebraic(0)))) ++negative;
    }
    EXPECT_EQ(positive, signs->positive);
    EXPECT_EQ(negative, signs->negative);
  }
}

TEST(Spectrum, scaled_matrices_have_their_eigenvalues_at_any_size) {
  for (const long exponent : {-300L, 0L, 301L}) {
    const Rational unit = Rational::power_of_two(exponent);
    SymmetricMatrix<Rational> matrix(2);
    matrix(0, 0) = matrix(1, 1) = unit;
    matrix(0, 1) = Rational(2) * unit;
    // 3 and −1.
    const auto enclosed = eigenvalues_by_scaling<BigInterval>(matrix);
    ASSERT_TRUE(enclosed.has_value());
    EXPECT_LE((*enclosed)[0].lower(), Rational(3) * unit);
    EXPECT_GE((*enclosed)[0].upper(), Rational(3) * unit);
    EXPECT_LE((*enclosed)[1].lower(), -unit);
    EXPECT_GE((*enclosed)[1].upper(), -unit);
    EXPECT_LT((*enclosed)[0].upper() - (*enclosed)[0].lower(), Rational::power_of_two(exponent - 100));
    const auto exact = eigenvalues_by_scaling<Algebraic>(matrix);
    EXPECT_EQ((*exact)[0].rational(), Rational(3) * unit);
    EXPECT_EQ((*exact)[1].rational(), -unit);
  }
  const auto none = eigenvalues_by_scaling<BigInterval>(SymmetricMatrix<Rational>(3));
  EXPECT_EQ(none->size(), 3U);
  EXPECT_EQ((*none)[2].upper(), Rational(0));
}

TEST(Spectrum, surds_know_matrices_of_order_one_at_most) {
  EXPECT_TRUE(eigenvalues<Surd>(Matrix(0))->empty());
  EXPECT_TRUE(eigenvalues<Surd>(matrix_of({{5}}))->front().rational() == Rational(5));
  EXPECT_EQ(eigenvalues<Surd>(matrix_of({{5}, {0, 5}})).exists(), Verdict::undecided);
}

TEST(Spectrum, the_norm_is_the_larger_size_of_the_first_and_the_last) {
  const std::vector<Algebraic> none;
  EXPECT_EQ(is_zero(norm_from_eigenvalues(none)), Verdict::proved);
  EXPECT_TRUE(norm_from_eigenvalues(*eigenvalues<Algebraic>(matrix_of({{2}, {0, -5}}))).rational() == Rational(5));
  EXPECT_TRUE(norm_from_eigenvalues(*eigenvalues<Algebraic>(matrix_of({{7}, {0, -5}}))).rational() == Rational(7));
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
