#include "proofs/checker/arithmetic/smith_form.hpp"

#include <gtest/gtest.h>

#include <random>

#include "proofs/checker/report/report.hpp"
#include "tests/kernel/topology/naive_homology.hpp"

namespace delcert::checker_tests {
namespace {

using checker::Column;
using checker::SmithForm;

struct Reduction {
  SmithForm form;
  std::vector<bool> used_rows, used_columns;
};

Reduction reduction(const test::NaiveMatrix& matrix, std::size_t columns) {
  std::vector<Column> by_columns(columns);
  for (std::size_t column = 0; column < columns; ++column) {
    for (std::size_t row = matrix.size(); row-- > 0;) {
      if (matrix[row][column] == 0) continue;
      by_columns[column].push_back({static_cast<std::uint32_t>(row), matrix[row][column]});
    }
  }
  Reduction result{{}, std::vector<bool>(matrix.size()), std::vector<bool>(columns)};
  result.form = checker::reduce(by_columns, matrix.size(), result.used_rows, result.used_columns);
  return result;
}

/// Compares it with elimination by hand.
void expect_right(const Reduction& found, const test::NaiveMatrix& matrix) {
  const auto diagonal = test::naive_diagonal(matrix);
  EXPECT_EQ(found.form.rank, diagonal.size());
  std::vector<std::string> torsion;
  for (const long long order : test::naive_invariant_factors(diagonal)) torsion.push_back(std::to_string(order));
  EXPECT_EQ(found.form.torsion, torsion);
  // The rows and columns that are used have an invertible submatrix.
  test::NaiveMatrix used;
  for (std::size_t row = 0; row < matrix.size(); ++row) {
    if (!found.used_rows[row]) continue;
    used.emplace_back();
    for (std::size_t column = 0; column < found.used_columns.size(); ++column) {
      if (found.used_columns[column]) used.back().push_back(matrix[row][column]);
    }
  }
  EXPECT_EQ(test::naive_diagonal(used), std::vector<long long>(used.size(), 1));
}

TEST(SmithForm, of_a_matrix_with_and_without_units) {
  const auto two = reduction({{2, 0}, {0, 6}}, 2);
  EXPECT_EQ(two.form.rank, 2U);
  EXPECT_EQ(two.form.torsion, (std::vector<std::string>{"2", "6"}));
  EXPECT_EQ(reduction({{4, 0}, {0, 6}}, 2).form.torsion, (std::vector<std::string>{"2", "12"}));
  const auto mixed = reduction({{0, 3, 3}, {1, 1, 1}, {0, 0, 5}}, 3);
  EXPECT_EQ(mixed.form.rank, 3U);
  EXPECT_EQ(mixed.form.torsion, (std::vector<std::string>{"15"}));
  EXPECT_EQ(mixed.used_rows, (std::vector<bool>{false, true, false}));
  EXPECT_EQ(mixed.used_columns, (std::vector<bool>{true, false, false}));
  EXPECT_EQ(reduction({{0, 0}}, 2).form.rank, 0U);
  EXPECT_EQ(reduction({}, 3).form.rank, 0U);
}

TEST(SmithForm, is_the_one_that_elimination_by_hand_finds) {
  std::mt19937_64 random(1);
  for (int round = 0; round < 500; ++round) {
    const std::size_t rows = 1 + random() % 6, columns = 1 + random() % 6, range = 2 + random() % 4;
    test::NaiveMatrix matrix(rows, std::vector<long long>(columns));
    for (auto& row : matrix) {
      for (long long& entry : row)
        entry = static_cast<long long>(random() % (2 * range - 1)) - static_cast<long long>(range - 1);
    }
    expect_right(reduction(matrix, columns), matrix);
  }
}

/// Of links that make several components, some with an odd way around, and of links that are 0.
TEST(SmithForm, of_links_is_that_of_the_matrix) {
  std::mt19937_64 random(2);
  int doubled = 0;
  for (int round = 0; round < 400; ++round) {
    const std::size_t rows = 2 + random() % 6, columns = 1 + random() % 8;
    const bool one_sided = random() % 3 == 0;
    std::vector<checker::Link> links(columns);
    test::NaiveMatrix matrix(rows, std::vector<long long>(columns, 0));
    for (std::size_t column = 0; column < columns; ++column) {
      const auto first = static_cast<std::uint32_t>(random() % rows),
                 second = static_cast<std::uint32_t>(random() % rows);
      if (first == second) continue;
      links[column] = {{first, second}, one_sided || random() % 4 == 0 ? 1 : -1};
      matrix[first][column] = 1;
      matrix[second][column] = links[column].sign;
    }
    for (const bool last_first : {false, true}) {
      Reduction found{{}, std::vector<bool>(rows), std::vector<bool>(columns)};
      found.form = checker::reduce_links(links, last_first, rows, found.used_rows, found.used_columns);
      expect_right(found, matrix);
      doubled += found.form.torsion.empty() ? 0 : 1;
    }
  }
  EXPECT_GT(doubled, 100);
}

TEST(SmithForm, of_coefficients_beyond_64_bits_is_left_undecided) {
  const long long large = INT64_MAX;
  EXPECT_THROW((void)reduction({{large, 1}, {1, large}}, 2), checker::Undecided);
  EXPECT_THROW((void)reduction({{-large, -2}, {1, 2}}, 2).form.rank, checker::Undecided);
  EXPECT_EQ(reduction({{large, 0}, {0, 1}}, 2).form.torsion, (std::vector<std::string>{std::to_string(large)}));
}

}  // namespace
}  // namespace delcert::checker_tests
