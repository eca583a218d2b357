#pragma once

#include <string>
#include <vector>

#include "proofs/drawing/figure/figure.hpp"

namespace delcert {

/// Points that are drawn together, in doubles.
struct DrawnSet {
  std::string name;
  bool is_simplex =
      false;  ///< whether the points are the vertices of one: drawn with edges, circumball, least altitude
  std::vector<std::vector<double>> points;  ///< not empty, of one dimension
};

/// A drawing of point sets for the eye, true to scale up to a rigid motion if they are in an affine subspace of
/// dimension three (then seen from a corner) or less. Of higher dimensions the three directions in which they are
/// longest are drawn, without circumballs and altitudes. Sets of different ambient dimensions stand side by side, each
/// scaled by itself, and there is a bar with a length where there is one alone. The description says what is drawn, and
/// how. Precondition: not empty.
[[nodiscard]] Figure figure_of(const std::vector<DrawnSet>& sets);

}  // namespace delcert
