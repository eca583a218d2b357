#pragma once

#include <cstddef>
#include <span>

#include "kernel/number/interval.hpp"

namespace delcert {

/// max |Ax|, |x| ≤ 1, from above: the upper end is a bound for all matrices A, row by row, with entries in these
/// intervals, and not above the norm of Frobenius. With G = AᵀA or AAᵀ, whichever is smaller, and its trace t, it is
/// the root of t·(tr (G/t)^64)^(1/64), k^(1/128) times too large at most if G is k×k, and for k = 2 the root of the
/// greater eigenvalue. Throws std::invalid_argument for k > 9. Precondition: a `RoundingGuard`.
[[nodiscard]] Interval spectral_norm(std::span<const Interval> entries, std::size_t columns);

}  // namespace delcert
