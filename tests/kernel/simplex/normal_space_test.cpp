#include "kernel/simplex/normal_space.hpp"

#include "kernel/simplex/realisability.hpp"
#include "tests/kernel/simplex/instances.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

Rational product(const SymmetricMatrix<Rational>& metric, const std::vector<Rational>& a,
                 const std::vector<Rational>& b) {
  Rational sum(0);
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t j = 0; j < b.size(); ++j) sum += a[i] * metric(i, j) * b[j];
  }
  return sum;
}

std::vector<Rational> minus(const std::vector<Rational>& a, const std::vector<Rational>& b) {
  std::vector<Rational> result;
  for (std::size_t axis = 0; axis < a.size(); ++axis) result.push_back(a[axis] - b[axis]);
  return result;
}

TEST(NormalSpace, OfAnEdgeIsItsBisector) {
  const auto space = normal_space(Points{{Rational(0), Rational(0)}, {Rational(2), Rational(2)}});
  ASSERT_TRUE(space);
  EXPECT_EQ(space->base, (std::vector{Rational(1), Rational(1)}));
  ASSERT_EQ(space->directions.size(), 1U);
  EXPECT_EQ(space->directions[0][0] + space->directions[0][1], Rational(0));
  EXPECT_NE(space->directions[0][0], Rational(0));
}

TEST(NormalSpace, OfAVertexIsEverything) {
  const auto space = normal_space(Points{{Rational(0), Rational(7), Rational(1)}});
  EXPECT_EQ(space->directions.size(), 3U);
}

TEST(NormalSpace, OfAFlatTetrahedronOnACircleIsItsAxis) {
  const Points square{{Rational(0), Rational(0), Rational(0)},
                      {Rational(1), Rational(0), Rational(0)},
                      {Rational(1), Rational(1), Rational(0)},
                      {Rational(0), Rational(1), Rational(0)}};
  const auto space = normal_space(square);
  ASSERT_TRUE(space);
  EXPECT_EQ(space->base, (std::vector{ratio(1, 2), ratio(1, 2), Rational(0)}));
  EXPECT_EQ(space->directions, (Points{{Rational(0), Rational(0), Rational(1)}}));
}

TEST(NormalSpace, OfPointsOfALineDoesNotExist) {
  const Points collinear{{Rational(0), Rational(0)}, {Rational(1), Rational(1)}, {Rational(3), Rational(3)}};
  EXPECT_EQ(normal_space(collinear).exists(), Verdict::refuted);
  Points thirds = collinear;
  for (auto& point : thirds) {
    for (auto& coordinate : point) coordinate = coordinate / Rational(3);
  }
  const RoundingGuard guard;
  EXPECT_EQ(normal_space(points_on<Interval>(thirds)).exists(), Verdict::undecided);
}

RC_GTEST_PROP(NormalSpace, HoldsTheCentresOfAllCircumscribingBalls, ()) {
  const Points points = *any_simplex(0, 5);
  const std::size_t m = points[0].size();
  SymmetricMatrix<Rational> metric(m);
  for (std::size_t i = 0; i < m; ++i) {
    metric(i, i) = Rational(3);
    for (std::size_t j = 0; j < i; ++j) metric(i, j) = ratio(*rc::gen::inRange(-2, 3), 4);
  }
  RC_PRE(is_proved(GramElimination<Rational>(metric).definite()));
  const auto space = normal_space(points, metric);
  RC_PRE(space.has_value());
  if (is_proved(is_non_degenerate(edge_gram_from_points(points, metric)))) {
    RC_ASSERT(space->directions.size() == m + 1 - points.size());
  }
  std::vector<Rational> centre = space->base;
  for (const auto& direction : space->directions) {
    const Rational step = *any_coordinate();
    for (std::size_t axis = 0; axis < m; ++axis) centre[axis] += step * direction[axis];
    for (const auto& point : points) RC_ASSERT(product(metric, direction, minus(point, points[0])) == Rational(0));
  }
  const auto radius = minus(points[0], centre);
  for (const auto& point : points) {
    RC_ASSERT(product(metric, minus(point, centre), minus(point, centre)) == product(metric, radius, radius));
  }
  // The base is the nearest centre: orthogonal to all directions.
  for (const auto& direction : space->directions) {
    RC_ASSERT(product(metric, direction, minus(points[0], space->base)) == Rational(0));
  }
}

RC_GTEST_PROP(NormalSpace, OnIntervalsContainsTheExactBase, ()) {
  const Points points = *any_simplex(0, 5);
  const auto exact = normal_space(points);
  const RoundingGuard guard;
  const auto enclosed = normal_space(points_on<Interval>(points));
  RC_PRE(enclosed.has_value());
  RC_ASSERT(exact.has_value());
  RC_ASSERT(enclosed->directions.size() == exact->directions.size());
  for (std::size_t axis = 0; axis < points[0].size(); ++axis) {
    RC_ASSERT(contains(enclosed->base[axis], exact->base[axis]));
  }
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
