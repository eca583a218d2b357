#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "kernel/chart/atlas.hpp"
#include "kernel/simplex/forbidden_configuration.hpp"
#include "support/progress.hpp"

namespace delcert {

/// What a search for forbidden configurations looked at and found.
struct ForbiddenSearch {
  std::uint64_t simplices = 0;        ///< simplices of dimension 1 … m entered
  std::uint64_t configurations = 0;   ///< sets of 3 … m+2 points looked at
  std::uint64_t decided_exactly = 0;  ///< of these, by all of P1 … P4 in rationals
  /// Labels of a set that has the properties, or for which that could not be refuted.
  std::optional<std::vector<Label>> found;
};

/// Looks at all sets of k + 2 points, 1 ≤ k ≤ m, with pairwise distances below the edge bound, each once mod the
/// transitions, for one with all of P1 … P4 of lem:prop.forbid.cfg. Nothing found means that there is none in any
/// Q′_i (docs/levels/3-forbidden-configurations.md). Stops at the first one found.
///
/// Where radii vary, the lengths of P2 and P3 are multiples of the greatest radius, and count for a set as many times
/// as the least radius of its labels is of that (`LengthUnits`). `perturbation`: every point is at most this length
/// from its original position.
template <int m>
[[nodiscard]] ForbiddenSearch search_forbidden(const Atlas<m>& atlas, const PointSet<m>& points,
                                               const ForbiddenPropertiesParameters<Rational>& parameters,
                                               const Rational& perturbation, const Progress& progress);

}  // namespace delcert
