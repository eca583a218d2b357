#include "kernel/simplex/dual_basis.hpp"

#include <utility>

#include "kernel/simplex/fraction_free.hpp"

namespace delcert {

namespace {

using Integers = std::vector<std::vector<Integer>>;

/// Most quotients here are 0 or 1, for which no greatest common divisor has to be found.
Rational quotient_of(const Integer& numerator, const Integer& denominator) {
  if (mpz_sgn(raw(numerator)) == 0) return {0};
  if (numerator == denominator) return {1};
  return {numerator, denominator};
}

/// Row by row, the inner products of rows of a with rows of b.
Integers products_of_rows(const Integers& a, const Integers& b) {
  Integers result(a.size(), std::vector<Integer>(b.size()));
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t j = 0; j < b.size(); ++j) {
      for (std::size_t at = 0; at < a[i].size(); ++at) mpz_addmul(raw(result[i][j]), raw(a[i][at]), raw(b[j][at]));
    }
  }
  return result;
}

/// The adjugate of a positive definite matrix in its place, and the determinant; false if it is only semidefinite.
/// Edmonds' exchange of all rows for columns, in which all entries stay determinants of the matrix.
bool make_adjugate(Integers& matrix, Integer& determinant) {
  const std::size_t order = matrix.size();
  determinant = 1;
  for (std::size_t pivot = 0; pivot < order; ++pivot) {
    if (mpz_sgn(raw(matrix[pivot][pivot])) <= 0) return false;
    for (std::size_t row = 0; row < order; ++row) {
      if (row == pivot) continue;
      for (std::size_t column = 0; column < order; ++column) {
        if (column == pivot) continue;
        eliminate(matrix[row][column], matrix[pivot][pivot], matrix[row][pivot], matrix[pivot][column], determinant);
      }
    }
    for (std::size_t row = 0; row < order; ++row) {
      if (row != pivot) mpz_neg(raw(matrix[row][pivot]), raw(matrix[row][pivot]));
    }
    std::swap(matrix[pivot][pivot], determinant);
  }
  return true;
}

}  // namespace

std::optional<DualBasis> DualBasis::of(const EdgeGram<Rational>& simplex) {
  const std::size_t count = simplex.vertex_count();
  DualBasis result;
  Integer denominator = 1;
  for (std::size_t i = 1; i < count; ++i) {
    for (std::size_t j = 0; j < i; ++j) include_denominator(denominator, simplex.squared_edge(i, j));
  }
  result.squared_edges_.assign(count, std::vector<Integer>(count));
  for (std::size_t i = 1; i < count; ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      result.squared_edges_[i][j] = whole_multiple(simplex.squared_edge(i, j), denominator);
      result.squared_edges_[j][i] = result.squared_edges_[i][j];
    }
  }
  result.unit_ = denominator + denominator;
  for (std::size_t i = 1; i < count; ++i) {
    auto& row = result.adjugate_.emplace_back();
    for (std::size_t j = 1; j < count; ++j) row.push_back(result.product(0, i, j));
  }
  if (!make_adjugate(result.adjugate_, result.determinant_)) return std::nullopt;
  return result;
}

/// ⟨p_i − p_base, p_j − p_base⟩ times the unit.
Integer DualBasis::product(std::size_t base, std::size_t i, std::size_t j) const {
  Integer result = squared_edges_[base][i] + squared_edges_[base][j];
  mpz_sub(raw(result), raw(result), raw(squared_edges_[i][j]));
  return result;
}

/// Rows i = 1 … k times multiplier/divisor, and before them minus their sum.
std::vector<std::vector<Rational>> DualBasis::with_row_of_first(const Integers& products, const Integer& multiplier,
                                                                const Integer& divisor) const {
  const std::size_t k = dimension();
  std::vector<std::vector<Rational>> result(k + 1);
  std::vector<Integer> first(k);
  for (std::size_t i = 0; i < k; ++i) {
    for (std::size_t j = 0; j < k; ++j) {
      const Integer numerator = products[i][j] * multiplier;
      mpz_sub(raw(first[j]), raw(first[j]), raw(numerator));
      result[i + 1].push_back(quotient_of(numerator, divisor));
    }
  }
  for (const Integer& numerator : first) result[0].push_back(quotient_of(numerator, divisor));
  return result;
}

std::vector<std::vector<Rational>> DualBasis::products(const std::vector<std::vector<Rational>>& points) const {
  Integer denominator = 1;
  for (const auto& point : points) {
    for (const Rational& x : point) include_denominator(denominator, x);
  }
  const std::size_t axes = points.front().size();
  Integers edges(points.size(), std::vector<Integer>(axes));
  for (std::size_t i = points.size(); i-- > 0;) {
    for (std::size_t axis = 0; axis < axes; ++axis) edges[i][axis] = whole_multiple(points[i][axis], denominator);
  }
  for (std::size_t i = 1; i < edges.size(); ++i) {
    for (std::size_t axis = 0; axis < axes; ++axis) {
      mpz_sub(raw(edges[i][axis]), raw(edges[i][axis]), raw(edges[0][axis]));
    }
  }
  edges.erase(edges.begin());
  Integers duals(dimension(), std::vector<Integer>(axes));
  for (std::size_t i = 0; i < dimension(); ++i) {
    for (std::size_t j = 0; j < dimension(); ++j) {
      for (std::size_t axis = 0; axis < axes; ++axis) {
        mpz_addmul(raw(duals[i][axis]), raw(adjugate_[i][j]), raw(edges[j][axis]));
      }
    }
  }
  return with_row_of_first(products_of_rows(duals, edges), unit_, determinant_ * denominator * denominator);
}

std::vector<std::vector<Rational>> DualBasis::products() const {
  Integers gram;
  for (std::size_t i = 1; i <= dimension(); ++i) {
    auto& row = gram.emplace_back();
    for (std::size_t j = 1; j <= dimension(); ++j) row.push_back(product(0, i, j));
  }
  return with_row_of_first(products_of_rows(adjugate_, gram), 1, determinant_);
}

/// ‖w_i‖² times the determinant, over the unit.
Integer DualBasis::squared_length(std::size_t i) const {
  if (i > 0) return adjugate_[i - 1][i - 1];
  Integer result;
  for (const auto& row : adjugate_) {
    for (const Integer& entry : row) mpz_add(raw(result), raw(result), raw(entry));
  }
  return result;
}

Rational DualBasis::squared_thickness() const {
  const auto k = static_cast<unsigned long>(dimension());
  if (k == 0) return {1};
  Integer longest;
  Integer divisor;
  for (std::size_t i = 0; i <= k; ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (squared_edges_[i][j] > longest) longest = squared_edges_[i][j];
    }
    Integer length = squared_length(i);
    if (length > divisor) divisor = std::move(length);
  }
  // The units cancel, but for the 2 in that of the edges.
  divisor *= longest;
  mpz_mul_ui(raw(divisor), raw(divisor), 2 * k * k);
  return {determinant_, divisor};
}

Rational DualBasis::squared_circumradius() const {
  Integer sum;
  Integer row;
  for (std::size_t i = 0; i < dimension(); ++i) {
    row = 0;
    for (std::size_t j = 0; j < dimension(); ++j) {
      mpz_addmul(raw(row), raw(adjugate_[i][j]), raw(squared_edges_[j + 1][0]));
    }
    mpz_addmul(raw(sum), raw(row), raw(squared_edges_[i + 1][0]));
  }
  return quotient_of(sum, unit_ * determinant_);
}

Rational DualBasis::squared_altitude_times_length(std::size_t i) const {
  // The Gram matrix of the edges from a vertex of the facet, the one to p_i last: when the others are eliminated, its
  // last entry is the determinant of all, and the last pivot that of the facet.
  const std::size_t base = i == 0 ? 1 : 0;
  std::vector<std::size_t> ends;
  for (std::size_t vertex = 0; vertex <= dimension(); ++vertex) {
    if (vertex != i && vertex != base) ends.push_back(vertex);
  }
  ends.push_back(i);
  Integers rows;
  for (const std::size_t end : ends) {
    auto& row = rows.emplace_back();
    for (std::size_t at = 0; at < rows.size(); ++at) row.push_back(product(base, end, ends[at]));
  }
  Integer facet = 1;
  for (std::size_t pivot = 0; pivot + 1 < ends.size(); ++pivot) {
    for (std::size_t row = pivot + 1; row < ends.size(); ++row) {
      for (std::size_t column = pivot + 1; column <= row; ++column) {
        eliminate(rows[row][column], rows[pivot][pivot], rows[row][pivot], rows[column][pivot], facet);
      }
    }
    facet = rows[pivot][pivot];
  }
  // The units cancel.
  return quotient_of(rows.back().back() * squared_length(i), facet * determinant_);
}

}  // namespace delcert
