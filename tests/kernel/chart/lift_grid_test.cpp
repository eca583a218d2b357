#include "kernel/chart/lift_grid.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "kernel/number/rounding_guard.hpp"
#include "kernel/random/counter_random.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

template <int m>
struct Cloud {
  std::vector<Vector<double, m>> conformal;

  /// Coordinates within this distance of 0.
  Cloud(std::uint32_t count, double extent) {
    for (std::uint32_t label = 0; label < count; ++label) {
      CounterRandom random(7, RandomPurpose::instances, label, 0);
      Vector<double, m> a;
      do {
        for (double& coordinate : a) coordinate = (2 * random.next_unit() - 1) * extent;
      } while (pairing(a, a) >= extent * extent);
      conformal.push_back(a);
    }
  }

  /// Enclosed, with every conformal coordinate `width` wider than need be.
  [[nodiscard]] ModelPoint<Interval, m> point(Curvature curvature, std::size_t label, double width = 0) const {
    Vector<Interval, m> a;
    for (std::size_t axis = 0; axis < m; ++axis)
      a[axis] = Interval::between(conformal[label][axis] - width, conformal[label][axis] + width);
    return model_point<Interval, m>(curvature, a);
  }
};

template <int m>
void expect_all_near_and_none_far(Curvature curvature, const FrameMetric<m>& frame, double extent, double distance,
                                  double width) {
  const Cloud<m> cloud(400, extent);
  const RoundingGuard guard;
  const auto metric = frame.template on<Interval>();
  LiftGrid<m> grid(curvature, frame, distance * 1.3);
  for (std::uint32_t label = 0; label < 400; ++label) grid.insert({label, {}}, cloud.point(curvature, label, width));
  std::size_t within = 0;
  std::size_t beyond = 0;
  for (std::size_t centre = 0; centre < 400; centre += 5) {
    std::vector<Lift<m>> found;
    grid.near(cloud.point(curvature, centre), distance, found);
    // What is found in a list for more than this distance is the same.
    const auto listed = grid.measured(1.5 * distance);
    const auto list = grid.list_near(cloud.point(curvature, centre), listed);
    std::vector<Lift<m>> in_list;
    grid.near_in_list(cloud.point(curvature, centre), listed, list, distance, in_list);
    EXPECT_TRUE(std::is_sorted(in_list.begin(), in_list.end()));
    auto sorted = found;
    std::sort(sorted.begin(), sorted.end());
    EXPECT_TRUE(std::includes(in_list.begin(), in_list.end(), sorted.begin(), sorted.end()));
    EXPECT_LE(in_list.size(), sorted.size() + (width > 0 ? 40 : 0));
    std::vector<Lift<m>> all, all_in_list;
    grid.near(cloud.point(curvature, centre), listed.length, all);
    grid.near_in_list(cloud.point(curvature, centre), listed, list, listed.length, all_in_list);
    EXPECT_EQ(all_in_list.size(), all.size());
    std::vector<bool> is_found(400);
    for (const auto& lift : found) is_found[lift.index] = true;
    for (std::size_t label = 0; label < 400; ++label) {
      const Interval apart = distance_of_chord(
          curvature,
          squared_chord<Interval, m>(curvature, metric, cloud.point(curvature, centre), cloud.point(curvature, label)));
      if (apart.lower() <= distance) {
        EXPECT_TRUE(is_found[label]);
        ++within;
      }
      if (apart.lower() > distance * (1 + 0x1p-30) + 4000 * width) {
        EXPECT_FALSE(is_found[label]) << apart.lower() << " " << distance;
        ++beyond;
      }
    }
    EXPECT_TRUE(grid.approximately_occupied(cloud.point(curvature, centre), distance));
  }
  EXPECT_GT(within, 200U);
  EXPECT_GT(beyond, 200U);
}

TEST(LiftGrid, finds_what_an_exhaustive_search_finds) {
  const auto plane = FrameMetric<2>::cartesian();
  const auto space = FrameMetric<3>::cartesian();
  for (const double width : {0.0, 0x1p-20}) {
    expect_all_near_and_none_far<2>(Curvature::positive, plane, 100, 0.3, width);
    expect_all_near_and_none_far<2>(Curvature::positive, plane, 2, 0.1, width);
    expect_all_near_and_none_far<3>(Curvature::positive, space, 5, 0.7, width);
    expect_all_near_and_none_far<2>(Curvature::zero, plane, 2, 0.2, width);
    expect_all_near_and_none_far<3>(Curvature::zero, space, 1, 0.4, width);
    expect_all_near_and_none_far<2>(Curvature::negative, plane, 1.96, 0.6, width);
    expect_all_near_and_none_far<2>(Curvature::negative, plane, 1, 0.2, width);
    expect_all_near_and_none_far<3>(Curvature::negative, space, 1.9, 1.1, width);
  }
}

TEST(LiftGrid, measures_by_the_metric_of_the_frame) {
  Matrix<Rational, 2> gram{{{Rational(4), Rational(1)}, {Rational(1), Rational(1)}}};
  expect_all_near_and_none_far<2>(Curvature::zero, FrameMetric<2>(gram), 2, 0.3, 0);
}

TEST(LiftGrid, sees_all_of_a_sphere) {
  const Cloud<2> cloud(400, 100);
  const RoundingGuard guard;
  LiftGrid<2> grid(Curvature::positive, FrameMetric<2>::cartesian(), 0.2);
  for (std::uint32_t label = 0; label < 400; ++label) grid.insert({label, {}}, cloud.point(Curvature::positive, label));
  std::vector<Lift<2>> found;
  grid.near(cloud.point(Curvature::positive, 0), 3.2, found);
  EXPECT_EQ(found.size(), 400U);
}

TEST(LiftGrid, empty_space_is_not_occupied) {
  const RoundingGuard guard;
  LiftGrid<2> grid(Curvature::positive, FrameMetric<2>::cartesian(), 0.2);
  const Cloud<2> cloud(1, 1);
  const auto x = cloud.point(Curvature::positive, 0);
  EXPECT_FALSE(grid.approximately_occupied(x, 3));
  ModelPoint<Interval, 2> opposite;
  for (std::size_t axis = 0; axis < 3; ++axis) opposite[axis] = Interval(0) - x[axis];
  grid.insert({0, {}}, opposite);
  EXPECT_FALSE(grid.approximately_occupied(x, 2.9));
  EXPECT_TRUE(grid.approximately_occupied(x, 3.2));
  EXPECT_EQ(grid.size(), 1U);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
