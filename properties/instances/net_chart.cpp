#include "properties/instances/net_chart.hpp"

#include <algorithm>

#include "kernel/simplex/gram_elimination.hpp"
#include "kernel/simplex/matrix_norm.hpp"
#include "kernel/simplex/thickness.hpp"
#include "proofs/formula/evaluation.hpp"
#include "proofs/formula/simplex_object.hpp"
#include "properties/instances/net_star.hpp"
#include "properties/instances/net_vocabulary.hpp"

namespace delcert {

namespace {

ChartMap identity(int dimension) {
  const auto m = static_cast<std::size_t>(dimension);
  ChartMap result(m * m);
  for (std::size_t axis = 0; axis < m; ++axis) result[axis * m + axis] = Rational(1);
  return result;
}

ChartMap product(const ChartMap& a, const ChartMap& b, std::size_t m) {
  ChartMap result(m * m);
  for (std::size_t row = 0; row < m; ++row) {
    for (std::size_t column = 0; column < m; ++column) {
      for (std::size_t k = 0; k < m; ++k) result[row * m + column] += a[row * m + k] * b[k * m + column];
    }
  }
  return result;
}

/// By a rational angle in the plane of two axes.
ChartMap rotation(int dimension, Choices& choices) {
  const auto m = static_cast<std::size_t>(dimension);
  ChartMap result = identity(dimension);
  const auto first = static_cast<std::size_t>(choices.between(0, dimension - 2));
  const auto second = static_cast<std::size_t>(choices.between(static_cast<long>(first) + 1, dimension - 1));
  const Rational t = choices.symmetric(5);
  const Rational norm = Rational(1) + square(t);
  result[first * m + first] = result[second * m + second] = (Rational(1) - square(t)) / norm;
  result[first * m + second] = -(Rational(2) * t / norm);
  result[second * m + first] = Rational(2) * t / norm;
  return result;
}

const ChartMap& map_of(const Item& item) { return object_of<PointObject>(item).coordinates(); }

/// The stars of the first points as sets of coordinates, the first one's moved by the map.
Verdict have_same_star_under(const ChartMap& map, const NetObject& a, const NetObject& b) {
  const auto first = star_coordinates(a);
  const auto second = star_coordinates(b);
  if (!first && !second) return Verdict::undecided;
  if (!first || !second) return Verdict::refuted;
  std::vector<NetObject::Points> moved;
  for (const auto& cell : *first) {
    moved.push_back(chart_image(map, cell));
    std::sort(moved.back().begin(), moved.back().end());
  }
  std::sort(moved.begin(), moved.end());
  return verdict_of(moved == *second);
}

/// Of all (m+1)-subsets with the first point.
template <class S>
Partial<S> star_thickness(const NetObject& net) {
  const auto simplices = star_simplices(net);
  std::optional<S> least;
  for (const Item& item : simplices) {
    const auto& simplex = object_of<SimplexObject>(item);
    SymmetricMatrix<S> squared(simplex.vertex_count());
    for (std::size_t i = 0; i < simplex.vertex_count(); ++i) {
      for (std::size_t j = 0; j < i; ++j) squared(i, j) = scalar_from<S>(simplex.exact_gram().squared_edge(i, j));
    }
    const Partial<S> here = thickness(edge_gram_from_squared_edges(std::move(squared)));
    if (!here) return here;
    least = least ? S(minimum(*least, *here)) : *here;
  }
  return least ? Partial<S>(*least) : Partial<S>::absent(Verdict::undecided);
}

template <class S>
Partial<S> star_protection(const NetObject& net) {
  std::optional<S> least;
  for (const Item& item : star_simplices(net)) {
    const Partial<S> here = simplex_protection<S>(net, object_of<SimplexObject>(item));
    // A degenerate simplex is one of more than m + 1 cospherical points.
    if (!here) return is_refuted(here.exists()) ? Partial<S>(S(0)) : here;
    least = least ? S(minimum(*least, *here)) : *here;
  }
  return least ? Partial<S>(*least) : Partial<S>::absent(Verdict::undecided);
}

}  // namespace

ChartMap draw_chart_map(int dimension, const Rational& distortion, Choices& choices) {
  const auto m = static_cast<std::size_t>(dimension);
  ChartMap stretch = identity(dimension);
  for (std::size_t axis = 0; axis < m; ++axis) {
    const long kind = choices.between(0, 2);
    const Rational part = kind == 0 ? Rational(1) : kind == 1 ? Rational(-1) : choices.symmetric(6);
    stretch[axis * m + axis] = Rational(1) + part * distortion;
  }
  const ChartMap first = product(stretch, rotation(dimension, choices), m);
  return choices.happens(0.5) ? first : product(rotation(dimension, choices), first, m);
}

bool has_chart_distortion(const ChartMap& map, int dimension, const Rational& distortion) {
  const auto m = static_cast<std::size_t>(dimension);
  if (map.size() != m * m) throw InputError("a linear map of R^m has m^2 entries");
  std::vector<std::vector<Rational>> columns(m, std::vector<Rational>(m));
  for (std::size_t row = 0; row < m; ++row) {
    for (std::size_t column = 0; column < m; ++column) columns[column][row] = map[row * m + column];
  }
  const auto gram = gram_of_columns(std::span<const std::vector<Rational>>(columns));
  const Verdict above =
      GramElimination<Rational>(gram.negated().shifted(square(Rational(1) + distortion))).semidefinite();
  const Verdict below = distortion >= Rational(1)
                            ? Verdict::proved
                            : GramElimination<Rational>(gram.shifted(-square(Rational(1) - distortion))).semidefinite();
  return is_proved(conjunction(above, below));
}

std::vector<Rational> chart_image(const ChartMap& map, const std::vector<Rational>& point) {
  std::vector<Rational> result(point.size());
  for (std::size_t row = 0; row < point.size(); ++row) {
    for (std::size_t column = 0; column < point.size(); ++column) {
      result[row] += map.at(row * point.size() + column) * point[column];
    }
  }
  return result;
}

NetObject::Points chart_image(const ChartMap& map, const NetObject::Points& points) {
  NetObject::Points result;
  for (const auto& point : points) result.push_back(chart_image(map, point));
  return result;
}

void add_chart_quantities(Vocabulary& vocabulary) {
  vocabulary.add({"image_net",
                  {types::point, types::net},
                  types::net,
                  "The image of a net under a linear map, given as a point of m^2 coordinates: its rows.",
                  "#1(#2)",
                  false,
                  ItemFunction([](std::span<const Item> a) -> Item {
                    const auto& net = object_of<NetObject>(a[1]);
                    return std::make_shared<NetObject>(chart_image(map_of(a[0]), net.points()), net.sampling_radius(),
                                                       Rational(0));
                  })});
  vocabulary.add(truth_function("have_same_star_under", {types::point, types::net, types::net},
                                "The linear map takes the star of the first point in the Delaunay complex of the first "
                                "net to that in the second. Exact on every rung.",
                                "#1(\\operatorname{star}(#2)) = \\operatorname{star}(#3)",
                                []<class S>(Evaluation<S>&, Arguments<S> a) {
                                  return have_same_star_under(object_of<PointObject>(a[0]).coordinates(),
                                                              object_of<NetObject>(a[1]), object_of<NetObject>(a[2]));
                                }));
  vocabulary.add(number_function(
      "star_thickness", {types::net}, "The least thickness of the m-simplices of the star of the first point of a net.",
      "\\Upsilon(\\operatorname{star}(#1))", []<class S>(Evaluation<S>&, Arguments<S> a) -> Partial<S> {
        return star_thickness<S>(object_of<NetObject>(a[0]));
      }));
  vocabulary.add(number_function("star_protection", {types::net},
                                 "The least protection, a length, of the m-simplices of the star of the first point of "
                                 "a net; 0 for cospherical points.",
                                 "\\delta(\\operatorname{star}(#1))",
                                 []<class S>(Evaluation<S>&, Arguments<S> a) -> Partial<S> {
                                   return star_protection<S>(object_of<NetObject>(a[0]));
                                 }));
}

}  // namespace delcert
