#include "properties/instances/net_chart.hpp"

#include <algorithm>

#include "kernel/simplex/gram_elimination.hpp"
#include "kernel/simplex/matrix_norm.hpp"
#include "kernel/simplex/thickness.hpp"
#include "proofs/formula/evaluation.hpp"
#include "proofs/formula/simplex_object.hpp"
#include "properties/instances/configuration_geometry.hpp"
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

std::size_t matrix_size(std::size_t m) { return m * m; }
std::size_t fold_size(std::size_t m) { return 2 * m + 1; }

void require_size(const ChartMap& map, std::size_t m) {
  if (map.size() < matrix_size(m) || (map.size() - matrix_size(m)) % fold_size(m) != 0) {
    throw InputError("a map of R^m has m^2 entries, and 2m + 1 for each fold");
  }
}

/// A bound of the Lipschitz constants of all folds, from above.
Rational constant_of_folds(const ChartMap& map, std::size_t m) {
  constexpr unsigned bits = 40;
  Rational result(0);
  for (std::size_t at = matrix_size(m); at < map.size(); at += fold_size(m)) {
    Rational direction(0);
    Rational normal(0);
    for (std::size_t axis = 0; axis < m; ++axis) {
      direction += square(map[at + axis]);
      normal += square(map[at + m + axis]);
    }
    result += square_root_upper(direction * normal, bits);
  }
  return result;
}

std::vector<double> some_direction(std::size_t m, Choices& choices) {
  std::vector<double> result;
  for (std::size_t axis = 0; axis < m; ++axis) result.push_back(choices.unit() - 0.5);
  return result;
}

/// A fold of this Lipschitz constant within a few units of the origin.
void add_fold(ChartMap& map, std::size_t m, const Rational& constant, Choices& choices) {
  constexpr unsigned bits = 5;
  const auto direction = rational_direction(some_direction(m, choices), bits);
  const auto normal = rational_direction(some_direction(m, choices), bits);
  for (const Rational& entry : direction) map.push_back(constant * entry);
  map.insert(map.end(), normal.begin(), normal.end());
  map.push_back(Rational(2) * choices.symmetric(6));
}

ChartMap draw_linear_chart_map(int dimension, const Rational& distortion, Choices& choices) {
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

/// Of the matrix alone.
bool has_linear_distortion(const ChartMap& map, std::size_t m, const Rational& distortion) {
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

}  // namespace

ChartMap draw_chart_map(int dimension, const Rational& distortion, Choices& choices) {
  const long folds = std::max(0L, choices.between(-3, 3));
  if (folds == 0) return draw_linear_chart_map(dimension, distortion, choices);
  // Half of the distortion and more in equal parts, a little less for what roots are rounded by.
  const Rational whole = distortion * (Rational(1) + choices.fraction(5)) / Rational(2);
  const Rational each = whole * (Rational(1) - Rational::power_of_two(-38)) / Rational(folds);
  ChartMap result = draw_linear_chart_map(dimension, distortion - whole, choices);
  for (long fold = 0; fold < folds; ++fold) add_fold(result, static_cast<std::size_t>(dimension), each, choices);
  return result;
}

bool has_chart_distortion(const ChartMap& map, int dimension, const Rational& distortion) {
  const auto m = static_cast<std::size_t>(dimension);
  require_size(map, m);
  const Rational rest = distortion - constant_of_folds(map, m);
  return rest >= Rational(0) && has_linear_distortion(map, m, rest);
}

std::vector<Rational> chart_image(const ChartMap& map, const std::vector<Rational>& point) {
  const std::size_t m = point.size();
  std::vector<Rational> result(m);
  for (std::size_t row = 0; row < m; ++row) {
    for (std::size_t column = 0; column < m; ++column) result[row] += map.at(row * m + column) * point[column];
  }
  for (std::size_t at = matrix_size(m); at < map.size(); at += fold_size(m)) {
    Rational height = -map.at(at + 2 * m);
    for (std::size_t axis = 0; axis < m; ++axis) height += map[at + m + axis] * point[axis];
    for (std::size_t axis = 0; axis < m; ++axis) result[axis] += map[at + axis] * absolute(height);
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
                  "The image of a net under a map x -> Ax + sum of a*|<w, x> - b|, given as a point: the rows of A, "
                  "then a, w, b of each fold.",
                  "#1(#2)",
                  false,
                  ItemFunction([](std::span<const Item> a) -> Item {
                    const auto& net = object_of<NetObject>(a[1]);
                    return std::make_shared<NetObject>(chart_image(map_of(a[0]), net.points()), net.sampling_radius(),
                                                       Rational(0));
                  })});
  vocabulary.add(truth_function(
      "have_same_star_under", {types::point, types::net, types::net},
      "The map, given as for image_net, takes the star of the first point in the Delaunay complex of the first "
      "net to that in the second. Exact on every rung.",
      "#1(\\operatorname{star}(#2)) = \\operatorname{star}(#3)", []<class S>(Evaluation<S>&, Arguments<S> a) {
        return have_same_star_under(object_of<PointObject>(a[0]).coordinates(), object_of<NetObject>(a[1]),
                                    object_of<NetObject>(a[2]));
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
