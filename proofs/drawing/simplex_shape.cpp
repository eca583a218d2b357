#include "proofs/drawing/simplex_shape.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "kernel/manifold/submanifold/dense.hpp"

namespace delcert {

ApproximateShape approximate_shape(std::size_t m, const SquaredEdges& squares) {
  constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
  ApproximateShape result;
  // Edge vectors from vertex 0: their Gram matrix G. Rows of its inverse are dual to them.
  Dense<double> gram(m * m);
  double longest = 0;
  for (std::size_t j = 0; j < m; ++j) {
    longest = std::max(longest, squares[0][j + 1]);
    for (std::size_t k = 0; k < m; ++k) {
      gram[j * m + k] = (squares[0][j + 1] + squares[0][k + 1] - squares[j + 1][k + 1]) / 2;
      longest = std::max(longest, squares[j + 1][k + 1]);
    }
  }
  const auto inverse = inverse_of(gram, m);
  if (!inverse) {
    result.thickness = result.circumradius = nothing;
    result.centre.fill(nothing);
    result.altitudes.fill(nothing);
    return result;
  }
  double all = 0;
  double first = 1;
  double radius_squared = 0;
  for (std::size_t j = 0; j < m; ++j) {
    double centre = 0;
    for (std::size_t k = 0; k < m; ++k) {
      all += (*inverse)[j * m + k];
      centre += (*inverse)[j * m + k] * gram[k * m + k] / 2;
    }
    result.centre[j + 1] = centre;
    result.altitudes[j + 1] = 1 / std::sqrt((*inverse)[j * m + j]);
    first -= centre;
    // |Σ b_k e_k|² = bᵀGb = ½ Σ b_k G_kk, as G b is half of the diagonal.
    radius_squared += centre * gram[j * m + j] / 2;
  }
  result.centre[0] = first;
  result.altitudes[0] = 1 / std::sqrt(all);
  result.circumradius = std::sqrt(radius_squared);
  const double least =
      *std::min_element(result.altitudes.begin(), result.altitudes.begin() + static_cast<std::ptrdiff_t>(m + 1));
  result.thickness = least / (static_cast<double>(m) * std::sqrt(longest));
  return result;
}

}  // namespace delcert
