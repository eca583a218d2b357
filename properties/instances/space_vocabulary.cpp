#include "properties/instances/space_vocabulary.hpp"

#include "kernel/chart/model_space.hpp"
#include "proofs/formula/evaluation.hpp"
#include "properties/instances/net_object.hpp"
#include "support/error.hpp"

namespace delcert {

namespace {

template <class S>
concept Enclosing = std::same_as<S, Interval> || std::same_as<S, BigInterval>;

template <class S, int m>
Vector<S, m> conformal_on(const ExactPoint& point) {
  Vector<S, m> result;
  for (std::size_t axis = 0; axis < m; ++axis) result[axis] = scalar_from<S>(point[axis]);
  return result;
}

/// In units.
template <class S, int m>
Vector<S, m> logarithm_of(const SpaceObject& space, const ExactPoint& seen) {
  return logarithm_of_conformal<S, m>(space.curvature(), conformal_on<S, m>(seen));
}

std::size_t number_of_point(long number) {
  if (number < 0) throw InputError("points of a space have no number " + std::to_string(number));
  return static_cast<std::size_t>(number);
}

}  // namespace

template <class S>
Partial<S> distance_in_space(const SpaceObject& space, std::size_t a, std::size_t b) {
  if constexpr (!Enclosing<S>) {
    return Partial<S>::absent(Verdict::undecided);
  } else {
    const auto seen = space.seen_from(a, b);
    const S unit = scalar_from<S>(space.unit());
    if (!seen) return S(unit * straight_angle<S>());
    // As far as from the origin, where the chart is isometric along rays.
    return with_net_dimension(space.dimension(), [&]<int m>() -> Partial<S> {
      return S(unit * square_root(detail::sum_of_squares(logarithm_of<S, m>(space, *seen))));
    });
  }
}

template <class S>
Partial<S> distance_in_chart(const SpaceObject& space, std::size_t centre, std::size_t a, std::size_t b) {
  const auto first = space.seen_from(centre, a);
  const auto second = space.seen_from(centre, b);
  if (!first || !second) return Partial<S>::absent(Verdict::refuted);
  if constexpr (!Enclosing<S>) {
    return Partial<S>::absent(Verdict::undecided);
  } else {
    return with_net_dimension(space.dimension(), [&]<int m>() -> Partial<S> {
      const auto edge = difference(logarithm_of<S, m>(space, *first), logarithm_of<S, m>(space, *second));
      return S(scalar_from<S>(space.unit()) * square_root(detail::sum_of_squares(edge)));
    });
  }
}

template Partial<Interval> distance_in_space<Interval>(const SpaceObject&, std::size_t, std::size_t);
template Partial<BigInterval> distance_in_space<BigInterval>(const SpaceObject&, std::size_t, std::size_t);
template Partial<Surd> distance_in_space<Surd>(const SpaceObject&, std::size_t, std::size_t);
template Partial<Algebraic> distance_in_space<Algebraic>(const SpaceObject&, std::size_t, std::size_t);
template Partial<Interval> distance_in_chart<Interval>(const SpaceObject&, std::size_t, std::size_t, std::size_t);
template Partial<BigInterval> distance_in_chart<BigInterval>(const SpaceObject&, std::size_t, std::size_t, std::size_t);
template Partial<Surd> distance_in_chart<Surd>(const SpaceObject&, std::size_t, std::size_t, std::size_t);
template Partial<Algebraic> distance_in_chart<Algebraic>(const SpaceObject&, std::size_t, std::size_t, std::size_t);

void add_space_quantities(Vocabulary& vocabulary) {
  vocabulary.add_kind("space-points", SpaceObject::read);
  vocabulary.add(
      number_function("space_distance", {types::space_points, types::integer, types::integer},
                      "The distance in the space of the points with these numbers, a length; enclosed, never exact.",
                      "d_{#1}({#1}_{#2}, {#1}_{#3})", []<class S>(Evaluation<S>&, Arguments<S> a) -> Partial<S> {
                        return distance_in_space<S>(object_of<SpaceObject>(a[0]), number_of_point(integer_of(a[1])),
                                                    number_of_point(integer_of(a[2])));
                      }));
  vocabulary.add(number_function(
      "chart_distance", {types::space_points, types::integer, types::integer, types::integer},
      "The Euclidean distance, a length, in the exponential chart at the first of these points, of the other two; "
      "enclosed, never exact; undefined if one of them is the antipode of the first.",
      "d_{#2}({#1}_{#3}, {#1}_{#4})", []<class S>(Evaluation<S>&, Arguments<S> a) -> Partial<S> {
        return distance_in_chart<S>(object_of<SpaceObject>(a[0]), number_of_point(integer_of(a[1])),
                                    number_of_point(integer_of(a[2])), number_of_point(integer_of(a[3])));
      }));
}

}  // namespace delcert
