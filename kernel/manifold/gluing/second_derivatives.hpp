#pragma once

#include <array>

#include "kernel/formula/formula_map.hpp"
#include "kernel/manifold/gluing/cell_map.hpp"

namespace delcert {

/// The second derivatives of a map ℝᵐ → ℝᵐ at all points of the box, as `FormulaEvaluation` writes them: the hull of
/// what parts of the box have, so many on each side. False where they are not certainly defined. Needs a
/// `RoundingGuard`.
template <int m>
[[nodiscard]] bool second_derivatives(FormulaEvaluation<Interval>& map, const Cell& box, std::size_t parts_of_side,
                                      std::array<Interval, static_cast<std::size_t>(m* m* m)>& out);

}  // namespace delcert
