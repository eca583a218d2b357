#include "kernel/topology/integer_matrix.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include "tests/kernel/topology/naive_homology.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

std::vector<Integer> factors_of(const NaiveMatrix& rows, std::size_t columns) {
  IntegerMatrix matrix(rows.size(), columns);
  for (std::size_t row = 0; row < rows.size(); ++row) {
    for (std::size_t column = 0; column < columns; ++column) fmpz_set_si(matrix.entry(row, column), rows[row][column]);
  }
  return matrix.invariant_factors();
}

TEST(IntegerMatrix, has_invariant_factors) {
  EXPECT_EQ(factors_of({{2, 4, 4}, {-6, 6, 12}, {10, 4, 16}}, 3), (std::vector<Integer>{2, 2, 156}));
  EXPECT_EQ(factors_of({{4, 0}, {0, 6}, {0, 0}}, 2), (std::vector<Integer>{2, 12}));
  EXPECT_EQ(factors_of({{0, 0}}, 2), std::vector<Integer>{});
  EXPECT_EQ(factors_of({}, 4), std::vector<Integer>{});
  EXPECT_EQ(factors_of({{}, {}}, 0), std::vector<Integer>{});
  EXPECT_EQ(factors_of({{-1, 2}}, 2), std::vector<Integer>{1});
  EXPECT_NE(factors_of({{2, 4, 4}, {-6, 6, 12}, {10, 4, -16}}, 3), (std::vector<Integer>{2, 2, 156}));
}

TEST(IntegerMatrix, has_entries_of_any_size) {
  IntegerMatrix matrix(2, 2);
  fmpz_one_2exp(matrix.entry(0, 0), 200);
  fmpz_set_ui(matrix.entry(1, 1), 3);
  EXPECT_EQ(matrix.invariant_factors(), (std::vector<Integer>{1, 3 * (Integer(1) << 200)}));
}

RC_GTEST_PROP(IntegerMatrix, has_the_factors_that_elimination_by_hand_finds, ()) {
  const auto rows = *rc::gen::inRange<std::size_t>(1, 6), columns = *rc::gen::inRange<std::size_t>(1, 6);
  NaiveMatrix matrix(rows, std::vector<long long>(columns));
  for (auto& row : matrix) {
    for (long long& entry : row) entry = *rc::gen::inRange(-4, 5);
  }
  const auto factors = factors_of(matrix, columns);
  const auto naive = naive_diagonal(matrix);
  RC_ASSERT(factors.size() == naive.size());
  std::vector<Integer> torsion;
  for (const Integer& factor : factors) {
    if (factor != 1) torsion.push_back(factor);
  }
  const auto expected = naive_invariant_factors(naive);
  RC_ASSERT(torsion == std::vector<Integer>(expected.begin(), expected.end()));
  for (std::size_t at = 1; at < factors.size(); ++at) RC_ASSERT(factors[at] % factors[at - 1] == 0);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
