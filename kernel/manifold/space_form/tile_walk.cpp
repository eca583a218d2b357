#include "kernel/manifold/space_form/tile_walk.hpp"

#include <set>
#include <string>

#include "kernel/error.hpp"

namespace delcert {

namespace {

/// Whether d(o, γo) is certainly more than the radius.
bool is_beyond(const InvariantForm& form, const FieldVector& first_column, const BigInterval& radius) {
  return is_proved(less(radius, form.distance_from(form.displacement_of_origin(first_column).enclosure())));
}

/// The connected component of the identity among the tiles with d(o, γo) ≤ radius.
std::vector<FieldMatrix> component(const InvariantForm& form, const DirichletPolyhedron& polyhedron,
                                   const BigInterval& radius, std::size_t most_tiles) {
  std::vector<FieldMatrix> tiles{FieldMatrix::identity(form.matrix().order())};
  // The group acts freely, so a tile is known by its centre.
  std::set<FieldVector, Precedes> centres{tiles.front().column(0)};
  std::vector<FieldVector> steps;
  for (const auto& side : polyhedron.sides) steps.push_back(side.element.column(0));
  for (std::size_t at = 0; at < tiles.size(); ++at) {
    for (std::size_t side = 0; side < steps.size(); ++side) {
      FieldVector centre = tiles[at] * steps[side];
      if (centres.contains(centre) || is_beyond(form, centre, radius)) continue;
      if (tiles.size() == most_tiles)
        throw InputError("more than " + std::to_string(most_tiles) + " copies of the polyhedron are within reach");
      centres.insert(std::move(centre));
      tiles.push_back(tiles[at] * polyhedron.sides[side].element);
    }
  }
  return tiles;
}

}  // namespace

std::vector<FieldMatrix> tiles_with_centre_within(const InvariantForm& form, const DirichletPolyhedron& polyhedron,
                                                  const BigInterval& radius, std::size_t most_tiles) {
  std::vector<FieldMatrix> result;
  for (FieldMatrix& tile : component(form, polyhedron, radius + circumradius(form, polyhedron), most_tiles)) {
    if (!is_beyond(form, tile.column(0), radius)) result.push_back(std::move(tile));
  }
  return result;
}

std::vector<FieldMatrix> tiles_near_polyhedron(const InvariantForm& form, const DirichletPolyhedron& polyhedron,
                                               const BigInterval& radius, std::size_t most_tiles) {
  const BigInterval reach = circumradius(form, polyhedron);
  return component(form, polyhedron, radius + reach + reach, most_tiles);
}

}  // namespace delcert
