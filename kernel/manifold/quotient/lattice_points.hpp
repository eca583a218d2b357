#pragma once

#include <vector>

#include "kernel/number/rational.hpp"

namespace delcert {

using RationalMatrix = std::vector<std::vector<Rational>>;
using RationalVector = std::vector<Rational>;

/// xᵀGx.
[[nodiscard]] Rational squared_norm(const RationalMatrix& gram, const RationalVector& x);

/// The inverse, by elimination. Throws std::domain_error if the matrix is singular.
[[nodiscard]] RationalMatrix inverse(const RationalMatrix& matrix);

/// All points of c + ℤᵏ with xᵀGx ≤ bound, by enumeration of a box. Precondition: G is positive definite. Throws
/// InputError if the box has more than 10⁷ points: the basis is too skewed.
[[nodiscard]] std::vector<RationalVector> lattice_points(const RationalMatrix& gram, const RationalVector& offset,
                                                         const Rational& bound);

/// The least xᵀGx > 0 over c + ℤᵏ. Same precondition and error.
[[nodiscard]] Rational least_squared_norm(const RationalMatrix& gram, const RationalVector& offset);

}  // namespace delcert
