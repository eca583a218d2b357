#include "proofs/formula/measure_vocabulary.hpp"

#include <algorithm>

#include "kernel/simplex/altitude.hpp"
#include "kernel/simplex/gram_elimination.hpp"
#include "proofs/formula/hull_angle.hpp"
#include "proofs/formula/simplex_object.hpp"
#include "support/error.hpp"

namespace delcert {

namespace {

using ExactVector = std::vector<Rational>;

template <class S>
const SimplexObject& simplex_at(Arguments<S> a, std::size_t at) {
  return object_of<SimplexObject>(a[at]);
}

std::size_t vertex_index(const SimplexObject& simplex, long index) {
  if (index < 0 || static_cast<std::size_t>(index) >= simplex.vertex_count()) {
    throw InputError("a simplex of " + std::to_string(simplex.vertex_count()) + " vertices has no vertex " +
                     std::to_string(index));
  }
  return static_cast<std::size_t>(index);
}

/// A quantity that has a sign and a rational square.
struct SignedRoot {
  int sign = 1;
  Rational square;

  template <class S>
  [[nodiscard]] S on() const {
    const S root = square_root(scalar_from<S>(square));
    return sign < 0 ? S(S(0) - root) : root;
  }
};

int sign_of_number(const Rational& x) { return x < Rational(0) ? -1 : 1; }

template <class S>
Partial<S> on_rung(const Partial<SignedRoot>& value) {
  return value ? Partial<S>(value->template on<S>()) : Partial<S>::absent(value.exists());
}

/// x − p, and where points have to have coordinates.
ExactVector exact_difference(const ExactVector& x, const ExactVector& p) {
  ExactVector result;
  for (std::size_t axis = 0; axis < x.size(); ++axis) result.push_back(x[axis] - p[axis]);
  return result;
}

Rational scalar_product(const ExactVector& x, const ExactVector& y) {
  Rational result(0);
  for (std::size_t axis = 0; axis < x.size(); ++axis) result += x[axis] * y[axis];
  return result;
}

const SimplexObject::Points& placed_points(const SimplexObject& simplex, std::size_t dimension) {
  if (!simplex.has_coordinates()) throw InputError("a simplex that is known by its edges only has no place in a space");
  if (simplex.points().front().size() != dimension) {
    throw InputError("a point of " + std::to_string(dimension) + " coordinates and a simplex in " +
                     std::to_string(simplex.points().front().size()) + " dimensions");
  }
  return simplex.points();
}

/// ⟨p_i − p_0, x − p_0⟩ for i = 1 … k.
ExactVector shadow_of(const SimplexObject& simplex, const ExactVector& x) {
  const auto& points = placed_points(simplex, x.size());
  const ExactVector to_x = exact_difference(x, points[0]);
  ExactVector result;
  for (std::size_t i = 1; i < points.size(); ++i)
    result.push_back(scalar_product(exact_difference(points[i], points[0]), to_x));
  return result;
}

Rational squared_volume(const SimplexObject& simplex) {
  const GramElimination<Rational> elimination(simplex.exact_gram().gram());
  if (simplex.dimension() == 0) return Rational(1);
  if (!is_proved(elimination.definite())) return Rational(0);
  Rational factorial(1);
  for (std::size_t i = 2; i <= simplex.dimension(); ++i) factorial *= Rational(static_cast<long>(i));
  return elimination.determinant() / square(factorial);
}

/// 1/r is the sum of the inverse altitudes.
template <class S>
Partial<S> inradius_of(const SimplexObject& simplex) {
  if (simplex.dimension() == 0) return Partial<S>::absent(Verdict::refuted);
  const auto squares = squared_dual_lengths(simplex.exact_gram());
  if (!squares) return Partial<S>::absent(squares.exists());
  S sum(0);
  for (const Rational& one : *squares) sum = S(sum + square_root(scalar_from<S>(one)));
  return S(S(1) / sum);
}

/// ⟨w_i, w_j⟩ of the dual basis, w_0 minus the sum of the others; nothing for a degenerate simplex.
std::optional<std::vector<ExactVector>> dual_gram(const SimplexObject& simplex) {
  const std::size_t k = simplex.dimension();
  const GramElimination<Rational> elimination(simplex.exact_gram().gram());
  if (!is_proved(elimination.definite())) return std::nullopt;
  std::vector<ExactVector> result(k + 1, ExactVector(k + 1, Rational(0)));
  for (std::size_t i = 1; i <= k; ++i) {
    ExactVector unit(k, Rational(0));
    unit[i - 1] = Rational(1);
    const ExactVector column = elimination.solve(unit)->x;
    for (std::size_t j = 1; j <= k; ++j) {
      result[j][i] = column[j - 1];
      result[0][i] -= column[j - 1];
    }
  }
  for (std::size_t i = 1; i <= k; ++i) {
    result[i][0] = result[0][i];
    result[0][0] -= result[0][i];
  }
  return result;
}

/// The outer normals of the facets opposite i and j are −w_i and −w_j; the angle inside is π minus theirs.
Partial<SignedRoot> dihedral_cosine(const SimplexObject& simplex, std::size_t i, std::size_t j) {
  if (i == j) throw InputError("a dihedral angle is between two facets, not one with itself");
  if (simplex.dimension() < 2) return Partial<SignedRoot>::absent(Verdict::refuted);
  const auto gram = dual_gram(simplex);
  if (!gram) return Partial<SignedRoot>::absent(Verdict::refuted);
  const Rational& both = (*gram)[i][j];
  return SignedRoot{-sign_of_number(both), square(both) / ((*gram)[i][i] * (*gram)[j][j])};
}

Partial<Rational> barycentric_coordinate(const SimplexObject& simplex, const ExactVector& x, std::size_t i) {
  const ExactVector shadow = shadow_of(simplex, x);
  const GramElimination<Rational> elimination(simplex.exact_gram().gram());
  if (!is_proved(elimination.definite())) return Partial<Rational>::absent(Verdict::refuted);
  const ExactVector coordinates = elimination.solve(shadow)->x;
  if (i > 0) return coordinates[i - 1];
  Rational first(1);
  for (const Rational& other : coordinates) first -= other;
  return first;
}

/// |x − p_0|² less the square of its projection, which exists for degenerate simplices, too.
Rational squared_distance_to_hull(const SimplexObject& simplex, const ExactVector& x) {
  const ExactVector to_x = exact_difference(x, placed_points(simplex, x.size())[0]);
  return scalar_product(to_x, to_x) -
         *GramElimination<Rational>(simplex.exact_gram().gram()).energy(shadow_of(simplex, x));
}

Rational exact_determinant(std::vector<ExactVector> rows) {
  Rational result(1);
  for (std::size_t column = 0; column < rows.size(); ++column) {
    const auto pivot = std::find_if(rows.begin() + static_cast<std::ptrdiff_t>(column), rows.end(),
                                    [&](const ExactVector& row) { return row[column] != Rational(0); });
    if (pivot == rows.end()) return Rational(0);
    if (pivot != rows.begin() + static_cast<std::ptrdiff_t>(column)) {
      std::swap(*pivot, rows[column]);
      result = -result;
    }
    result *= rows[column][column];
    for (std::size_t row = column + 1; row < rows.size(); ++row) {
      const Rational multiplier = rows[row][column] / rows[column][column];
      for (std::size_t at = column; at < rows.size(); ++at) rows[row][at] -= multiplier * rows[column][at];
    }
  }
  return result;
}

Partial<SignedRoot> hyperplane_distance(const SimplexObject& simplex, const ExactVector& x) {
  const auto& points = placed_points(simplex, x.size());
  if (points.size() != x.size()) {
    throw InputError("a hyperplane of R^" + std::to_string(x.size()) + " is spanned by " + std::to_string(x.size()) +
                     " points, not " + std::to_string(points.size()));
  }
  if (!is_proved(GramElimination<Rational>(simplex.exact_gram().gram()).definite()) && points.size() > 1) {
    return Partial<SignedRoot>::absent(Verdict::refuted);
  }
  std::vector<ExactVector> rows;
  for (std::size_t i = 1; i < points.size(); ++i) rows.push_back(exact_difference(points[i], points[0]));
  rows.push_back(exact_difference(x, points[0]));
  return SignedRoot{sign_of_number(exact_determinant(std::move(rows))), squared_distance_to_hull(simplex, x)};
}

/// The Gram matrix of what is left of the edges of the first simplex when the second one's space is projected away.
SymmetricMatrix<Rational> gram_across(const SimplexObject& simplex, const SimplexObject& hull) {
  const auto& points = placed_points(simplex, hull.ambient_dimension());
  const auto& base = placed_points(hull, hull.ambient_dimension());
  const GramElimination<Rational> elimination(hull.exact_gram().gram());
  std::vector<ExactVector> shadows;
  for (std::size_t i = 1; i < points.size(); ++i) {
    const ExactVector edge = exact_difference(points[i], points[0]);
    shadows.emplace_back();
    for (std::size_t j = 1; j < base.size(); ++j)
      shadows.back().push_back(scalar_product(exact_difference(base[j], base[0]), edge));
  }
  SymmetricMatrix<Rational> result(shadows.size());
  for (std::size_t i = 0; i < shadows.size(); ++i) {
    const ExactVector coefficients = elimination.solve(shadows[i])->x;
    for (std::size_t j = 0; j <= i; ++j) {
      result(i, j) = simplex.exact_gram().gram()(i, j) - scalar_product(coefficients, shadows[j]);
    }
  }
  return result;
}

/// As sharp as a rung can use, but no sharper: what ties there stays undecided.
template <class S>
Partial<S> hull_angle_sine(const SimplexObject& simplex, const SimplexObject& hull) {
  constexpr unsigned most_bits = 256;
  unsigned bits = 64;
  if constexpr (std::same_as<S, BigInterval>) bits = std::min(most_bits, 2 * BigInterval::working_precision().value);
  const auto bounds = greatest_squared_sine(gram_across(simplex, hull), simplex.exact_gram().gram(), bits);
  if (!bounds) return Partial<S>::absent(bounds.exists());
  if (bounds->lower == bounds->upper) return square_root(scalar_from<S>(bounds->lower));
  if constexpr (std::same_as<S, Interval>) {
    const S lower = scalar_from<S>(bounds->lower);
    const S upper = scalar_from<S>(bounds->upper);
    return square_root(Interval::between(lower.lower(), upper.upper()));
  } else if constexpr (std::same_as<S, BigInterval>) {
    return square_root(BigInterval::between(bounds->lower, bounds->upper));
  } else {
    return Partial<S>::absent(Verdict::undecided);
  }
}

void add_measures(Vocabulary& vocabulary) {
  vocabulary.add(number_function("volume", {types::simplex},
                                 "The k-dimensional volume; 0 for a degenerate simplex, 1 for a vertex.",
                                 "\\mathrm{vol}(#1)", []<class S>(Evaluation<S>&, Arguments<S> a) -> Partial<S> {
                                   return SignedRoot{1, squared_volume(simplex_at(a, 0))}.template on<S>();
                                 }));
  vocabulary.add(number_function(
      "inradius", {types::simplex},
      "The radius of the inscribed ball, a length; undefined for a vertex and for a degenerate simplex.", "r(#1)",
      []<class S>(Evaluation<S>&, Arguments<S> a) -> Partial<S> { return inradius_of<S>(simplex_at(a, 0)); }));
  vocabulary.add(number_function(
      "dihedral_cosine", {types::simplex, types::integer, types::integer},
      "The cosine of the angle inside between the facets opposite two vertices; undefined for an edge and for a "
      "degenerate simplex.",
      "\\cos\\angle({#1}_{#2}, {#1}_{#3})", []<class S>(Evaluation<S>&, Arguments<S> a) -> Partial<S> {
        const SimplexObject& simplex = simplex_at(a, 0);
        return on_rung<S>(
            dihedral_cosine(simplex, vertex_index(simplex, integer_of(a[1])), vertex_index(simplex, integer_of(a[2]))));
      }));
}

void add_points(Vocabulary& vocabulary) {
  vocabulary.add({"vertex",
                  {types::simplex, types::integer},
                  types::point,
                  "A vertex as a point, by its number.",
                  "{#1}_{#2}",
                  false,
                  ItemFunction([](std::span<const Item> a) -> Item {
                    const auto& simplex = object_of<SimplexObject>(a[0]);
                    const std::size_t i = vertex_index(simplex, std::get<long>(a[1]));
                    return std::make_shared<PointObject>(placed_points(simplex, simplex.ambient_dimension())[i]);
                  })});
  vocabulary.add({"centroid",
                  {types::simplex},
                  types::point,
                  "The mean of the vertices.",
                  "\\bar{#1}",
                  false,
                  ItemFunction([](std::span<const Item> a) -> Item {
                    const auto& simplex = object_of<SimplexObject>(a[0]);
                    const auto& points = placed_points(simplex, simplex.ambient_dimension());
                    ExactVector mean(points.front().size(), Rational(0));
                    for (std::size_t axis = 0; axis < mean.size(); ++axis) {
                      for (const ExactVector& point : points) mean[axis] += point[axis];
                      mean[axis] /= Rational(static_cast<long>(points.size()));
                    }
                    return std::make_shared<PointObject>(std::move(mean));
                  })});
  vocabulary.add(number_function("coordinate", {types::point, types::integer},
                                 "A coordinate of a point, 0 … m - 1; exact on every rung.", "{#1}_{#2}",
                                 []<class S>(Evaluation<S>&, Arguments<S> a) -> Partial<S> {
                                   const auto& coordinates = object_of<PointObject>(a[0]).coordinates();
                                   const long axis = integer_of(a[1]);
                                   if (axis < 0 || static_cast<std::size_t>(axis) >= coordinates.size()) {
                                     throw InputError("a point of " + std::to_string(coordinates.size()) +
                                                      " coordinates has no coordinate " + std::to_string(axis));
                                   }
                                   return scalar_from<S>(coordinates[static_cast<std::size_t>(axis)]);
                                 }));
  vocabulary.add(number_function(
      "barycentric_coordinate", {types::simplex, types::point, types::integer},
      "The barycentric coordinate for a vertex, by its number, of the point of the affine hull that is next to the "
      "point given; exact on every rung, undefined for a degenerate simplex.",
      "\\lambda_{#3}(#2, #1)", []<class S>(Evaluation<S>&, Arguments<S> a) -> Partial<S> {
        const SimplexObject& simplex = simplex_at(a, 0);
        const auto value = barycentric_coordinate(simplex, object_of<PointObject>(a[1]).coordinates(),
                                                  vertex_index(simplex, integer_of(a[2])));
        return value ? Partial<S>(scalar_from<S>(*value)) : Partial<S>::absent(value.exists());
      }));
}

void add_hulls(Vocabulary& vocabulary) {
  vocabulary.add(number_function(
      "distance_to_affine_hull", {types::simplex, types::point},
      "The distance of a point from the affine hull of the vertices, a length; degenerate simplices have one, too.",
      "d(#2, \\mathrm{aff}\\,#1)", []<class S>(Evaluation<S>&, Arguments<S> a) -> Partial<S> {
        const auto& point = object_of<PointObject>(a[1]).coordinates();
        return SignedRoot{1, squared_distance_to_hull(simplex_at(a, 0), point)}.template on<S>();
      }));
  vocabulary.add(number_function(
      "signed_distance_to_hyperplane", {types::simplex, types::point},
      "The distance of a point from the hyperplane through the m vertices, a length, with the sign of the determinant "
      "of the edges from vertex 0 and then the point; undefined for a degenerate simplex.",
      "d_{\\pm}(#2, \\mathrm{aff}\\,#1)", []<class S>(Evaluation<S>&, Arguments<S> a) -> Partial<S> {
        return on_rung<S>(hyperplane_distance(simplex_at(a, 0), object_of<PointObject>(a[1]).coordinates()));
      }));
  vocabulary.add(number_function("hull_angle_sine", {types::simplex, types::simplex},
                                 "The sine of the greatest angle between a line in the affine hull of the first "
                                 "simplex and the affine hull of the "
                                 "second one; from an edge exact, else enclosed to 256 bits, so that ties are "
                                 "undecided; undefined if the first is "
                                 "a vertex or degenerate.",
                                 "\\sin\\angle(\\mathrm{aff}\\,#1, \\mathrm{aff}\\,#2)",
                                 []<class S>(Evaluation<S>&, Arguments<S> a) -> Partial<S> {
                                   return hull_angle_sine<S>(simplex_at(a, 0), simplex_at(a, 1));
                                 }));
}

}  // namespace

void add_simplex_measures(Vocabulary& vocabulary) {
  add_measures(vocabulary);
  add_points(vocabulary);
  add_hulls(vocabulary);
}

}  // namespace delcert
