#pragma once

#include <cstddef>
#include <span>

#include "kernel/number/interval.hpp"

namespace delcert {

/// max |Ax|, |x| ≤ 1, from above: the upper end is a bound for all matrices A, row by row, with entries in these
/// intervals, never above the norm of Frobenius. With G = AᵀA or AAᵀ, whichever is smaller, and its trace t, it is
/// (t·(tr (G/t)^64)^(1/64))^½: at most 64th root of the order of G times too large, under the root. Precondition: a
/// `RoundingGuard`.
[[nodiscard]] Interval spectral_norm(std::span<const Interval> entries, std::size_t columns);

}  // namespace delcert
