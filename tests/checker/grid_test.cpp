#include "proofs/checker/geometry/grid.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>

#include "tests/checker/upwards.hpp"

namespace delcert::checker_tests {
namespace {

using namespace checker;

/// Random points of a frame whose coordinates leave [0, 1), with their texts.
struct Cloud {
  Cloud(int m, const std::vector<std::string>& gram, bool periodic, int number, std::uint64_t seed) : m_(m) {
    std::mt19937_64 random(seed);
    for (int k = 0; k < m * number; ++k) {
      texts.push_back((random() % 2 == 0 ? "-" : "") + std::to_string(random() % 2000) +
                      (random() % 4 == 0 ? "/500" : "/1000"));
    }
    for (const std::string& text : texts) views.push_back(text);
    std::vector<Rational> entries;
    for (const std::string& text : gram) entries.push_back(exact_value(text));
    metric = Metric(m, entries);
    points = PointSet(metric, periodic, views);
  }

  /// All lifts with integer coordinates up to `bound` within the distance, decided one by one.
  std::set<Vertex> within(const Vertex& v, const Quantity& distance, int bound) const {
    std::set<Vertex> found;
    if (!points.periodic()) bound = 0;
    for (Label j = 0; j < points.size(); ++j) {
      Lift lift{};
      const auto limit = [&](int k) { return k < m_ ? bound : 0; };
      for (lift[0] = -limit(0); lift[0] <= limit(0); ++lift[0]) {
        for (lift[1] = -limit(1); lift[1] <= limit(1); ++lift[1]) {
          for (lift[2] = -limit(2); lift[2] <= limit(2); ++lift[2]) {
            if (less_equal(points.between<Rational>(v, {j, lift}), square(distance.exact)) == Verdict::proved)
              found.insert({j, lift});
          }
        }
      }
    }
    return found;
  }

  int m_;
  std::vector<std::string> texts;
  std::vector<std::string_view> views;
  Metric metric;
  PointSet points;
};

void compare(const Cloud& cloud, const char* distance, int bound) {
  const Grid grid(cloud.points);
  const Quantity a(exact_value(distance));
  for (Label i = 0; i < cloud.points.size(); i += 3) {
    const Vertex v{i, {}};
    std::set<Vertex> seen;
    std::size_t visits = 0;
    grid.visit(cloud.points.position<Interval>(v), a.filter.upper(), [&](const Vertex& q) {
      ++visits;
      seen.insert(q);
    });
    EXPECT_EQ(visits, seen.size()) << "a lift is visited twice";
    const std::set<Vertex> expected = cloud.within(v, a, bound);
    EXPECT_TRUE(std::includes(seen.begin(), seen.end(), expected.begin(), expected.end())) << "label " << i;
    for (const auto closed : {true, false}) {
      std::set<Vertex> found;
      for (Label j = 0; j < cloud.points.size(); ++j) {
        for (const Lift& lift : cloud.points.lifts_within(v, j, a, closed)) found.insert({j, lift});
      }
      for (const Vertex& q : expected) {
        const bool on_boundary = cloud.points.between<Rational>(v, q) == square(a.exact);
        EXPECT_EQ(found.contains(q), closed || !on_boundary);
      }
      EXPECT_TRUE(std::includes(expected.begin(), expected.end(), found.begin(), found.end())) << "label " << i;
    }
  }
}

class GridVisits : public testing::Test {
 protected:
  const test::Upwards upwards;
};

TEST_F(GridVisits, all_lifts_within_the_distance_on_a_circle) { compare({1, {"1"}, true, 40, 1}, "3/10", 9); }
TEST_F(GridVisits, all_lifts_on_a_square_torus) { compare({2, {"1", "0", "0", "1"}, true, 30, 2}, "1/4", 9); }
TEST_F(GridVisits, all_lifts_within_more_than_the_torus) { compare({2, {"1", "0", "0", "1"}, true, 12, 3}, "3/2", 10); }
TEST_F(GridVisits, all_lifts_on_a_torus_with_a_skewed_basis) {
  compare({2, {"1", "7/2", "7/2", "50/4"}, true, 30, 4}, "1/5", 10);
}
TEST_F(GridVisits, all_lifts_on_a_long_thin_torus) {
  compare({2, {"100", "0", "0", "1/100"}, true, 30, 5}, "1/10", 10);
}
TEST_F(GridVisits, all_lifts_on_a_torus_of_dimension_3) {
  compare({3, {"3", "-1", "-1", "-1", "3", "-1", "-1", "-1", "3"}, true, 12, 6}, "1/2", 9);
}
TEST_F(GridVisits, all_points_of_a_ball) {
  compare({1, {}, false, 30, 7}, "1/2", 0);
  compare({2, {}, false, 60, 8}, "1/2", 0);
  compare({3, {}, false, 60, 9}, "2", 0);
}

TEST_F(GridVisits, a_single_point_at_any_place) {
  compare({2, {}, false, 1, 10}, "1", 0);
  compare({2, {"1", "0", "0", "1"}, true, 1, 11}, "2", 3);
}

TEST_F(GridVisits, end_undecided_where_doubles_are_too_coarse) {
  for (const char* coordinate : {"0x1p60", "0x1p99999", "-0x1p31"}) {
    const std::vector<std::string_view> views = {coordinate, "0"};
    const Metric metric(2, {Rational(1), Rational(0), Rational(0), Rational(1)});
    const PointSet points(metric, true, views);
    EXPECT_THROW(Grid{points}, Undecided);
  }
}

TEST(MetricOf, a_matrix_that_is_not_positive_definite_is_refused) {
  const test::Upwards upwards;
  const auto matrix = [](std::initializer_list<int> entries) {
    std::vector<Rational> result;
    for (const int entry : entries) result.emplace_back(entry);
    return result;
  };
  EXPECT_THROW(Metric(2, matrix({1, 2, 2, 4})), Malformed);
  EXPECT_THROW(Metric(2, matrix({1, 2, 2, 3})), Malformed);
  EXPECT_THROW(Metric(2, matrix({2, 1, 0, 2})), Malformed);
  EXPECT_THROW(Metric(3, matrix({1, 0, 0, 0, 1, 0, 0, 0, -1})), Malformed);
  const Metric skewed(2, matrix({1, 2, 2, 5}));
  EXPECT_GE(skewed.stretch(0), std::sqrt(5.0));
  EXPECT_LE(skewed.stretch(0), 2.2360680);
  EXPECT_GE(skewed.stretch(1), 1);
}

}  // namespace
}  // namespace delcert::checker_tests
