#include "kernel/simplex/edge_gram.hpp"

#include <array>

#include "kernel/simplex/cayley_menger.hpp"
#include "tests/kernel/simplex/instances.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

void expect_same(const EdgeGram<Rational>& a, const EdgeGram<Rational>& b) {
  RC_ASSERT(a.dimension() == b.dimension());
  RC_ASSERT(a.vertex_count() == b.vertex_count());
  for (std::size_t i = 0; i < a.vertex_count(); ++i) {
    for (std::size_t j = 0; j < a.vertex_count(); ++j) {
      RC_ASSERT(a.squared_edge(i, j) == b.squared_edge(i, j));
      if (i > 0 && j > 0) RC_ASSERT(a.gram()(i - 1, j - 1) == b.gram()(i - 1, j - 1));
      for (std::size_t base = 0; base < a.vertex_count(); ++base) {
        RC_ASSERT(a.product(base, i, j) == b.product(base, i, j));
      }
    }
  }
}

RC_GTEST_PROP(EdgeGram, FromCoordinatesAndFromEdgeLengthsIsTheSame, ()) {
  const auto simplex = simplex_of(*any_simplex(0, 6));
  expect_same(simplex, edge_gram_from_squared_edges(squared_distance_matrix(simplex)));
}

RC_GTEST_PROP(EdgeGram, ProductsAreThoseOfTheCoordinates, ()) {
  const Points points = *any_simplex(1, 5);
  const auto simplex = simplex_of(points);
  for (std::size_t base = 0; base < points.size(); ++base) {
    for (std::size_t i = 0; i < points.size(); ++i) {
      for (std::size_t j = 0; j < points.size(); ++j) {
        Rational product(0);
        for (std::size_t axis = 0; axis < points[0].size(); ++axis) {
          product += (points[i][axis] - points[base][axis]) * (points[j][axis] - points[base][axis]);
        }
        RC_ASSERT(simplex.product(base, i, j) == product);
      }
    }
  }
}

RC_GTEST_PROP(EdgeGram, InIntegersAndInFractionsItIsTheSame, ()) {
  Points points = *any_simplex(0, 5);
  // Dyadic or with a common denominator; and with denominators that have nothing in common.
  if (*rc::gen::arbitrary<bool>()) {
    for (auto& point : points) {
      for (Rational& x : point) x = x / (Rational::power_of_two(*rc::gen::inRange(100, 130)) - Rational(1));
    }
  }
  const auto inner = [](const std::vector<Rational>& x, const std::vector<Rational>& y) {
    Rational sum(0);
    for (std::size_t axis = 0; axis < x.size(); ++axis) sum += x[axis] * y[axis];
    return sum;
  };
  expect_same(edge_gram_from_points(points), edge_gram_from_points(points, inner));
}

RC_GTEST_PROP(EdgeGram, AMetricIsTheImageUnderALinearMap, ()) {
  const std::size_t m = 3;
  const Points points = *any_points(4, m);
  const Points map = *any_points(m, m);  // rows
  Points images;
  for (const auto& point : points) {
    images.emplace_back();
    for (const auto& row : map) {
      Rational sum(0);
      for (std::size_t axis = 0; axis < m; ++axis) sum += row[axis] * point[axis];
      images.back().push_back(sum);
    }
  }
  SymmetricMatrix<Rational> metric(m);
  for (std::size_t a = 0; a < m; ++a) {
    for (std::size_t b = 0; b <= a; ++b) {
      for (std::size_t row = 0; row < m; ++row) metric(a, b) += map[row][a] * map[row][b];
    }
  }
  expect_same(edge_gram_from_points(points, metric), simplex_of(images));
}

RC_GTEST_PROP(EdgeGram, FacesAreTheSimplicesOfTheirPoints, ()) {
  const Points points = *any_simplex(2, 5);
  const auto simplex = simplex_of(points);
  const std::size_t last = points.size() - 1;
  expect_same(simplex.face({last, 0}), simplex_of({points[last], points[0]}));
  expect_same(simplex.face({1, last}), simplex_of({points[1], points[last]}));
  for (std::size_t p = 0; p <= last; ++p) {
    Points others = points;
    others.erase(others.begin() + static_cast<std::ptrdiff_t>(p));
    expect_same(simplex.opposite_facet(p), simplex_of(others));
  }
}

RC_GTEST_PROP(EdgeGram, OnIntervalsContainsTheExactEntries, ()) {
  const Points points = *any_simplex(0, 5);
  const auto exact = simplex_of(points);
  const RoundingGuard guard;
  const auto enclosed = simplex_on<Interval>(points);
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::size_t j = 0; j < points.size(); ++j) {
      RC_ASSERT(contains(enclosed.squared_edge(i, j), exact.squared_edge(i, j)));
      for (std::size_t base = 0; base < points.size(); ++base) {
        RC_ASSERT(contains(enclosed.product(base, i, j), exact.product(base, i, j)));
      }
    }
  }
}

TEST(EdgeGram, TakesPointsInArrays) {
  const std::array<std::array<Rational, 2>, 2> points{{{Rational(1), Rational(2)}, {Rational(4), Rational(6)}}};
  EXPECT_EQ(edge_gram_from_points(points).squared_edge(0, 1), Rational(25));
  SymmetricMatrix<Rational> skewed = SymmetricMatrix<Rational>::identity(2);
  skewed(0, 1) = ratio(1, 2);
  EXPECT_EQ(edge_gram_from_points(points, skewed).squared_edge(0, 1), Rational(37));
}

TEST(EdgeGram, RefusesWhatIsNoSimplex) {
  EXPECT_THROW((void)simplex_of({}), std::invalid_argument);
  EXPECT_THROW((void)simplex_of({{Rational(1)}, {Rational(1), Rational(2)}}), std::invalid_argument);
  EXPECT_THROW((void)edge_gram_from_squared_edges(SymmetricMatrix<Rational>(0)), std::invalid_argument);
  EXPECT_THROW((void)simplex_of({{Rational(1)}}).opposite_facet(0), std::invalid_argument);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
