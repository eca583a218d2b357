#include "kernel/simplex/realisability.hpp"

#include "kernel/simplex/cayley_menger.hpp"
#include "kernel/simplex/matrix_norm.hpp"
#include "kernel/simplex/normal_space.hpp"
#include "tests/kernel/simplex/instances.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

EdgeGram<Rational> triangle(const Rational& a, const Rational& b, const Rational& c) {
  SymmetricMatrix<Rational> squared(3);
  squared(0, 1) = square(a);
  squared(0, 2) = square(b);
  squared(1, 2) = square(c);
  return edge_gram_from_squared_edges(squared);
}

TEST(Realisability, OfTrianglesIsTheTriangleInequality) {
  for (int a = 1; a <= 6; ++a) {
    for (int b = 1; b <= 6; ++b) {
      for (int c = 1; c <= 6; ++c) {
        const auto simplex = triangle(Rational(a), Rational(b), Rational(c));
        const bool weak = a + b >= c && b + c >= a && c + a >= b;
        const bool strict = a + b > c && b + c > a && c + a > b;
        EXPECT_EQ(is_realisable(simplex, 2), verdict_of(weak)) << a << b << c;
        EXPECT_EQ(is_realisable(simplex, 1), verdict_of(weak && !strict)) << a << b << c;
        EXPECT_EQ(is_non_degenerate(simplex), verdict_of(strict)) << a << b << c;
      }
    }
  }
}

// All triangles are fine, but six points at distance 1 need five dimensions, and a unit tetrahedron has no fifth point
// at distance 3/5 of all vertices (its circumradius is √6/4 > 3/5).
TEST(Realisability, AsksMoreThanTriangleInequalities) {
  SymmetricMatrix<Rational> squared(5);
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j < i; ++j) squared(i, j) = Rational(1);
    squared(4, i) = square(ratio(3, 5));
  }
  EXPECT_EQ(is_realisable(edge_gram_from_squared_edges(squared), 9), Verdict::refuted);
  for (std::size_t i = 0; i < 4; ++i) squared(4, i) = ratio(6, 16);
  EXPECT_EQ(is_realisable(edge_gram_from_squared_edges(squared), 3), Verdict::proved);
  EXPECT_EQ(is_realisable(edge_gram_from_squared_edges(squared), 2), Verdict::refuted);
  const auto regular = simplex_of(regular_simplex(5));
  EXPECT_EQ(is_realisable(regular, 5), Verdict::proved);
  EXPECT_EQ(is_realisable(regular, 4), Verdict::refuted);
}

TEST(Realisability, NegativeSquaresAreNoLengths) {
  SymmetricMatrix<Rational> squared(2);
  squared(0, 1) = Rational(-1);
  EXPECT_EQ(is_realisable(edge_gram_from_squared_edges(squared), 3), Verdict::refuted);
}

RC_GTEST_PROP(Realisability, PointsHaveRealisableLengthsInTheDimensionOfTheirHull, ()) {
  const Points points = *any_simplex(0, 6);
  const auto simplex = edge_gram_from_squared_edges(squared_distance_matrix(simplex_of(points)));
  RC_ASSERT(is_realisable(simplex, points[0].size()) == Verdict::proved);
  Points edges;
  for (std::size_t i = 1; i < points.size(); ++i) {
    edges.push_back(points[i]);
    for (std::size_t axis = 0; axis < points[0].size(); ++axis) edges.back()[axis] -= points[0][axis];
  }
  const std::size_t m = points[0].size();
  const std::size_t hull = m - detail::kernel_basis<Rational>(edges, m)->size();
  RC_ASSERT(is_realisable(simplex, hull) == Verdict::proved);
  if (hull > 0) RC_ASSERT(is_realisable(simplex, hull - 1) == Verdict::refuted);
  RC_ASSERT(is_non_degenerate(simplex) == verdict_of(hull == simplex.dimension()));
}

RC_GTEST_PROP(Realisability, OnIntervalsNeverContradictsTheExactVerdict, ()) {
  SymmetricMatrix<Rational> squared(4);
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j < i; ++j) squared(i, j) = ratio(*rc::gen::inRange(1, 30), 3);
  }
  const auto exact = edge_gram_from_squared_edges(squared);
  RC_CLASSIFY(is_proved(is_realisable(exact, 3)), "realisable");
  const RoundingGuard guard;
  const auto enclosed = edge_gram_from_squared_edges(matrix_from<Interval>(squared));
  for (std::size_t m = 1; m <= 3; ++m) RC_ASSERT(agrees(is_realisable(enclosed, m), is_realisable(exact, m)));
  RC_ASSERT(agrees(is_non_degenerate(enclosed), is_non_degenerate(exact)));
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
