#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "kernel/manifold/flat_atlas.hpp"
#include "kernel/simplex/circumsphere.hpp"
#include "tests/kernel/simplex/instances.hpp"
#include "tests/support/message_of.hpp"

// Flat spaces and points to try things on, and the slow way to every answer: all lifts, all subsets, in rationals.
namespace delcert::test {

template <int m>
using ExactPoints = std::vector<Vector<Rational, m>>;
template <int m>
using Lifts = std::vector<Lift<m>>;

// --- spaces

template <int m>
FlatSpace<m> torus_of(const Matrix<Rational, m>& gram) {
  return {FrameMetric<m>(gram), {}};
}
template <int m>
FlatSpace<m> cubic_torus() {
  return {};
}
inline FlatSpace<2> hexagonal_torus() {
  return torus_of<2>({{{Rational(1), ratio(1, 2)}, {ratio(1, 2), Rational(1)}}});
}
/// The square torus in a basis that is far from reduced: (1, 0), (5, 1).
inline FlatSpace<2> square_torus_in_a_long_basis() {
  return torus_of<2>({{{Rational(1), Rational(5)}, {Rational(5), Rational(26)}}});
}
inline FlatSpace<3> bcc_torus() {
  const Rational a(1);
  const Rational b = ratio(-1, 3);
  return torus_of<3>({{{a, b, b}, {b, a, b}, {b, b, a}}});
}
/// The basis (1, 0, 0), (2/5, 19/20, 0), (1/5, −3/10, 1).
inline FlatSpace<3> skewed_torus() {
  return torus_of<3>({{{Rational(1), ratio(2, 5), ratio(1, 5)},
                       {ratio(2, 5), ratio(17, 16), ratio(-41, 200)},
                       {ratio(1, 5), ratio(-41, 200), ratio(113, 100)}}});
}
template <int m>
FlatSpace<m> ball_of(const Rational& radius) {
  return {FrameMetric<m>::cartesian(), radius};
}

// --- points

/// Multiples of 2^−bits in the box [lower, lower + width)ᵐ, the same for every compiler.
template <int m>
ExactPoints<m> random_points(std::size_t count, std::uint64_t seed, int bits = 12, const Rational& lower = Rational(0),
                             const Rational& width = Rational(1)) {
  std::mt19937_64 random(seed);
  ExactPoints<m> points(count);
  for (auto& point : points) {
    for (Rational& coordinate : point) {
      const Rational unit = Rational(random() >> static_cast<unsigned>(64 - bits)) * Rational::power_of_two(-bits);
      coordinate = lower + width * unit;
    }
  }
  return points;
}

template <int m>
Vector<double, m> approximate(const Vector<Rational, m>& point) {
  Vector<double, m> result;
  for (std::size_t axis = 0; axis < m; ++axis) result[axis] = approximate_double(point[axis]);
  return result;
}
template <int m>
std::vector<Vector<double, m>> approximate_all(const ExactPoints<m>& points) {
  std::vector<Vector<double, m>> result;
  for (const auto& point : points) result.push_back(approximate<m>(point));
  return result;
}

template <int m>
Vector<Rational, m> moved(Vector<Rational, m> point, const Shift<m>& shift) {
  for (std::size_t axis = 0; axis < m; ++axis) point[axis] += Rational(shift[axis]);
  return point;
}
template <int m>
Vector<Rational, m> at(const ExactPoints<m>& points, const Lift<m>& lift) {
  return moved<m>(points[lift.index], lift.shift);
}
template <int m>
ExactPoints<m> all_at(const ExactPoints<m>& points, std::span<const Lift<m>> lifts) {
  ExactPoints<m> result;
  for (const auto& lift : lifts) result.push_back(at<m>(points, lift));
  return result;
}

// --- distances

template <int m>
Rational squared_norm(const FlatSpace<m>& space, const Vector<Rational, m>& x) {
  Rational result(0);
  for (std::size_t a = 0; a < m; ++a) {
    for (std::size_t b = 0; b < m; ++b) result += space.metric.gram()[a][b] * x[a] * x[b];
  }
  return result;
}
template <int m>
Rational squared_distance(const FlatSpace<m>& space, const Vector<Rational, m>& x, const Vector<Rational, m>& y) {
  Vector<Rational, m> edge;
  for (std::size_t axis = 0; axis < m; ++axis) edge[axis] = x[axis] - y[axis];
  return squared_norm<m>(space, edge);
}

/// Calls `visit(shift)` for every integer vector with first ≤ shift ≤ last in every coordinate.
template <int m, class Visit>
void for_each_shift(const Shift<m>& first, const Shift<m>& last, const Visit& visit) {
  Shift<m> shift = first;
  while (true) {
    visit(shift);
    std::size_t axis = m;
    while (axis > 0 && ++shift[axis - 1] > last[axis - 1]) {
      shift[axis - 1] = first[axis - 1];
      --axis;
    }
    if (axis == 0) return;
  }
}

/// All lifts at distance ≤ `distance` of the centre, sorted. (What is clearly farther is told so by doubles.)
template <int m>
Lifts<m> lifts_within(const FlatSpace<m>& space, const ExactPoints<m>& points, const Vector<Rational, m>& centre,
                      const Rational& distance) {
  const auto gram = [&](std::size_t a, std::size_t b) { return approximate_double(space.metric.gram()[a][b]); };
  Matrix<double, m> matrix;
  for (std::size_t a = 0; a < m; ++a) {
    for (std::size_t b = 0; b < m; ++b) matrix[a][b] = gram(a, b);
  }
  Vector<Rational, m> half;
  for (std::size_t axis = 0; axis < m; ++axis) {
    half[axis] = square_root_upper(square(distance) * space.metric.inverse_diagonal(axis), 20);
  }
  const double clearly = approximate_double(square(distance)) * 1.001 + 1e-9;
  Lifts<m> result;
  for (std::uint32_t index = 0; index < points.size(); ++index) {
    Shift<m> first{};
    Shift<m> last{};
    if (space.is_torus()) {
      for (std::size_t axis = 0; axis < m; ++axis) {
        const Rational offset = centre[axis] - points[index][axis];
        first[axis] = ceiling_of(offset - half[axis]).template convert_to<std::int32_t>();
        last[axis] = floor_of(offset + half[axis]).template convert_to<std::int32_t>();
      }
    }
    bool none = false;
    for (std::size_t axis = 0; axis < m; ++axis) none = none || first[axis] > last[axis];
    if (none) continue;
    const auto from_centre = approximate<m>(difference(points[index], centre));
    for_each_shift<m>(first, last, [&](const Shift<m>& shift) {
      double about = 0;
      for (std::size_t a = 0; a < m; ++a) {
        for (std::size_t b = 0; b < m; ++b) {
          about += matrix[a][b] * (from_centre[a] + shift[a]) * (from_centre[b] + shift[b]);
        }
      }
      if (about > clearly) return;
      if (squared_distance<m>(space, moved<m>(points[index], shift), centre) <= square(distance)) {
        result.push_back({index, shift});
      }
    });
  }
  std::sort(result.begin(), result.end());
  return result;
}

// --- simplices

/// The simplex of these points in the metric of the space.
template <int m>
EdgeGram<Rational> simplex_in(const FlatSpace<m>& space, const ExactPoints<m>& vertices) {
  std::vector<std::vector<Rational>> coordinates;
  for (const auto& vertex : vertices) coordinates.emplace_back(vertex.begin(), vertex.end());
  return edge_gram_from_points(coordinates, [&space](const std::vector<Rational>& x, const std::vector<Rational>& y) {
    Rational result(0);
    for (std::size_t a = 0; a < m; ++a) {
      for (std::size_t b = 0; b < m; ++b) result += space.metric.gram()[a][b] * x[a] * y[b];
    }
    return result;
  });
}

template <int m>
struct Ball {
  Vector<Rational, m> centre{};
  Rational squared_radius;
};

/// The smallest circumscribing ball; none if the points are affinely dependent.
template <int m>
std::optional<Ball<m>> ball_of_simplex(const FlatSpace<m>& space, const ExactPoints<m>& vertices) {
  const auto simplex = simplex_in<m>(space, vertices);
  if (!is_proved(GramElimination<Rational>(simplex.gram()).definite())) return std::nullopt;
  const auto sphere = circumsphere(simplex);
  Ball<m> result;
  result.squared_radius = sphere->squared_radius;
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    for (std::size_t axis = 0; axis < m; ++axis) result.centre[axis] += sphere->barycentric[i] * vertices[i][axis];
  }
  return result;
}

/// det of the edge vectors from the first of m + 1 vertices, by Laplace.
template <int m>
Rational edge_determinant(const ExactPoints<m>& vertices) {
  std::vector<std::vector<Rational>> rows;
  for (std::size_t i = 1; i <= m; ++i) {
    const auto edge = difference(vertices[i], vertices[0]);
    rows.emplace_back(edge.begin(), edge.end());
  }
  const auto expand = [](const auto& self, const std::vector<std::vector<Rational>>& a) -> Rational {
    if (a.empty()) return Rational(1);
    Rational result(0);
    for (std::size_t column = 0; column < a.size(); ++column) {
      std::vector<std::vector<Rational>> minor(a.begin() + 1, a.end());
      for (auto& row : minor) row.erase(row.begin() + static_cast<std::ptrdiff_t>(column));
      const Rational term = a[0][column] * self(self, minor);
      result += column % 2 == 0 ? term : -term;
    }
    return result;
  };
  return expand(expand, rows);
}

inline long factorial(int n) { return n <= 1 ? 1 : n * factorial(n - 1); }

/// Whether the open ball holds no lift of the points.
template <int m>
bool is_empty(const FlatSpace<m>& space, const ExactPoints<m>& points, const Ball<m>& ball) {
  const Rational reach = square_root_upper(ball.squared_radius, 20);
  const auto near = lifts_within<m>(space, points, ball.centre, reach);
  return std::none_of(near.begin(), near.end(), [&](const Lift<m>& lift) {
    return squared_distance<m>(space, at<m>(points, lift), ball.centre) < ball.squared_radius;
  });
}

}  // namespace delcert::test
