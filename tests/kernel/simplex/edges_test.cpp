#include "kernel/simplex/edges.hpp"

#include "tests/kernel/simplex/instances.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

TEST(Edges, OfARightTriangle) {
  const Points triangle{{Rational(0), Rational(0)}, {Rational(3), Rational(0)}, {Rational(0), Rational(4)}};
  const auto simplex = simplex_of(triangle);
  EXPECT_EQ(squared_edges(simplex), (std::vector{Rational(9), Rational(16), Rational(25)}));
  EXPECT_EQ(squared_longest_edge(simplex), Rational(25));
  EXPECT_EQ(squared_shortest_edge(simplex), Rational(9));
  const auto big = simplex_on<BigInterval>(triangle);
  EXPECT_TRUE(contains(longest_edge(big), Rational(5)));
  EXPECT_TRUE(contains(shortest_edge(big), Rational(3)));
  EXPECT_FALSE(contains(shortest_edge(big), Rational(4)));
}

TEST(Edges, OfAVertexAreNone) {
  const auto vertex = simplex_of({{Rational(3)}});
  EXPECT_TRUE(squared_edges(vertex).empty());
  EXPECT_EQ(squared_longest_edge(vertex), Rational(0));
  EXPECT_THROW((void)squared_shortest_edge(vertex), std::invalid_argument);
}

RC_GTEST_PROP(Edges, LongestAndShortestBoundAllAndAreAttained, ()) {
  const auto simplex = simplex_of(*any_simplex(1, 6));
  const auto edges = squared_edges(simplex);
  RC_ASSERT(edges.size() == simplex.vertex_count() * simplex.dimension() / 2);
  bool longest = false;
  bool shortest = false;
  for (const Rational& edge : edges) {
    RC_ASSERT(squared_shortest_edge(simplex) <= edge);
    RC_ASSERT(edge <= squared_longest_edge(simplex));
    longest = longest || edge == squared_longest_edge(simplex);
    shortest = shortest || edge == squared_shortest_edge(simplex);
  }
  RC_ASSERT(longest && shortest);
}

RC_GTEST_PROP(Edges, OnIntervalsContainTheExactLengths, ()) {
  const Points points = *any_simplex(1, 6);
  const auto exact = simplex_of(points);
  const RoundingGuard guard;
  const auto enclosed = simplex_on<Interval>(points);
  RC_ASSERT(contains(squared_longest_edge(enclosed), squared_longest_edge(exact)));
  RC_ASSERT(contains(squared_shortest_edge(enclosed), squared_shortest_edge(exact)));
  RC_ASSERT(contains(square(longest_edge(enclosed)), squared_longest_edge(exact)));
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
