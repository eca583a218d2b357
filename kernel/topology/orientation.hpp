#pragma once

#include <cstddef>
#include <optional>

#include "kernel/topology/pure_complex.hpp"

namespace delcert {

/// How many m-simplices, m ≥ 1, there are at the faces of dimension m − 1.
struct FacetDegrees {
  std::size_t one = 0;   ///< faces in exactly one m-simplex: the boundary of a manifold
  std::size_t more = 0;  ///< faces in three or more: there are none in a manifold
};
/// Precondition: dimension ≥ 1.
[[nodiscard]] FacetDegrees facet_degrees(const PureComplex& complex);

/// Whether the m-simplices, m ≥ 1, can be oriented such that any two that share a face of dimension m − 1 induce
/// opposite orientations on it. None where such a face is in three or more m-simplices. Of manifolds, with or without
/// boundary, connected or not, the usual notion. Linear time. Precondition: dimension ≥ 1.
[[nodiscard]] std::optional<bool> is_orientable(const PureComplex& complex);

}  // namespace delcert
