#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "kernel/manifold/flat_atlas.hpp"

namespace delcert {

/// A lattice as a net, degenerate on purpose: all of its Delaunay cells are cospherical point sets.
struct LatticeNet {
  std::uint32_t divisions = 1;  ///< the points are the multiples of 1/divisions in every frame coordinate
  bool centred = false;         ///< and the centres of their cells: body-centred cubic in a cubic frame
  /// Every coordinate is moved by ±2^−this, the sign drawn from the seed. At most 1024.
  std::optional<unsigned> displacement_exponent;
  std::uint64_t seed = 0;
};

/// The points of the lattice in the unit cell of a torus, or those in the cube about a ball that is wide enough for a
/// net of the ball: side 2(r + 4/divisions). Ordered along a space-filling curve.
/// Throws InputError when that is more than 4 000 000 points, or none, and for a displacement finer than that.
template <int m>
[[nodiscard]] std::vector<Vector<Rational, m>> lattice_net(const FlatSpace<m>& space, const LatticeNet& lattice);

}  // namespace delcert
