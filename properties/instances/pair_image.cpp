#include "properties/instances/pair_image.hpp"

#include <cmath>
#include <limits>

#include "kernel/number/ladder.hpp"
#include "kernel/simplex/circumsphere.hpp"
#include "kernel/simplex/realisability.hpp"
#include "properties/instances/exact_point.hpp"
#include "properties/instances/pair_distortion.hpp"

namespace delcert {

namespace {

using Points = SimplexObject::Points;
using Point = std::vector<Rational>;

constexpr unsigned share_bits = 10;

Point difference(const Point& a, const Point& b) {
  Point result = a;
  for (std::size_t axis = 0; axis < a.size(); ++axis) result[axis] -= b[axis];
  return result;
}

/// The largest λ ≥ 0 with 2λa + λ²b ≤ most; all in doubles, without error bounds.
double largest_step(double a, double b, double most) {
  const double root = std::sqrt(a * a + b * most);
  if (a >= 0) return most / (a + root);
  return b > 0 ? (root - a) / b : std::numeric_limits<double>::infinity();
}

/// √(ab) rounded down by at most 2⁻⁴⁰ of it.
Rational root_of_product(const Rational& a, const Rational& b) { return square_root_lower(a * b, 50); }

}  // namespace

Point reflected(const Point& point, const Point& normal) {
  const Rational factor = Rational(2) * pairing(point, normal) / pairing(normal, normal);
  Point result = point;
  for (std::size_t axis = 0; axis < point.size(); ++axis) result[axis] -= factor * normal[axis];
  return result;
}

Point random_normal(std::size_t dimension, Choices& choices) {
  Point result;
  for (std::size_t axis = 0; axis < dimension; ++axis) result.emplace_back(choices.between(-2, 2));
  if (pairing(result, result) == Rational(0)) result[0] = Rational(1);
  return result;
}

Rational random_share(Choices& choices) {
  const double kind = choices.unit();
  if (kind < 0.35) return Rational(1);
  if (kind < 0.7) return Rational(-1);
  return choices.symmetric(share_bits);
}

SimplexPointer linear_image(const SimplexObject& simplex, const Rational& xi, Choices& choices) {
  const std::size_t m = simplex.ambient_dimension();
  std::vector<Rational> factors;
  for (std::size_t axis = 0; axis < m; ++axis) factors.push_back(Rational(1) + xi * random_share(choices));
  const bool turns = choices.happens(0.7);
  const Point before = random_normal(m, choices);
  const Point after = random_normal(m, choices);
  Points points;
  for (const Point& point : simplex.points()) {
    Point image = turns ? reflected(point, before) : point;
    for (std::size_t axis = 0; axis < m; ++axis) image[axis] *= factors[axis];
    points.push_back(turns ? reflected(image, after) : image);
  }
  return std::make_shared<SimplexObject>(std::move(points));
}

Points random_directions(const SimplexObject& simplex, Choices& choices) {
  Points result;
  for (std::size_t i = 0; i < simplex.vertex_count(); ++i) {
    Point direction;
    for (std::size_t axis = 0; axis < simplex.ambient_dimension(); ++axis) {
      direction.push_back(choices.symmetric(share_bits));
    }
    result.push_back(std::move(direction));
  }
  return result;
}

SimplexPointer displaced_image(const SimplexObject& simplex, const Points& directions, const Rational& xi) {
  const Points& points = simplex.points();
  const Rational squared_longest = squared_longest_edge_of(simplex);
  // In units of Δ, so that doubles do not overflow.
  const Rational unit = Rational::power_of_two(binary_exponent(squared_longest) / 2);
  const double allowed = approximate_double(xi) * std::sqrt(approximate_double(squared_longest / square(unit)));
  double step = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const Point edge = difference(points[i], points[j]);
      const Point motion = difference(directions[i], directions[j]);
      const double length = std::sqrt(approximate_double(simplex.exact_gram().squared_edge(i, j) / square(unit)));
      const double a = approximate_double(pairing(edge, motion) / unit);
      const double b = approximate_double(pairing(motion, motion));
      if (b == 0) continue;
      step = std::min(step, largest_step(a, b, allowed * (2 * length + allowed)));
      const double least = allowed * (2 * length - allowed);
      // Where the edge can shrink by so much at all.
      if (a < 0 && least > 0 && a * a > b * least) step = std::min(step, least / (-a + std::sqrt(a * a - b * least)));
    }
  }
  if (!(step < std::numeric_limits<double>::max())) step = 0;
  // Somewhat less, and short.
  const Rational exact = Rational::exactly(step);
  const Rational factor =
      step > 0 ? unit * rounded_down(exact * (Rational(1) - Rational::power_of_two(-30)), binary_exponent(exact) - 34)
               : Rational(0);
  Points images = points;
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::size_t axis = 0; axis < points[i].size(); ++axis) images[i][axis] += factor * directions[i][axis];
  }
  return std::make_shared<SimplexObject>(std::move(images));
}

namespace {

/// The squares of the lengths d_ij + ξΔ·share(i, j), or pulled towards σ where no simplex has these lengths.
SimplexPointer image_by_shares(const SimplexObject& simplex, const Rational& xi,
                               const SymmetricMatrix<Rational>& share) {
  const std::size_t count = simplex.vertex_count();
  const auto& gram = simplex.exact_gram();
  const Rational squared_longest = squared_longest_edge_of(simplex);
  SymmetricMatrix<Rational> root(count);
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t j = 0; j < i; ++j) root(i, j) = root_of_product(gram.squared_edge(i, j), squared_longest);
  }
  constexpr int tries = 12;
  Rational amount = xi;
  for (int attempt = 0; attempt < tries; ++attempt, amount *= Rational(attempt) / Rational(attempt + 1)) {
    SymmetricMatrix<Rational> squared_edges(count);
    bool is_positive = true;
    for (std::size_t i = 0; i < count; ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        const Rational change = amount * share(i, j);
        // (d + change·Δ)² with dΔ rounded down, which only brings it nearer to d where it is less.
        squared_edges(i, j) =
            gram.squared_edge(i, j) + Rational(2) * change * root(i, j) + square(change) * squared_longest;
        is_positive = is_positive && squared_edges(i, j) > Rational(0) &&
                      gram.squared_edge(i, j) + change * root(i, j) > Rational(0);
      }
    }
    if (!is_positive) continue;
    const auto candidate = edge_gram_from_squared_edges(squared_edges);
    if (is_proved(
            decide([&]<class S>() { return GramElimination<S>(matrix_from<S>(candidate.gram())).semidefinite(); }))) {
      return std::make_shared<SimplexObject>(squared_edges);
    }
  }
  SymmetricMatrix<Rational> same(count);
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t j = 0; j < i; ++j) same(i, j) = gram.squared_edge(i, j);
  }
  return std::make_shared<SimplexObject>(same);
}

}  // namespace

SimplexPointer relengthened_image(const SimplexObject& simplex, const Rational& xi, bool by_star, Choices& choices) {
  const Rational way(choices.happens(0.5) ? 1 : -1);
  SymmetricMatrix<Rational> share(simplex.vertex_count());
  for (std::size_t i = 0; i < share.order(); ++i) {
    for (std::size_t j = 0; j < i; ++j) share(i, j) = by_star ? (j == 0 ? way : -way) : random_share(choices);
  }
  return image_by_shares(simplex, xi, share);
}

SimplexPointer signed_image(const SimplexObject& simplex, const Rational& xi, Choices& choices) {
  const Rational way(choices.happens(0.5) ? 1 : -1);
  const auto sphere = circumsphere(simplex.exact_gram());
  SymmetricMatrix<Rational> share(simplex.vertex_count());
  for (std::size_t i = 0; i < share.order(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const Rational product = sphere->barycentric[i] * sphere->barycentric[j];
      share(i, j) = product < Rational(0) ? -way : product > Rational(0) ? way : Rational(0);
    }
  }
  return image_by_shares(simplex, xi, share);
}

SimplexPointer regular_simplex_by_edges(int k) {
  SymmetricMatrix<Rational> squared_edges(static_cast<std::size_t>(k) + 1);
  for (std::size_t i = 0; i < squared_edges.order(); ++i) {
    for (std::size_t j = 0; j < i; ++j) squared_edges(i, j) = Rational(1);
  }
  return std::make_shared<SimplexObject>(squared_edges);
}

}  // namespace delcert
