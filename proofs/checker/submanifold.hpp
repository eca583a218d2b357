#pragma once

#include <array>
#include <vector>

#include "proofs/checker/cursor.hpp"
#include "proofs/checker/formula_map.hpp"

namespace delcert::checker {

struct Certificate;

/// The zero set of a map in a box of R^N, as a certificate states it.
struct Submanifold {
  /// The part of the manifold block from the key "variables" on. Throws Malformed.
  Submanifold(int dimension, Cursor& cursor);

  std::size_t m, q = 0, N = 0;  // N = m + q
  FormulaMap map;
  std::vector<std::array<Quantity, 2>> box;
  Quantity slope;
  bool given = false;  // the vertices are points of a complex, and perhaps not on the manifold

  /// How many numbers describe a chart.
  std::size_t chart_size() const { return N + N * (N - 1) / 2 + q * q + 2; }
};

/// The chart of a label: x -> (y, z) with x = centre + tangent y + normal z, where |y| < radius and all |z_k| < height.
/// [tangent normal] is orthogonal. W = normal Y, Y about the inverse of Df(centre) normal.
template <class N>
struct TangentChart {
  Matrix<N> centre, tangent, normal, Y, W, home;  // the last: of its own point
};
struct TangentPatch {
  Quantity radius, height;
};

TangentChart<Rational> tangent_chart(const Certificate& c, std::uint32_t label);
TangentPatch tangent_patch(const Certificate& c, std::uint32_t label);

}  // namespace delcert::checker
