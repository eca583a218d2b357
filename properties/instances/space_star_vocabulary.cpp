#include "properties/instances/space_star_vocabulary.hpp"

#include <algorithm>
#include <map>
#include <memory>

#include "proofs/formula/evaluation.hpp"
#include "properties/instances/space_star.hpp"
#include "support/error.hpp"

namespace delcert {

namespace {

/// The stars that have been found at the first point of some, by the centre of the chart.
struct StarsByCentre {
  std::shared_ptr<std::map<ExactPoint, std::optional<SeenStar>>> known =
      std::make_shared<std::map<ExactPoint, std::optional<SeenStar>>>();
};

struct SpaceStar {
  std::optional<StarCells> cells;
};

template <class S>
const SpaceObject& space_of(const Argument<S>& argument) {
  return object_of<SpaceObject>(argument);
}

const ExactPoint& centre_of_chart(const SpaceObject& centres, const SpaceObject& points, long number) {
  if (number < 0 || static_cast<std::size_t>(number) >= centres.size()) {
    throw InputError("points of a space have no number " + std::to_string(number));
  }
  if (centres.curvature() != points.curvature() || centres.unit() != points.unit() ||
      centres.dimension() != points.dimension()) {
    throw InputError("a chart and points of different spaces");
  }
  return centres.points()[static_cast<std::size_t>(number)];
}

/// Of the points in the third argument, in the chart at the point of the first with the number of the second.
template <class S>
const std::optional<SeenStar>& known_star(Evaluation<S>& evaluation, const SpaceObject& centres, long number,
                                          const SpaceObject& points) {
  const ExactPoint& centre = centre_of_chart(centres, points, number);
  auto& known = *evaluation.template attached<StarsByCentre>(points, [] { return StarsByCentre(); }).known;
  const auto found = known.find(centre);
  return found != known.end() ? found->second : known.emplace(centre, star_in_chart(points, centre)).first->second;
}

using StarOfCoordinates = std::vector<std::vector<ExactPoint>>;

StarOfCoordinates by_coordinates(const StarCells& cells, const SpaceObject& points) {
  StarOfCoordinates result;
  for (const auto& cell : cells) {
    result.emplace_back();
    for (const std::uint32_t at : cell) result.back().push_back(points.points()[at]);
    std::sort(result.back().begin(), result.back().end());
  }
  std::sort(result.begin(), result.end());
  return result;
}

/// An enclosure on the rung; undecided on those that are exact.
template <class S>
Partial<S> enclosure_on(const BigInterval& value) {
  if constexpr (std::same_as<S, Interval>) {
    return in_doubles(value);
  } else if constexpr (std::same_as<S, BigInterval>) {
    return value;
  } else {
    return Partial<S>::absent(Verdict::undecided);
  }
}

/// A measure of the star in a chart.
template <class Measure>
Function star_measure(const std::string& name, const std::string& meaning, const std::string& latex,
                      const Measure& measure) {
  return number_function(name, {types::space_points, types::integer, types::space_points}, meaning, latex,
                         [measure]<class S>(Evaluation<S>& e, Arguments<S> a) -> Partial<S> {
                           const auto& star = known_star(e, space_of(a[0]), integer_of(a[1]), space_of(a[2]));
                           return star ? enclosure_on<S>(measure(*star)) : Partial<S>::absent(Verdict::undecided);
                         });
}

}  // namespace

void add_space_stars(Vocabulary& vocabulary) {
  vocabulary.add(star_measure(
      "chart_star_thickness",
      "The least thickness of the m-simplices of the star of the first point of the last in the "
      "exponential chart at a point of the first with this number; enclosed, never exact.",
      "\\Upsilon(\\operatorname{star}_{{#1}_{#2}}(#3))", [](const SeenStar& star) { return star.thickness; }));
  vocabulary.add(star_measure(
      "chart_star_protection",
      "The least protection, a length, of the simplices of chart_star_thickness; enclosed, never exact, and "
      "undecided if it may be 0.",
      "\\delta(\\operatorname{star}_{{#1}_{#2}}(#3))", [](const SeenStar& star) { return star.protection; }));
  vocabulary.add(truth_function(
      "have_same_star_in_charts", {types::space_points, types::integer, types::integer, types::space_points},
      "The stars of the first point of the last in the exponential charts at two points of the first are the same; "
      "undecided where enclosures cannot certify one of them.",
      "\\operatorname{star}_{{#1}_{#2}}(#4) = \\operatorname{star}_{{#1}_{#3}}(#4)",
      []<class S>(Evaluation<S>& e, Arguments<S> a) {
        const auto& first = known_star(e, space_of(a[0]), integer_of(a[1]), space_of(a[3]));
        const auto& second = known_star(e, space_of(a[0]), integer_of(a[2]), space_of(a[3]));
        return first && second ? delcert::verdict_of(first->cells == second->cells) : Verdict::undecided;
      }));
  vocabulary.add(truth_function(
      "have_same_star_in_chart", {types::space_points, types::integer, types::space_points, types::space_points},
      "The stars of the first points of the last two in the exponential chart at a point of the first are the same, "
      "vertices being compared by coordinates; undecided where enclosures cannot certify one of them.",
      "\\operatorname{star}_{{#1}_{#2}}(#3) = \\operatorname{star}_{{#1}_{#2}}(#4)",
      []<class S>(Evaluation<S>& e, Arguments<S> a) {
        const auto& first = known_star(e, space_of(a[0]), integer_of(a[1]), space_of(a[2]));
        const auto& second = known_star(e, space_of(a[0]), integer_of(a[1]), space_of(a[3]));
        if (!first || !second) return Verdict::undecided;
        return delcert::verdict_of(by_coordinates(first->cells, space_of(a[2])) ==
                                   by_coordinates(second->cells, space_of(a[3])));
      }));
  vocabulary.add(truth_function(
      "have_same_star_in_space", {types::space_points, types::integer, types::space_points},
      "The star of the first point of the last in the exponential chart at a point of the "
      "first is that in the Delaunay "
      "complex of the space, which is exact; undecided where enclosures cannot certify the former.",
      "\\operatorname{star}_{{#1}_{#2}}(#3) = \\operatorname{star}_{\\mathcal{M}}(#3)",
      []<class S>(Evaluation<S>& e, Arguments<S> a) {
        const auto& first = known_star(e, space_of(a[0]), integer_of(a[1]), space_of(a[2]));
        const auto& second =
            e.template attached<SpaceStar>(space_of(a[2]), [&] { return SpaceStar{star_in_space(space_of(a[2]))}; });
        return first && second.cells ? delcert::verdict_of(first->cells == *second.cells) : Verdict::undecided;
      }));
}

}  // namespace delcert
