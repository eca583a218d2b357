#pragma once

#include <optional>

#include "proofs/formula/simplex_object.hpp"
#include "properties/instances/choices.hpp"
#include "properties/instances/instance_class.hpp"
#include "properties/instances/map_draw.hpp"
#include "properties/instances/pair_image.hpp"

namespace delcert {

/// The vertices of a simplex in two groups, each next to a regular simplex in one of two parallel flats that are
/// orthogonal to each other otherwise: for k = 3 a sliver or a cap. The centres of both groups lie on a line that is
/// parallel to an axis. All altitudes from groups of the same size are equal, and where the flats are close together,
/// so are the weights of the vector between them, up to signs: the estimates of weights by altitudes are equalities
/// there.
struct FlatGroups {
  SimplexObject::Points points;
  std::size_t axis = 0;  ///< along which the flats are apart
  Rational height;       ///< by how much, before points are moved a little
};

/// In the first k of m dimensions, moved a little or not at all. Nothing if the choices lead to a degenerate simplex.
/// Precondition: 1 ≤ k ≤ m.
[[nodiscard]] std::optional<FlatGroups> flat_groups(const Shape& shape, Choices& choices);

/// A map of a distortion near ξ: the vertices shrink towards the centre, and the centre moves from one group to the
/// other, as far as ξ lets it. Computed in doubles; the distortion has to be measured.
[[nodiscard]] FiniteMap centre_between_groups(const CentredSimplex& simplex, const FlatGroups& groups,
                                              const Rational& xi, Choices& choices);

}  // namespace delcert
