#pragma once

#include <optional>
#include <vector>

#include "kernel/number/big_interval.hpp"

namespace delcert {

/// Roots of polynomials with integral coefficients, that of x⁰ first and the last one not 0, all of whose roots are
/// real, as those of a characteristic polynomial are. For others the results mean nothing.

/// Enclosures of all roots, with multiplicities only of 0, in any order and to about the working precision: by
/// approximations and changes of sign. As many disjoint intervals as the degree, each with a change of sign in it, hold
/// one root each. Nothing where roots are too close to each other, or the same.
[[nodiscard]] std::optional<std::vector<BigInterval>> separated_roots(std::vector<Integer> coefficients);

/// Enclosures of all roots, with their multiplicities, by integers next to each other, the lower one exclusive; by
/// halving, so that it does not matter how close to each other they are. Precondition: no root is larger than `size`.
[[nodiscard]] std::vector<BigInterval> located_roots(const std::vector<Integer>& coefficients, const Integer& size);

}  // namespace delcert
