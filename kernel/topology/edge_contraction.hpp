#pragma once

#include <cstdint>
#include <vector>

#include "kernel/number/strong.hpp"

namespace delcert {

/// A closed complex with fewer simplices, by contractions of edges.
struct ContractedComplex {
  std::vector<std::uint32_t> simplices;  ///< m + 1 labels each, in increasing order; labels are some of those before
  std::size_t contractions = 0;
  std::size_t refused = 0;  ///< edges that did not fulfil the link condition when they were looked at
};

/// Contracts edges as long as one fulfils the link condition lk(a) ∩ lk(b) = lk(ab), which is decided for each, and as
/// long as more than the boundary of a simplex is left. Of a combinatorial manifold without boundary that leaves one
/// that is piecewise linearly homeomorphic (Nevo, "Higher minors and Van Kampen's obstruction", 2007, Theorem 1.4; in
/// dimension 3 Dey, Edelsbrunner, Guha, Nekhayev, "Topology preserving edge contraction", 1999). Vertices with few
/// simplices go first; the result depends on the complex only. `labels`: m + 1 for each simplex, in any order.
/// Precondition: the complex is a combinatorial manifold without boundary, no simplex is listed twice, 1 ≤ m ≤ 4.
[[nodiscard]] ContractedComplex contract_edges(Dimension dimension, const std::vector<std::uint32_t>& labels);

}  // namespace delcert
