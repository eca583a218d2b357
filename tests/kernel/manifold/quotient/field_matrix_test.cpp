#include "kernel/manifold/quotient/field_matrix.hpp"

#include <gtest/gtest.h>

#include <random>
#include <stdexcept>

#include "tests/kernel/manifold/quotient/samples.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

FieldMatrix some_matrix(const FieldElement::Field& field, std::size_t order, std::mt19937_64& random) {
  FieldMatrix result(order);
  for (std::size_t row = 0; row < order; ++row) {
    for (std::size_t column = 0; column < order; ++column)
      result(row, column) = FieldElement(
          field, {Rational(static_cast<long>(random() % 7) - 3), Rational(static_cast<long>(random() % 3) - 1)});
  }
  return result;
}

/// By Leibniz's formula along the first row.
FieldElement expanded_determinant(const FieldMatrix& a) {
  if (a.order() == 1) return a(0, 0);
  FieldElement result(0);
  for (std::size_t left_out = 0; left_out < a.order(); ++left_out) {
    FieldMatrix minor(a.order() - 1);
    for (std::size_t row = 1; row < a.order(); ++row) {
      for (std::size_t column = 0; column + 1 < a.order(); ++column)
        minor(row - 1, column) = a(row, column < left_out ? column : column + 1);
    }
    const FieldElement term = a(0, left_out) * expanded_determinant(minor);
    result = left_out % 2 == 0 ? result + term : result - term;
  }
  return result;
}

TEST(FieldMatrix, determinants_and_inverses_are_exact) {
  std::mt19937_64 random(4);
  const auto field = golden_field();
  int singular = 0;
  for (int trial = 0; trial < 40; ++trial) {
    FieldMatrix a = some_matrix(field, 1 + random() % 4, random);
    if (trial % 5 == 0) {
      for (std::size_t column = 0; column < a.order(); ++column)
        a(a.order() - 1, column) = a.order() == 1 ? FieldElement(0) : a(0, column);
    }
    const FieldElement value = determinant(a);
    EXPECT_EQ(value, expanded_determinant(a));
    if (value.is_zero()) {
      ++singular;
      EXPECT_THROW((void)inverse(a), std::domain_error);
    } else {
      EXPECT_TRUE(is_identity(a * inverse(a)));
      EXPECT_TRUE(is_identity(inverse(a) * a));
    }
  }
  EXPECT_GE(singular, 8);
}

TEST(FieldMatrix, products_transposes_and_traces) {
  std::mt19937_64 random(5);
  const auto field = golden_field();
  for (int trial = 0; trial < 10; ++trial) {
    const FieldMatrix a = some_matrix(field, 3, random);
    const FieldMatrix b = some_matrix(field, 3, random);
    EXPECT_EQ(transposed(a * b), transposed(b) * transposed(a));
    EXPECT_EQ(trace(a * b), trace(b * a));
    EXPECT_EQ((a * b).column(1), a * b.column(1));
    EXPECT_TRUE(determinant(a - a).is_zero());
    EXPECT_EQ(Precedes{}(a, b), !(a == b) && !Precedes{}(b, a));
  }
}

TEST(FieldMatrix, the_common_kernel_is_orthogonal_to_all_rows) {
  std::mt19937_64 random(6);
  const auto field = golden_field();
  for (int trial = 0; trial < 20; ++trial) {
    const FieldMatrix a = some_matrix(field, 4, random);
    const FieldVector x = common_kernel({a.column(0), a.column(1), a.column(2)});
    for (std::size_t k = 0; k < 3; ++k) EXPECT_TRUE(pairing(a.column(k), x).is_zero());
    // Against the fourth it is the determinant, up to sign.
    const FieldElement product = pairing(a.column(3), x);
    EXPECT_TRUE(product == determinant(a) || product == -determinant(a));
  }
  const FieldVector row{FieldElement(1), FieldElement(2), FieldElement(3)};
  for (const FieldElement& entry : common_kernel({row, row})) EXPECT_TRUE(entry.is_zero());
}

TEST(FieldMatrix, positive_definiteness_is_decided_at_the_border) {
  const auto field = golden_field();
  // [[1, t − 1], [t − 1, 2 − t]] is singular: (t − 1)² = 2 − t.
  FieldMatrix border = matrix(field, {{"1", "t - 1"}, {"t - 1", "2 - t"}});
  EXPECT_FALSE(is_positive_definite(border));
  border(1, 1) += FieldElement(Rational::power_of_two(-300));
  EXPECT_TRUE(is_positive_definite(border));
  EXPECT_FALSE(is_positive_definite(matrix(nullptr, {{"0", "0"}, {"0", "1"}})));
  EXPECT_FALSE(is_positive_definite(matrix(nullptr, {{"-1", "0"}, {"0", "-1"}})));
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
