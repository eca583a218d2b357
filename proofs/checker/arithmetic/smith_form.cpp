#include "proofs/checker/arithmetic/smith_form.hpp"

#include <flint/fmpz_mat.h>

#include <algorithm>
#include <map>

#include "proofs/checker/report/budget.hpp"
#include "proofs/checker/report/report.hpp"

namespace delcert::checker {
namespace {

/// Of the matrix that is left for FLINT, whose time and memory grow with a higher power of its size.
constexpr std::size_t most_entries = std::size_t{1} << 12;

/// Subtracts the multiple of b, which begins with 1 or -1, that rids a of its entry number `begin`. `rest` is memory.
void subtract(Column& a, std::size_t begin, const Column& b, Column& rest) {
  constexpr const char* too_large = "a coefficient of the homology is beyond 64 bits";
  std::int64_t factor = 0;
  if (__builtin_mul_overflow(a[begin].coefficient, b[0].coefficient, &factor)) throw Undecided(too_large);
  Budget::spend(10 + a.size() + b.size());
  if (a.size() == begin + 2 && b.size() == 2 && a[begin + 1].face != b[1].face) {
    // As below, without memory.
    Entry other{b[1].face, 0};
    if (__builtin_mul_overflow(factor, b[1].coefficient, &other.coefficient) ||
        __builtin_sub_overflow(0, other.coefficient, &other.coefficient))
      throw Undecided(too_large);
    a[begin] = a[begin + 1];
    a[begin + 1] = other;
    if (a[begin].face < other.face) std::swap(a[begin], a[begin + 1]);
    return;
  }
  rest.clear();
  std::size_t i = begin, j = 0;
  while (i < a.size() || j < b.size()) {
    const bool from_a = j == b.size() || (i < a.size() && a[i].face >= b[j].face);
    const bool from_b = i == a.size() || (j < b.size() && b[j].face >= a[i].face);
    Entry entry{from_a ? a[i].face : b[j].face, from_a ? a[i].coefficient : 0};
    std::int64_t product = 0;
    if (from_b && (__builtin_mul_overflow(factor, b[j].coefficient, &product) ||
                   __builtin_sub_overflow(entry.coefficient, product, &entry.coefficient)))
      throw Undecided(too_large);
    if (entry.coefficient != 0) rest.push_back(entry);
    i += from_a ? 1 : 0;
    j += from_b ? 1 : 0;
  }
  a.resize(begin);
  a.insert(a.end(), rest.begin(), rest.end());
}

/// The form of a matrix of few columns, by FLINT.
SmithForm smith_form(const std::vector<Column>& columns) {
  std::map<std::uint32_t, slong> rows;
  for (const Column& column : columns) {
    for (const Entry& entry : column) rows.try_emplace(entry.face, static_cast<slong>(rows.size()));
  }
  SmithForm form;
  if (rows.empty()) return form;
  if (rows.size() > most_entries / columns.size()) throw Undecided("the homology has too much torsion");
  fmpz_mat_t matrix, diagonal;
  for (fmpz_mat_struct* m : {matrix, diagonal})
    fmpz_mat_init(m, static_cast<slong>(rows.size()), static_cast<slong>(columns.size()));
  for (std::size_t c = 0; c < columns.size(); ++c) {
    for (const Entry& entry : columns[c])
      fmpz_set_si(fmpz_mat_entry(matrix, rows.at(entry.face), static_cast<slong>(c)), entry.coefficient);
  }
  fmpz_mat_snf(diagonal, matrix);
  for (slong d = 0; d < std::min(fmpz_mat_nrows(diagonal), fmpz_mat_ncols(diagonal)); ++d) {
    const fmpz* entry = fmpz_mat_entry(diagonal, d, d);
    if (fmpz_is_zero(entry)) break;
    ++form.rank;
    if (fmpz_is_one(entry)) continue;
    char* text = fmpz_get_str(nullptr, 10, entry);
    form.torsion.emplace_back(text);
    flint_free(text);
  }
  for (fmpz_mat_struct* m : {matrix, diagonal}) fmpz_mat_clear(m);
  return form;
}

}  // namespace

// Column operations: a column whose first entry is 1 or -1 in a row that no other column owns comes to own it. The
// remaining columns are rid of the owned rows, so that the form is that of them in the other rows, and a 1 for each
// owner.
SmithForm reduce(std::vector<Column> columns, std::size_t rows, std::vector<bool>& used_rows,
                 std::vector<bool>& used_columns) {
  std::vector<Column> owner(rows), rest;
  Column memory;
  SmithForm form;
  const auto eliminate = [&](Column& column, bool whole) {
    for (std::size_t at = 0; at < column.size();) {
      Column& by = owner[column[at].face];
      if (!by.empty()) {
        // Columns of two entries lead to each other in long chains: this halves them.
        if (by.size() == 2 && owner[by[1].face].size() == 2) subtract(by, 1, owner[by[1].face], memory);
        subtract(column, at, by, memory);
      } else if (whole) {
        ++at;
      } else {
        return;
      }
    }
  };
  for (std::size_t c = 0; c < columns.size(); ++c) {
    Column& column = columns[c];
    eliminate(column, false);
    if (column.empty()) continue;
    const auto [face, coefficient] = column[0];
    if (coefficient == 1 || coefficient == -1) {
      used_rows[face] = used_columns[c] = true;
      owner[face] = std::move(column);
      ++form.rank;
    } else {
      rest.push_back(std::move(column));
    }
  }
  for (Column& column : rest) eliminate(column, true);
  SmithForm of_rest = smith_form(rest);
  return {form.rank + of_rest.rank, of_rest.torsion};
}

// The links that join two trees make larger trees, whose rows but one, the root, they own. Modulo them every row is its
// root times 1 or -1, so that another link is 0 or twice its root.
SmithForm reduce_links(const std::vector<Link>& links, bool last_first, std::size_t rows, std::vector<bool>& used_rows,
                       std::vector<bool>& used_columns) {
  struct Node {
    std::uint32_t parent;
    std::int64_t sign;  // the row is this times that of its parent
  };
  std::vector<Node> nodes(rows);
  for (std::size_t row = 0; row < rows; ++row) nodes[row] = {static_cast<std::uint32_t>(row), 1};
  const auto root_of = [&](std::uint32_t row) {
    Node way{row, 1};
    while (nodes[way.parent].parent != way.parent) {
      Node& node = nodes[way.parent];
      const Node& above = nodes[node.parent];
      node = {above.parent, node.sign * above.sign};  // half as long a way for the next one
      way = {node.parent, way.sign * node.sign};
    }
    return way;
  };
  SmithForm form;
  std::vector<std::uint32_t> doubled;
  for (std::size_t number = 0; number < links.size(); ++number) {
    const std::size_t c = last_first ? links.size() - 1 - number : number;
    const Node first = root_of(links[c].row[0]), second = root_of(links[c].row[1]);
    const std::int64_t sign = links[c].sign * first.sign * second.sign;
    if (first.parent != second.parent) {
      nodes[first.parent] = {second.parent, -sign};
      used_rows[first.parent] = used_columns[c] = true;
      ++form.rank;
    } else if (sign == 1) {
      doubled.push_back(first.parent);
    }
  }
  // Of each root one column is enough.
  for (std::uint32_t& row : doubled) row = root_of(row).parent;
  std::sort(doubled.begin(), doubled.end());
  doubled.erase(std::unique(doubled.begin(), doubled.end()), doubled.end());
  std::vector<Column> rest;
  for (const std::uint32_t row : doubled) rest.push_back({{row, 2}});
  SmithForm of_rest = smith_form(rest);
  return {form.rank + of_rest.rank, of_rest.torsion};
}

}  // namespace delcert::checker
