#pragma once

#include <cstdint>
#include <vector>

#include "proofs/drawing/facet_table.hpp"

namespace delcert {

/// Exchanges two vertices of some simplices, so that any two that share a facet induce opposite orientations on it, as
/// far as that can be: from one simplex of each component on, in its own orientation. Whether it could be done
/// everywhere. Simplices have `size` vertices each. Precondition: a facet is in at most two simplices; size ≥ 2.
[[nodiscard]] bool orient_coherently(std::vector<std::uint32_t>& simplices, std::size_t size);
/// The same, where their facets are known.
[[nodiscard]] bool orient_coherently(std::vector<std::uint32_t>& simplices, std::size_t size, const FacetTable& facets);

/// Exchanges the last two vertices of all simplices.
void reverse_orientation(std::vector<std::uint32_t>& simplices, std::size_t size);

}  // namespace delcert
