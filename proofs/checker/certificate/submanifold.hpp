#pragma once

#include <array>
#include <vector>

#include "proofs/checker/arithmetic/formula_map.hpp"
#include "proofs/checker/certificate/cursor.hpp"

namespace delcert::checker {

struct Certificate;

/// The zero set of a map in a box of R^N, or a mesh in space, as a certificate states it.
struct Submanifold {
  /// The part of the manifold block from the key "variables" or "mesh" on. Throws Malformed.
  Submanifold(int dimension, Cursor& cursor);

  std::size_t m, q = 0, N = 0;  // N = m + q
  FormulaMap map;
  std::vector<std::array<Quantity, 2>> box;
  std::vector<Matrix<Rational>> vertices;            // of a mesh; else there are none
  std::vector<std::array<std::uint32_t, 3>> facets;  // by numbers of vertices
  Quantity slope;
  bool given = false;  // the vertices are points of a complex, and perhaps not on the manifold

  bool is_mesh() const { return !facets.empty(); }
  /// How many numbers describe a chart.
  std::size_t chart_size() const { return N + N * (N - 1) / 2 + q * q + 2; }

 private:
  void parse_mesh(Cursor& cursor);
  void parse_zero_set(Cursor& cursor);
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
