#include "proofs/formula/configuration_vocabulary.hpp"

#include "kernel/simplex/forbidden_configuration.hpp"
#include "proofs/formula/simplex_object.hpp"

namespace delcert {

namespace {

template <class S>
const SimplexObject& configuration_of(const Argument<S>& argument) {
  return object_of<SimplexObject>(argument);
}

template <class S>
S number_of(const Argument<S>& argument) {
  return std::get<S>(argument);
}

/// Vertex p of a simplex against the spheres of its facet.
template <class S>
Partial<SphereOffset<S>> offset_of(Evaluation<S>& evaluation, Arguments<S> arguments) {
  const SimplexObject& simplex = configuration_of(arguments[0]);
  const long p = integer_of(arguments[1]);
  if (p < 0 || static_cast<std::size_t>(p) >= simplex.vertex_count()) {
    throw InputError("a simplex of " + std::to_string(simplex.vertex_count()) + " vertices has no vertex " +
                     std::to_string(p));
  }
  if (simplex.dimension() == 0) return Partial<SphereOffset<S>>::absent(Verdict::refuted);
  return sphere_offset(simplex.gram(evaluation), static_cast<std::size_t>(p));
}

void add_distances(Vocabulary& vocabulary) {
  vocabulary.add(number_function(
      "circumsphere_distance", {types::simplex, types::integer},
      "The distance of vertex p from the circumsphere, in the affine hull, of the opposite "
      "facet, a length; undefined if the facet has no circumcentre.",
      "d({#1}_{(#2)}, S({#1}_{#2}))", []<class S>(Evaluation<S>& e, Arguments<S> a) -> Partial<S> {
        const auto offset = offset_of(e, a);
        return offset ? Partial<S>(circumsphere_distance(*offset)) : Partial<S>::absent(offset.exists());
      }));
  vocabulary.add(number_function(
      "diametric_sphere_distance", {types::simplex, types::integer},
      "The distance of vertex p from the diametric sphere, of dimension m - 1, of the "
      "opposite facet, a length; undefined if the facet has no circumcentre.",
      "d({#1}_{(#2)}, S^{m-1}({#1}_{#2}))", []<class S>(Evaluation<S>& e, Arguments<S> a) -> Partial<S> {
        const auto offset = offset_of(e, a);
        return offset ? Partial<S>(diametric_sphere_distance(*offset)) : Partial<S>::absent(offset.exists());
      }));
}

void add_configuration_predicates(Vocabulary& vocabulary) {
  vocabulary.add(truth_function(
      "is_forbidden_configuration", {types::simplex, types::integer, types::number, types::number, types::number},
      "In R^m (second argument): a flake for the third argument, of dimension at most m + 1, with a vertex p whose "
      "facet has a circumscribing ball B(C, R) with R below the fourth and | |p - C| - R | at most the fifth.",
      "#1\\text{ is a forbidden configuration in }\\mathbb{R}^{#2}\\text{ for }#3, #4, #5",
      []<class S>(Evaluation<S>& e, Arguments<S> a) {
        const SimplexObject& s = configuration_of(a[0]);
        const long m = integer_of(a[1]);
        if (s.has_coordinates() && m != static_cast<long>(s.ambient_dimension())) {
          throw InputError("is_forbidden_configuration: the simplex does not lie in R^" + std::to_string(m));
        }
        const ForbiddenConfigurationParameters<S> parameters{S(square(number_of(a[2]))), S(square(number_of(a[3]))),
                                                             S(square(number_of(a[4])))};
        return is_forbidden_configuration(s.gram(e), static_cast<std::size_t>(m), parameters);
      }));
  vocabulary.add(truth_function(
      "has_forbidden_properties", {types::simplex, types::number, types::number, types::number, types::number},
      "The hoop property for the third argument, all facets good for the second and of circumradius below twice the "
      "fourth, the longest edge below the fifth.",
      "#1\\text{ has }\\mathcal{P}1\\text{--}\\mathcal{P}4\\text{ for }#2, #3, #4, #5",
      []<class S>(Evaluation<S>& e, Arguments<S> a) {
        const ForbiddenPropertiesParameters<S> parameters{S(square(number_of(a[1]))), S(square(number_of(a[2]))),
                                                          number_of(a[3]), number_of(a[4])};
        return has_forbidden_properties(configuration_of(a[0]).gram(e), parameters);
      }));
}

}  // namespace

void add_configuration_quantities(Vocabulary& vocabulary) {
  add_distances(vocabulary);
  add_configuration_predicates(vocabulary);
  vocabulary.add({"join",
                  {types::point, types::simplex},
                  types::simplex,
                  "The simplex with the point as vertex 0 and then the vertices of the simplex.",
                  "#1 * #2",
                  false,
                  ItemFunction([](std::span<const Item> a) -> Item {
                    const auto& point = object_of<PointObject>(a[0]);
                    const auto& simplex = object_of<SimplexObject>(a[1]);
                    if (!simplex.has_coordinates() || simplex.ambient_dimension() != point.coordinates().size()) {
                      throw InputError("join: the point and the simplex are not in the same space");
                    }
                    SimplexObject::Points points{point.coordinates()};
                    points.insert(points.end(), simplex.points().begin(), simplex.points().end());
                    return std::make_shared<SimplexObject>(std::move(points));
                  })});
}

}  // namespace delcert
