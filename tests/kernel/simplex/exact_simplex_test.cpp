#include "kernel/simplex/exact_simplex.hpp"

#include "kernel/simplex/cayley_menger.hpp"
#include "tests/kernel/simplex/instances.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

RC_GTEST_PROP(ExactSimplex, IsTheSameFromCoordinatesAndFromEdgeLengths, ()) {
  const Points points = *any_simplex(0, 5);
  const auto by_points = ExactSimplex::from_points(points).on<Rational>();
  const auto by_edges = ExactSimplex::from_squared_edges(squared_distance_matrix(simplex_of(points))).on<Rational>();
  const auto by_metric =
      ExactSimplex::from_points(points, SymmetricMatrix<Rational>::identity(points[0].size())).on<Rational>();
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::size_t j = 0; j < points.size(); ++j) {
      RC_ASSERT(by_points.squared_edge(i, j) == by_edges.squared_edge(i, j));
      RC_ASSERT(by_points.squared_edge(i, j) == by_metric.squared_edge(i, j));
      RC_ASSERT(by_points.product(0, i, j) == by_edges.product(0, i, j));
      RC_ASSERT(by_points.product(0, i, j) == by_metric.product(0, i, j));
    }
  }
}

RC_GTEST_PROP(ExactSimplex, OnIntervalsContainsItself, ()) {
  const Points points = *any_simplex(1, 4);
  const auto exact = simplex_of(points);
  SymmetricMatrix<Rational> metric = SymmetricMatrix<Rational>::identity(points[0].size()).shifted(ratio(1, 3));
  for (const auto& simplex : {ExactSimplex::from_points(points), ExactSimplex::from_points(points, metric),
                              ExactSimplex::from_squared_edges(squared_distance_matrix(exact))}) {
    const auto own = simplex.on<Rational>();
    const RoundingGuard guard;
    RC_ASSERT(contains(simplex.on<Interval>().squared_edge(0, 1), own.squared_edge(0, 1)));
    RC_ASSERT(contains(simplex.on<BigInterval>().squared_edge(0, 1), own.squared_edge(0, 1)));
  }
}

TEST(ExactSimplex, RefusesWhatIsNoSimplex) {
  EXPECT_THROW((void)ExactSimplex::from_points({}), std::invalid_argument);
  EXPECT_THROW((void)ExactSimplex::from_points({{}}), std::invalid_argument);
  EXPECT_THROW((void)ExactSimplex::from_points({{Rational(1)}, {Rational(1), Rational(1)}}), std::invalid_argument);
  EXPECT_THROW((void)ExactSimplex::from_points({{Rational(1)}}, SymmetricMatrix<Rational>::identity(2)),
               std::invalid_argument);
  EXPECT_THROW((void)ExactSimplex::from_points({{Rational(1)}}, SymmetricMatrix<Rational>(1)), std::invalid_argument);
  SymmetricMatrix<Rational> long_side(3);
  long_side(0, 1) = long_side(0, 2) = Rational(1);
  long_side(1, 2) = Rational(4);
  EXPECT_NO_THROW((void)ExactSimplex::from_squared_edges(long_side));
  long_side(1, 2) += Rational::power_of_two(-300);
  EXPECT_THROW((void)ExactSimplex::from_squared_edges(long_side), std::invalid_argument);
  EXPECT_THROW((void)ExactSimplex::from_squared_edges(SymmetricMatrix<Rational>::identity(2)), std::invalid_argument);
  EXPECT_THROW((void)ExactSimplex::from_squared_edges(SymmetricMatrix<Rational>(0)), std::invalid_argument);
}

TEST(ExactSimplex, DecisionsClimbUntilARungDecides) {
  const auto simplex = ExactSimplex::from_points({{Rational(0)}, {ratio(1, 3)}});
  const auto length_is = [&](const Rational& squared) {
    return decide_on(simplex, [&]<class S>(const EdgeGram<S>& on_rung) {
      return less_equal(on_rung.squared_edge(0, 1), scalar_from<S>(squared));
    });
  };
  const LadderStatistics before = ladder_statistics();
  EXPECT_EQ(length_is(Rational(1)), Verdict::proved);
  EXPECT_EQ(length_is(ratio(1, 9) - Rational::power_of_two(-100)), Verdict::refuted);
  EXPECT_EQ(length_is(ratio(1, 9)), Verdict::proved);
  const LadderStatistics spent = ladder_statistics() - before;
  EXPECT_EQ(spent.settled[static_cast<std::size_t>(Rung::interval)], 1U);
  EXPECT_EQ(spent.settled[static_cast<std::size_t>(Rung::big_interval)], 1U);
  EXPECT_EQ(spent.settled[static_cast<std::size_t>(Rung::rational)], 1U);
  EXPECT_EQ(spent.undecided, 0U);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
