#include "kernel/manifold/quotient/lattice_points.hpp"

#include <algorithm>
#include <stdexcept>

#include "support/error.hpp"

namespace delcert {

Rational squared_norm(const RationalMatrix& gram, const RationalVector& x) {
  Rational result(0);
  for (std::size_t row = 0; row < x.size(); ++row) {
    for (std::size_t column = 0; column < x.size(); ++column) result += x[row] * gram[row][column] * x[column];
  }
  return result;
}

RationalMatrix inverse(const RationalMatrix& matrix) {
  const std::size_t n = matrix.size();
  RationalMatrix rows = matrix;
  for (std::size_t row = 0; row < n; ++row) {
    rows[row].resize(2 * n);
    rows[row][n + row] = Rational(1);
  }
  for (std::size_t k = 0; k < n; ++k) {
    std::size_t pivot = k;
    while (pivot < n && rows[pivot][k] == Rational(0)) ++pivot;
    if (pivot == n) throw std::domain_error("inverse of a singular matrix");
    std::swap(rows[pivot], rows[k]);
    const Rational scale = rows[k][k];
    for (Rational& entry : rows[k]) entry /= scale;
    for (std::size_t row = 0; row < n; ++row) {
      if (row == k) continue;
      const Rational factor = rows[row][k];
      for (std::size_t column = k; column < 2 * n; ++column) rows[row][column] -= factor * rows[k][column];
    }
  }
  for (auto& row : rows) row.erase(row.begin(), row.begin() + static_cast<std::ptrdiff_t>(n));
  return rows;
}

std::vector<RationalVector> lattice_points(const RationalMatrix& gram, const RationalVector& offset,
                                           const Rational& bound) {
  constexpr long most = 10000000;
  const std::size_t k = offset.size();
  const RationalMatrix dual = inverse(gram);
  std::vector<Integer> first(k);
  std::vector<Integer> last(k);
  Rational count(1);
  for (std::size_t axis = 0; axis < k; ++axis) {
    const Rational reach = square_root_upper(bound * dual[axis][axis], 32);
    first[axis] = ceiling_of(-reach - offset[axis]);
    last[axis] = floor_of(reach - offset[axis]);
    if (first[axis] > last[axis]) return {};
    count *= Rational(Integer(last[axis] - first[axis] + 1));
  }
  if (count > Rational(most)) throw InputError("lattice basis is too skewed: reduce it first");
  std::vector<RationalVector> result;
  std::vector<Integer> z = first;
  while (true) {
    RationalVector x(k);
    for (std::size_t axis = 0; axis < k; ++axis) x[axis] = offset[axis] + Rational(z[axis]);
    if (squared_norm(gram, x) <= bound) result.push_back(std::move(x));
    std::size_t axis = k;
    while (axis > 0 && ++z[axis - 1] > last[axis - 1]) {
      z[axis - 1] = first[axis - 1];
      --axis;
    }
    if (axis == 0) return result;
  }
}

Rational least_squared_norm(const RationalMatrix& gram, const RationalVector& offset) {
  const std::size_t k = offset.size();
  // A point near 0, moved along the shortest basis vector should it be 0.
  RationalVector near(k);
  for (std::size_t axis = 0; axis < k; ++axis) near[axis] = offset[axis] - Rational(floor_of(offset[axis]));
  Rational best = squared_norm(gram, near);
  if (best == Rational(0)) {
    best = gram[0][0];
    for (std::size_t axis = 1; axis < k; ++axis) best = minimum(best, gram[axis][axis]);
  }
  for (const RationalVector& x : lattice_points(gram, offset, best)) {
    const Rational squared = squared_norm(gram, x);
    if (squared > Rational(0)) best = minimum(best, squared);
  }
  return best;
}

}  // namespace delcert
