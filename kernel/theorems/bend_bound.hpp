#pragma once

#include <cstddef>

#include "kernel/number/interval.hpp"

namespace delcert {

/// An upper bound of |B[t, t]| for all vectors t = u + w with u in the first m axes, |u| ≤ 1, and w in the others, |w|
/// ≤ steepness·|u|. `form` has the entries of B, symmetric of order n > m, row by row. Needs a `RoundingGuard`.
template <int m>
[[nodiscard]] Interval bend_bound(const Interval* form, std::size_t n, const Interval& steepness);

}  // namespace delcert
