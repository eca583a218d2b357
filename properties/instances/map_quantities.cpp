#include "properties/instances/map_quantities.hpp"

#include "kernel/simplex/circumsphere.hpp"
#include "properties/instances/map_object.hpp"
#include "support/error.hpp"

namespace delcert {

namespace {

template <class S>
struct Place {
  S squared_radius;                  ///< R(σ)²
  S squared_distance;                ///< of the point from N(σ)
  S squared_height;                  ///< of the point over aff σ
  std::size_t normal_dimension = 0;  ///< of N(σ)
};

template <class S>
const SimplexObject& simplex_with_point(Arguments<S> a) {
  const auto& simplex = object_of<SimplexObject>(a[0]);
  const auto& point = object_of<PointObject>(a[1]);
  if (!simplex.has_coordinates() || simplex.ambient_dimension() != point.coordinates().size()) {
    throw InputError("a simplex and a point that are not in one space");
  }
  return simplex;
}

/// |x − p_0|² and ⟨x − p_0, p_i − p_0⟩, in coordinates.
template <class S>
struct Shadow {
  S squared_length;
  std::vector<S> products;
};

template <class S>
Shadow<S> shadow(const SimplexObject& simplex, const PointObject& point) {
  const std::size_t m = simplex.ambient_dimension();
  std::vector<S> arrow;
  for (std::size_t axis = 0; axis < m; ++axis) {
    // The difference is exact: what is far from the origin loses nothing.
    arrow.push_back(scalar_from<S>(point.coordinates()[axis] - simplex.points()[0][axis]));
  }
  Shadow<S> result{S(0), {}};
  for (const S& entry : arrow) result.squared_length = result.squared_length + square(entry);
  for (std::size_t i = 1; i < simplex.vertex_count(); ++i) {
    S product(0);
    for (std::size_t axis = 0; axis < m; ++axis) {
      product = product + arrow[axis] * scalar_from<S>(simplex.points()[i][axis] - simplex.points()[0][axis]);
    }
    result.products.push_back(product);
  }
  return result;
}

/// Where a point is relative to a simplex; absent where the simplex is, or may be, degenerate.
template <class S>
Partial<Place<S>> place(Evaluation<S>& evaluation, Arguments<S> a) {
  const SimplexObject& simplex = simplex_with_point(a);
  const auto& gram = simplex.gram(evaluation);
  const GramElimination<S> elimination(gram.gram());
  if (!is_proved(elimination.definite())) return Partial<Place<S>>::absent(elimination.definite());
  const Shadow<S> from = shadow<S>(simplex, object_of<PointObject>(a[1]));
  std::vector<S> halves;
  std::vector<S> relative;  // ⟨x − C(σ), p_i − p_0⟩
  for (std::size_t i = 1; i < simplex.vertex_count(); ++i) {
    halves.push_back(gram.squared_edge(i, 0) / S(2));
    relative.push_back(from.products[i - 1] - halves.back());
  }
  const std::size_t normal_dimension = simplex.ambient_dimension() - simplex.dimension();
  const S squared_radius = *elimination.energy(std::move(halves));
  const S squared_distance = *elimination.energy(std::move(relative));
  const S squared_height = normal_dimension == 0 ? S(0) : S(from.squared_length - *elimination.energy(from.products));
  return Place<S>{squared_radius, squared_distance, squared_height, normal_dimension};
}

template <class S>
S not_negative(const S& x) {
  return maximum(S(0), x);
}

/// The least |√(R² + ν²) − r| over the centres C(σ) + n, |n| = ν, within a of the point, whose distance from N(σ) is w
/// ≤ a and whose height is h: ν runs through the numbers ≥ 0 with w² + (ν − h)² ≤ a², and the radius grows with it.
template <class S>
Partial<S> radius_misfit(const Place<S>& place, const S& most, const S& radius) {
  const S room = square(most) - place.squared_distance;
  const Verdict none = disjunction(less(most, S(0)), less(room, S(0)));
  if (!is_refuted(none)) return Partial<S>::absent(negation(none));
  if (place.normal_dimension == 0) return absolute(S(square_root(place.squared_radius) - radius));
  const S height = square_root(place.squared_height);
  const S reach = square_root(room);
  const S smallest = square_root(S(place.squared_radius + square(not_negative(S(height - reach)))));
  const S largest = square_root(S(place.squared_radius + square(S(height + reach))));
  return not_negative(maximum(S(smallest - radius), S(radius - largest)));
}

}  // namespace

void add_map_quantities(Vocabulary& vocabulary) {
  vocabulary.add_kind("map", MapObject::read);
  vocabulary.add(number_function("circumscribed_radius", {types::simplex, types::point},
                                 "The radius of a circumscribing ball by its centre: the distance of the centre from "
                                 "vertex 0, a length.",
                                 "r(#1, #2)", []<class S>(Evaluation<S>&, Arguments<S> a) -> Partial<S> {
                                   const auto& simplex = simplex_with_point(a);
                                   return square_root(scalar_from<S>(squared_distance_between(
                                       object_of<PointObject>(a[1]).coordinates(), simplex.points()[0])));
                                 }));
  vocabulary.add(number_function("distance_to_normal_space", {types::simplex, types::point},
                                 "The distance of a point from N(σ), the centres of all circumscribing balls, a "
                                 "length; undefined for a degenerate "
                                 "simplex.",
                                 "d(#2, N(#1))", []<class S>(Evaluation<S>& e, Arguments<S> a) -> Partial<S> {
                                   const auto here = place(e, a);
                                   return here ? Partial<S>(square_root(here->squared_distance))
                                               : Partial<S>::absent(here.exists());
                                 }));
  vocabulary.add(number_function("distance_to_circumcentre", {types::simplex, types::point},
                                 "The distance of a point from C(σ), a length; undefined for a degenerate simplex.",
                                 "d(#2, C(#1))", []<class S>(Evaluation<S>& e, Arguments<S> a) -> Partial<S> {
                                   const auto here = place(e, a);
                                   return here ? Partial<S>(
                                                     square_root(S(here->squared_distance + here->squared_height)))
                                               : Partial<S>::absent(here.exists());
                                 }));
  vocabulary.add(number_function(
      "radius_misfit", {types::simplex, types::point, types::number, types::number},
      "The least |r̃ − r| over all circumscribing balls of σ with a centre within a of the point x, a length: "
      "radius_misfit(s, x, a, r), found on N(σ) in closed form. Undefined if there is no such ball, or σ is "
      "degenerate.",
      "\\min\\{\\lvert\\tilde{r} - #4\\rvert : d(#2, \\tilde{c}) \\le #3\\}(#1)",
      []<class S>(Evaluation<S>& e, Arguments<S> a) -> Partial<S> {
        const auto here = place(e, a);
        if (!here) return Partial<S>::absent(here.exists());
        return radius_misfit(*here, std::get<S>(a[2]), std::get<S>(a[3]));
      }));
}

}  // namespace delcert
