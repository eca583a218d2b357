#pragma once

#include <cmath>
#include <cstdlib>
#include <map>

#include "kernel/manifold/submanifold/polyhedral_mesh.hpp"
#include "tests/support/message_of.hpp"
#include "tests/support/ratio.hpp"

namespace delcert::test {

/// The octahedron with its faces divided k² times, its vertices moved to the unit sphere: 4k² + 2 of them, as doubles.
/// Facets show their outer sides.
inline TriangleMesh sphere_mesh(int k) {
  TriangleMesh result;
  std::map<std::array<int, 3>, std::uint32_t> numbers;
  const auto number = [&](std::array<int, 3> at) {
    const auto [found, is_new] = numbers.try_emplace(at, static_cast<std::uint32_t>(result.points.size()));
    if (is_new) {
      const double length = std::sqrt(at[0] * at[0] + at[1] * at[1] + at[2] * at[2]);
      auto& point = result.points.emplace_back();
      for (const int x : at) point.push_back(Rational::exactly(x / length));
    }
    return found->second;
  };
  for (int octant = 0; octant < 8; ++octant) {
    const std::array sign{(octant & 1) != 0 ? -1 : 1, (octant & 2) != 0 ? -1 : 1, (octant & 4) != 0 ? -1 : 1};
    const auto corner = [&](int i, int j) { return number({sign[0] * i, sign[1] * j, sign[2] * (k - i - j)}); };
    const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
      if (sign[0] * sign[1] * sign[2] < 0) std::swap(b, c);
      result.triangles.push_back({a, b, c});
    };
    for (int i = 0; i < k; ++i) {
      for (int j = 0; i + j < k; ++j) {
        add(corner(i, j), corner(i + 1, j), corner(i, j + 1));
        if (i + j + 1 < k) add(corner(i + 1, j), corner(i + 1, j + 1), corner(i, j + 1));
      }
    }
  }
  return result;
}

inline PolyhedralMesh polyhedral_sphere(int k) { return {"sphere of facets", sphere_mesh(k), {"Z", "0", "Z"}}; }

}  // namespace delcert::test
