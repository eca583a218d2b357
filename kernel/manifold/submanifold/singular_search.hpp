#pragma once

#include <cstdint>
#include <optional>

#include "kernel/manifold/submanifold/cover_check.hpp"

namespace delcert {

/// A small part of the box that may have a point at which all equations hold and their derivatives are linearly
/// dependent; there the zero set need not be a manifold. The box is divided, the largest parts first for half of the
/// time, until in each part some equation certainly does not hold or the derivatives are certainly independent; a part
/// that is 2⁻¹⁶ times as wide as the box, and not so, is returned. None if there is none, or after `most_parts`: it
/// proves nothing, and says why a zero set is refused. Precondition: rounding to nearest.
[[nodiscard]] std::optional<BoxPart> find_singular_part(const ZeroSet& zero_set, std::uint64_t most_parts = 1000000);

}  // namespace delcert
