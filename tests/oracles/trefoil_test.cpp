#include <cmath>
#include <numbers>

#include "kernel/number/rational.hpp"
#include "kernel/theorems/graph_isotopy.hpp"
#include "tests/oracles/submanifold_sample.hpp"

// The knot that a certified polygon is, by the Alexander polynomial of a diagram of it.
namespace delcert::test {
namespace DELCERT_THIS_FILE {

using Point = std::array<double, 3>;
using Polygon = std::vector<Point>;

/// The vertices of a complex that is one circle, in their order.
std::vector<std::uint32_t> cycle_of(const LabelComplex<1>& edges, std::size_t vertices) {
  std::vector<std::vector<std::uint32_t>> neighbours(vertices);
  for (const auto& [a, b] : edges) {
    neighbours[a].push_back(b);
    neighbours[b].push_back(a);
  }
  std::vector<std::uint32_t> result{0};
  std::uint32_t before = neighbours[0][0];
  for (std::uint32_t next = neighbours[0][1]; next != 0;) {
    result.push_back(next);
    const auto& around = neighbours[next];
    const std::uint32_t after = around[0] == result[result.size() - 2] ? around[1] : around[0];
    next = after;
  }
  EXPECT_EQ(result.back(), before);
  return result;
}

/// A crossing of a diagram: edge `under` passes below edge `over`, at these parts of their lengths.
struct Crossing {
  std::size_t under, over;
  double at_under, at_over;
  bool is_positive;
};

/// Seen from above. Edges of a polygon in general position.
std::vector<Crossing> crossings_of(const Polygon& knot) {
  std::vector<Crossing> result;
  const std::size_t n = knot.size();
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = i + 2; j < n; ++j) {
      if (i == 0 && j == n - 1) continue;
      const Point &a = knot[i], &b = knot[(i + 1) % n], &c = knot[j], &d = knot[(j + 1) % n];
      const double det = (b[0] - a[0]) * (d[1] - c[1]) - (b[1] - a[1]) * (d[0] - c[0]);
      if (std::abs(det) < 1e-14) continue;
      const double s = ((c[0] - a[0]) * (d[1] - c[1]) - (c[1] - a[1]) * (d[0] - c[0])) / det;
      const double t = ((c[0] - a[0]) * (b[1] - a[1]) - (c[1] - a[1]) * (b[0] - a[0])) / det;
      if (s < 0 || s >= 1 || t < 0 || t >= 1) continue;
      const double above = a[2] + s * (b[2] - a[2]) - c[2] - t * (d[2] - c[2]);
      EXPECT_GT(std::abs(above), 1e-6);
      // Positive: the one above turns counterclockwise into the one below.
      result.push_back(above > 0 ? Crossing{j, i, t, s, det > 0} : Crossing{i, j, s, t, det < 0});
    }
  }
  return result;
}

Rational determinant(std::vector<std::vector<Rational>> matrix) {
  Rational result(1);
  for (std::size_t column = 0; column < matrix.size(); ++column) {
    std::size_t pivot = column;
    while (pivot < matrix.size() && matrix[pivot][column] == Rational(0)) ++pivot;
    if (pivot == matrix.size()) return Rational(0);
    if (pivot != column) {
      std::swap(matrix[pivot], matrix[column]);
      result = -result;
    }
    result *= matrix[column][column];
    for (std::size_t row = column + 1; row < matrix.size(); ++row) {
      const Rational factor = matrix[row][column] / matrix[column][column];
      for (std::size_t k = column; k < matrix.size(); ++k) matrix[row][k] -= factor * matrix[column][k];
    }
  }
  return result;
}

/// |Δ(t)| of the knot, without powers of t.
Rational alexander_at(const Polygon& knot, long t) {
  auto crossings = crossings_of(knot);
  if (crossings.empty()) return Rational(1);
  const auto place_under = [](const Crossing& c) { return static_cast<double>(c.under) + c.at_under; };
  const auto place_over = [](const Crossing& c) { return static_cast<double>(c.over) + c.at_over; };
  std::sort(crossings.begin(), crossings.end(),
            [&](const Crossing& a, const Crossing& b) { return place_under(a) < place_under(b); });
  const std::size_t n = crossings.size();
  // Arc k ends below at crossing k, and arc k + 1 begins there.
  const auto arc_at = [&](double place) {
    const auto end =
        std::find_if(crossings.begin(), crossings.end(), [&](const Crossing& c) { return place < place_under(c); });
    return static_cast<std::size_t>(end - crossings.begin()) % n;
  };
  std::vector<std::vector<Rational>> matrix(n, std::vector<Rational>(n, Rational(0)));
  for (std::size_t k = 0; k < n; ++k) {
    const Crossing& crossing = crossings[k];
    const Rational first = crossing.is_positive ? Rational(t) : Rational(-1);
    const Rational second = crossing.is_positive ? Rational(-1) : Rational(t);
    matrix[k][arc_at(place_over(crossing))] += Rational(1 - t);
    matrix[k][k] += first;
    matrix[k][(k + 1) % n] += second;
  }
  matrix.pop_back();
  for (auto& row : matrix) row.pop_back();
  Rational result = determinant(std::move(matrix));
  if (result < Rational(0)) result = -result;
  if (t != 1 && t != -1 && result != Rational(0)) {
    while (floor_of(result / Rational(t)) * Integer(t) == floor_of(result)) result = result / Rational(t);
  }
  return result;
}

/// At -1, 2 and 3.
std::array<Rational, 3> alexander_of(const Polygon& knot) {
  return {alexander_at(knot, -1), alexander_at(knot, 2), alexander_at(knot, 3)};
}
std::array<Rational, 3> numbers(long a, long b, long c) { return {Rational(a), Rational(b), Rational(c)}; }

/// Along a direction that is not special to anything here.
Polygon turned(Polygon knot) {
  for (Point& x : knot) {
    const double c = std::cos(0.7), s = std::sin(0.7), d = std::cos(1.9), e = std::sin(1.9);
    x = {c * x[0] - s * x[2], x[1], s * x[0] + c * x[2]};
    x = {x[0], d * x[1] - e * x[2], e * x[1] + d * x[2]};
  }
  return knot;
}

template <class Curve>
Polygon polygon_of(const Curve& curve) {
  Polygon result;
  constexpr int vertices = 200;
  for (int k = 0; k < vertices; ++k) result.push_back(curve(2 * std::numbers::pi * k / vertices));
  return result;
}

// t² − t + 1 has 3, 3, 7; t² − 3t + 1 has 5, −1, 1.
TEST(AlexanderPolynomial, knows_knots_by_their_parametrisations) {
  const auto trefoil = polygon_of([](double t) -> Point {
    return {std::sin(t) + 2 * std::sin(2 * t), std::cos(t) - 2 * std::cos(2 * t), -std::sin(3 * t)};
  });
  const auto figure_eight = polygon_of([](double t) -> Point {
    const double radius = 2 + std::cos(2 * t);
    return {radius * std::cos(3 * t), radius * std::sin(3 * t), std::sin(4 * t)};
  });
  const auto unknot = polygon_of([](double t) -> Point { return {std::cos(t), std::sin(t), std::sin(3 * t) / 2}; });
  for (const bool is_turned : {false, true}) {
    const auto seen = [&](const Polygon& knot) { return alexander_of(is_turned ? turned(knot) : knot); };
    EXPECT_EQ(seen(trefoil), numbers(3, 3, 7));
    EXPECT_EQ(seen(figure_eight), numbers(5, 1, 1));
    EXPECT_EQ(seen(unknot), numbers(1, 1, 1));
  }
}

TEST(Trefoil, as_a_zero_set_is_a_trefoil) {
  const SubmanifoldSample<1> sample("trefoil", Rational(Integer(1), Integer(26)));
  EXPECT_LE(sample.size(), 300U);
  // Embedded, and isotopic to the zero set: the knot of the polygon is that of the curve.
  EXPECT_TRUE(check_graph_isotopy<1>(sample.vertices, sample.simplices, sample.triangulation, no_progress()).holds());
  const auto cycle = cycle_of(sample.simplices, sample.size());
  ASSERT_EQ(cycle.size(), sample.size());
  Polygon knot;
  for (const std::uint32_t label : cycle) {
    const auto x = sample.position(label);
    knot.push_back({x[0], x[1], x[2]});
  }
  EXPECT_EQ(alexander_of(turned(knot)), numbers(3, 3, 7));
  // The twin: the same diagram with each later edge above the earlier ones is an unknot.
  Polygon rising = turned(knot);
  EXPECT_GE(crossings_of(rising).size(), 3U);
  for (std::size_t k = 0; k < rising.size(); ++k) rising[k][2] = static_cast<double>(k);
  EXPECT_EQ(alexander_of(rising), numbers(1, 1, 1));
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
