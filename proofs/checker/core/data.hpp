#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "proofs/checker/arithmetic/square_matrix.hpp"
#include "proofs/checker/geometry/curved.hpp"
#include "proofs/checker/geometry/point_set.hpp"

namespace delcert::checker::core {

/// Element number `parent` times a generator: the s-th one for letter s > 0, the inverse of the s-th one for -s.
struct Word {
  std::uint32_t parent = 0;
  std::int32_t letter = 0;
};

/// One edge of a path: from the vertex at the place `from` of a simplex to that at the place `to`.
struct Step {
  std::uint32_t simplex = 0, from = 0, to = 0;
};

/// What the core is given (docs/levels/core.md). The space of curvature K has coordinates: the linear model in the
/// standard basis for K != 0, m of a frame for K = 0.
struct Data {
  int K = 0;
  std::size_t m = 0;

  FieldMatrix form{0};                  // K != 0: of order m + 1, kept by the generators; K = 0: the Gram matrix
  std::vector<FieldMatrix> generators;  // of order m + 1; K = 0: of (1, x)
  std::vector<Word> words;              // of the elements 1, 2, ...
  std::vector<Lift> translations;       // on a flat torus instead of words
  /// For K != 0: T A T^-1, T to the standard basis.
  std::function<SquareMatrix<Ball>(const FieldMatrix&)> in_standard_basis;

  std::vector<Vector<Interval>> filter;          // the points
  std::function<Vector<Ball>(Label)> enclosed;   // with the precision of balls
  std::function<Vector<Rational>(Label)> exact;  // for K = 0 where everything is rational; else none

  std::vector<Label> labels;            // m + 1 to a simplex, increasing; no two simplices have the same
  std::vector<std::uint32_t> elements;  // m to a simplex: of all vertices but the first
  std::vector<std::vector<Step>> loops;

  std::size_t simplices() const { return labels.size() / (m + 1); }
};

}  // namespace delcert::checker::core
