#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace delcert::checker {

/// A face and its coefficient, not 0.
struct Entry {
  std::uint32_t face;
  std::int64_t coefficient;
};
using Column = std::vector<Entry>;  // by decreasing face

/// What is asked of a matrix: its rank and the entries other than 0 and 1 of its Smith normal form, in order.
struct SmithForm {
  std::size_t rank = 0;
  std::vector<std::string> torsion;
};

/// The form of the matrix with these columns and so many rows, and rows and columns whose submatrix is invertible over
/// the integers: they are marked as used. Throws Undecided for a coefficient beyond 64 bits, and where more than 2^12
/// entries are left for FLINT.
SmithForm reduce(std::vector<Column> columns, std::size_t rows, std::vector<bool>& used_rows,
                 std::vector<bool>& used_columns);

/// A column that is the sum of a 1 in one row and `sign`, which is 1 or -1, in another. It is 0 if it is not set.
struct Link {
  std::array<std::uint32_t, 2> row{0, 0};
  std::int64_t sign = -1;
};
/// The same of a matrix of links, the last ones first or the first ones.
SmithForm reduce_links(const std::vector<Link>& links, bool last_first, std::size_t rows, std::vector<bool>& used_rows,
                       std::vector<bool>& used_columns);

}  // namespace delcert::checker
