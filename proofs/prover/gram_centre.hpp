#pragma once

#include <cstddef>
#include <vector>

namespace delcert {

/// A block of symmetric matrices that depend on parameters: base + Σ yᵢ directionᵢ, each row by row.
struct GramBlock {
  std::size_t order = 0;
  std::vector<double> base;
  std::vector<std::vector<double>> directions;  ///< as many for every block of a family
};

/// What a search for positive semidefinite matrices of a family has come to.
struct ApproximateCentre {
  bool is_found = false;   ///< else no such matrices seem to exist
  bool is_inside = false;  ///< all blocks are well inside the cone at y; else `null_vectors` say in what they are not
  std::vector<double> y;
  /// For each block, a basis of what all semidefinite matrices of the family seem to send to 0.
  std::vector<std::vector<std::vector<double>>> null_vectors;
};

/// Looks for parameters with which all blocks are positive semidefinite, and as far inside the cone as possible, along
/// the central path of the greatest t with block − t·1 ≥ 0 for each block. In doubles, without error bounds: what
/// becomes of it is decided exactly elsewhere.
[[nodiscard]] ApproximateCentre approximate_centre(const std::vector<GramBlock>& blocks);

}  // namespace delcert
