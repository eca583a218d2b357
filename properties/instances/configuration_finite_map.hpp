#pragma once

#include <optional>

#include "properties/instances/choices.hpp"
#include "properties/instances/configuration_map.hpp"

namespace delcert {

/// The circumcentres of the facets of a simplex, each once. Precondition: no facet is degenerate.
[[nodiscard]] SimplexObject::Points circumcentres_of_facets(const SimplexObject::Points& points);

/// A map of the vertices and of the circumcentres of the facets, of a distortion near ξ and at most ξ: the vertices
/// move at random, or towards and away from a circumcentre, or off their hull, which a distance hardly notices, so that
/// they get as far as √ξ; the circumcentres, which may be very close together, stay, or move all alike. Computed in
/// doubles and then certified. Nothing if the choices lead to none. Preconditions: no facet is degenerate, 0 < ξ < 1.
[[nodiscard]] std::optional<ConfigurationMap::Finite> finite_configuration_map(const SimplexObject::Points& points,
                                                                               const Rational& distortion,
                                                                               Choices& choices);

/// Whether no distance of two points changes by more than the distortion times it; decided exactly.
[[nodiscard]] bool is_distorted_at_most(const ConfigurationMap::Finite& map);

}  // namespace delcert
