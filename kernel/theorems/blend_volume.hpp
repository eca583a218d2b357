#pragma once

#include <array>

#include "kernel/formula/formula_map.hpp"
#include "kernel/simplex/vector.hpp"

namespace delcert {

/// A simplex whose vertices have one of two home charts, and a smooth transition from the first to the second one.
template <int m>
struct TwoHomes {
  std::array<Vector<Interval, m>, static_cast<std::size_t>(m + 1)> here;   ///< the vertices in the first chart
  std::array<Vector<Interval, m>, static_cast<std::size_t>(m + 1)> there;  ///< in the second one: here, carried over
  std::array<bool, static_cast<std::size_t>(m + 1)> is_first{};            ///< whether this is the home of the vertex
};

/// A lower bound of det F on the simplex, F as in docs/levels/atlases.md: of what the blend makes of volumes in the
/// second chart. It is at least `enough`, or 0 if that is not shown by the parts into which the simplex is divided.
/// `map` is regular on the least box about the vertices in the first chart. Needs a `RoundingGuard`.
template <int m>
[[nodiscard]] double blend_volume_below(const TwoHomes<m>& simplex, FormulaEvaluation<Interval>& map, double enough);

}  // namespace delcert
