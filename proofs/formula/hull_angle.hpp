#pragma once

#include "kernel/number/big_interval.hpp"
#include "kernel/number/rational.hpp"
#include "kernel/simplex/partial.hpp"
#include "kernel/simplex/symmetric_matrix.hpp"

namespace delcert {

/// The square of the sine of the greatest angle between a line of one linear space and another space: the greatest λ
/// with det(A − λG) = 0, for the Gram matrix G of a basis of the first space and that of what is orthogonal to the
/// second, A. Between two rational numbers at most 2^−bits apart, equal if λ is 0 or 1, found by halving: λ ≤ t
/// means that tG − A is positive semidefinite, which is decided exactly. Refuted unless G is positive definite.
/// Precondition: A and G − A are positive semidefinite.
struct RationalBounds {
  Rational lower;
  Rational upper;
};
[[nodiscard]] Partial<RationalBounds> greatest_squared_sine(const SymmetricMatrix<Rational>& across,
                                                            const SymmetricMatrix<Rational>& gram, unsigned bits);

}  // namespace delcert
