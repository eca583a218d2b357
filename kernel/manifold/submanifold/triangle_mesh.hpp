#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "kernel/number/rational.hpp"

namespace delcert {

/// Triangles in space, as a file has them.
struct TriangleMesh {
  std::vector<std::vector<Rational>> points;            ///< three coordinates each
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< numbers of points, from 0 on, in the order of the file
};

}  // namespace delcert
