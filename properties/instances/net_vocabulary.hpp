#pragma once

#include <optional>
#include <vector>

#include "proofs/formula/simplex_object.hpp"
#include "properties/instances/net_object.hpp"

namespace delcert {

/// The cells of the star of the first point in the Delaunay complex of a net, each as the sorted list of its points;
/// sorted. Nothing where `star_cells` has nothing.
[[nodiscard]] std::optional<std::vector<NetObject::Points>> star_coordinates(const NetObject& net);

/// The m-simplices of that star: all sets of m + 1 points of a cell, the first point among them. None where there is no
/// star.
[[nodiscard]] std::vector<Item> star_simplices(const NetObject& net);

/// min |q − C| − R over the points q that are no vertices of a non-degenerate m-simplex, from exact squares; refuted
/// for a degenerate one. On the four rungs of formulas. Throws InputError for another simplex.
template <class S>
[[nodiscard]] Partial<S> simplex_protection(const NetObject& net, const SimplexObject& simplex);

/// Adds the kind net and the quantities of nets, their stars and their forbidden configurations. Those that are
/// rational inside are decided exactly on every rung alike.
void add_net_quantities(Vocabulary& vocabulary);

}  // namespace delcert
