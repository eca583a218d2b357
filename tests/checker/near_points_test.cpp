#include "proofs/checker/geometry/near_points.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <set>

#include "tests/checker/upwards.hpp"

namespace delcert::checker_tests {
namespace {

using namespace checker;

struct NearPointsOfChecker : testing::Test, test::Upwards {};

TEST_F(NearPointsOfChecker, misses_none_within_the_radius) {
  std::mt19937 random(7);
  const auto next = [&random] { return static_cast<int>(random() % 64) / 8.0; };  // many coordinates agree
  for (const std::size_t axes : {1U, 2U, 3U, 6U}) {
    for (const int number : {1, 7, 8, 9, 500}) {
      std::vector<Matrix<Interval>> points;
      for (int j = 0; j < number; ++j) {
        points.emplace_back(axes, 1);
        for (std::size_t k = 0; k < axes; ++k) {
          const double x = next();
          points.back()[k] = Interval::between(x, x + 0x1p-30);
        }
      }
      const NearPoints near(points);
      for (int query = 0; query < 50; ++query) {
        Matrix<Interval> place(axes, 1);
        for (std::size_t k = 0; k < axes; ++k) {
          const double x = next();
          place[k] = Interval::between(x, x);
        }
        const double radius = next() / 2;
        std::multiset<std::uint32_t> found;
        near.visit(place, radius, [&](std::uint32_t j) { found.insert(j); });
        for (std::uint32_t j = 0; j < points.size(); ++j) {
          const double distance = norm_above(points[j] - place);
          const std::size_t times = found.count(j);
          EXPECT_LE(times, 1U);
          EXPECT_TRUE(distance > radius || times == 1);
          EXPECT_TRUE(distance <= radius + 0x1p-10 || times == 0);
        }
      }
    }
  }
}

TEST_F(NearPointsOfChecker, is_undecided_about_points_that_are_not_known) {
  Matrix<Interval> unknown(2, 1);
  unknown[1] = Interval(1) / Interval::between(-1, 1);
  EXPECT_THROW(NearPoints({unknown}), Undecided);
}

}  // namespace
}  // namespace delcert::checker_tests
