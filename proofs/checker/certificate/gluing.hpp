#pragma once

#include <array>
#include <vector>

#include "proofs/checker/arithmetic/formula_map.hpp"
#include "proofs/checker/certificate/cursor.hpp"

namespace delcert::checker {

/// From, to, for each axis.
using Sides = std::vector<std::array<Quantity, 2>>;

/// Boxes U_a of R^m and the transitions between them by rational functions, as a certificate states them.
struct Gluing {
  /// The part of the manifold block from the key "charts" on. Throws Malformed.
  Gluing(int dimension, Cursor& cursor);

  struct Chart {
    std::vector<std::string_view> variables;
    Sides domain, core;  // the open box U_a, the closed box K_a inside
  };
  struct Transition {
    std::size_t from, to;
    FormulaMap map, inverse, where;  // `where`: above 0
  };
  std::size_t m;
  std::vector<Chart> charts;
  std::vector<Transition> transitions;
  Quantity patch_radius;
};

}  // namespace delcert::checker
