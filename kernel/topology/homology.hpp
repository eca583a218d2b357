#pragma once

#include <vector>

#include "kernel/topology/abelian_group.hpp"
#include "kernel/topology/pure_complex.hpp"

namespace delcert {

/// The homology groups H₀ … H_m of the complex with integer coefficients: the chain complex is reduced to the critical
/// faces of an acyclic matching, then Smith's normal forms of what is left are taken. Integers only; why the groups are
/// the same is in docs/homology.md. The empty complex has trivial groups.
/// Linear time besides what it takes to follow the boundaries of critical faces down the matching, each of them at most
/// once through all faces, and the normal forms.
/// Throws Undecided if a boundary matrix of critical faces has more than 2²⁶ entries.
[[nodiscard]] std::vector<AbelianGroup> homology(const PureComplex& complex);

}  // namespace delcert
