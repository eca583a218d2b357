#include "kernel/manifold/quotient/tile_walk.hpp"

#include <set>
#include <string>

#include "support/error.hpp"

namespace delcert {

namespace {

/// A radius about o, in the terms of `displacement_of_origin`, so that no distance is computed for a tile.
class Reach {
 public:
  Reach(const InvariantForm& form, const BigInterval& radius) : form_(form), bound_(displacement(radius)) {}

  /// Whether d(o, γo) is certainly more than the radius.
  [[nodiscard]] bool is_beyond(const FieldVector& first_column) const {
    const BigInterval moved = form_.displacement_of_origin(first_column).enclosure();
    return is_proved(form_.curvature() == Curvature::positive ? less(moved, bound_) : less(bound_, moved));
  }

 private:
  [[nodiscard]] BigInterval displacement(const BigInterval& radius) const {
    switch (form_.curvature()) {
      case Curvature::negative:
        return hyperbolic_cosine(radius);
      case Curvature::zero:
        return square(radius);
      default:
        return cosine(minimum(radius, half_turn()));
    }
  }

  const InvariantForm& form_;
  BigInterval bound_;
};

/// The connected component of the identity among the tiles with d(o, γo) ≤ radius.
std::vector<FieldMatrix> component(const InvariantForm& form, const DirichletPolyhedron& polyhedron,
                                   const BigInterval& radius, std::size_t most_tiles) {
  const Reach reach(form, radius);
  std::vector<FieldMatrix> tiles{FieldMatrix::identity(form.matrix().order())};
  // The group acts freely, so a tile is known by its centre.
  std::set<FieldVector, Precedes> centres{tiles.front().column(0)};
  std::vector<FieldVector> steps;
  for (const auto& side : polyhedron.sides) steps.push_back(side.element.column(0));
  for (std::size_t at = 0; at < tiles.size(); ++at) {
    for (std::size_t side = 0; side < steps.size(); ++side) {
      FieldVector centre = tiles[at] * steps[side];
      if (centres.contains(centre) || reach.is_beyond(centre)) continue;
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
  const Reach reach(form, radius);
  std::vector<FieldMatrix> result;
  for (FieldMatrix& tile : component(form, polyhedron, radius + circumradius(form, polyhedron), most_tiles)) {
    if (!reach.is_beyond(tile.column(0))) result.push_back(std::move(tile));
  }
  return result;
}

std::vector<FieldMatrix> tiles_near_polyhedron(const InvariantForm& form, const DirichletPolyhedron& polyhedron,
                                               const BigInterval& radius, std::size_t most_tiles) {
  const BigInterval reach = circumradius(form, polyhedron);
  return component(form, polyhedron, radius + reach + reach, most_tiles);
}

}  // namespace delcert
