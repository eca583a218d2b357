#include "kernel/sample/disk_sampling.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/message_of.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

/// Points of the torus ℝ²/ℤ², all of them compared with all others.
class SquareTorusPoints {
 public:
  explicit SquareTorusPoints(double radius, bool is_lazy = false) : radius_(radius), is_lazy_(is_lazy) {}

  bool throw_dart(CounterRandom& random) {
    Vector<double, 2> x;
    for (double& coordinate : x) coordinate = random.next_unit();
    return insert(x);
  }
  void insert_about(std::uint32_t label, const Vector<double, 2>& place) {
    if (!is_lazy_) insert(sum(points[label], place));
  }
  void look_about(std::uint32_t label, std::vector<Vector<double, 2>>& around) const {
    const double reach = DiskSampling<2, SquareTorusPoints>::reach * radius_;
    around.clear();
    for (std::uint32_t other = 0; other < points.size(); ++other) {
      const auto offset = shortest(difference(points[other], points[label]));
      if (other != label && pairing(offset, offset) <= reach * reach) around.push_back(offset);
    }
  }
  [[nodiscard]] std::size_t size() const { return points.size(); }

  [[nodiscard]] double distance_from_nearest(const Vector<double, 2>& x, std::size_t first = 0) const {
    double squared = 1;
    for (std::size_t at = first; at < points.size(); ++at) {
      const auto offset = shortest(difference(x, points[at]));
      squared = std::min(squared, pairing(offset, offset));
    }
    return std::sqrt(squared);
  }
  static Vector<double, 2> shortest(Vector<double, 2> x) {
    for (double& coordinate : x) coordinate -= std::round(coordinate);
    return x;
  }

  std::vector<Vector<double, 2>> points;

 protected:
  double radius_;

 private:
  bool insert(Vector<double, 2> x) {
    for (double& coordinate : x) coordinate -= std::floor(coordinate);
    if (distance_from_nearest(x) < radius_) return false;
    points.push_back(x);
    return true;
  }

  bool is_lazy_;
};

/// The same points, as they are proposed by several threads.
class SquareTorusPointsInRounds : public SquareTorusPoints {
 public:
  struct Candidate {
    Vector<double, 2> place;
  };
  explicit SquareTorusPointsInRounds(double radius, bool overlooks = false)
      : SquareTorusPoints(radius), overlooks_(overlooks) {}

  [[nodiscard]] std::optional<Candidate> dart(CounterRandom& random) const {
    Vector<double, 2> x;
    for (double& coordinate : x) coordinate = random.next_unit();
    return candidate(x);
  }
  [[nodiscard]] std::optional<Candidate> candidate_about(std::uint32_t label, const Vector<double, 2>& place) const {
    return candidate(sum(points[label], place));
  }
  void begin_round() { first_new_ = points.size(); }
  bool insert(const Candidate& found) {
    if (!overlooks_ && distance_from_nearest(found.place, first_new_) < radius_) return false;
    points.push_back(found.place);
    return true;
  }
  [[nodiscard]] bool has_new_about(std::uint32_t label) const {
    return distance_from_nearest(points[label], first_new_) < 2.25 * radius_;
  }

 private:
  [[nodiscard]] std::optional<Candidate> candidate(Vector<double, 2> x) const {
    for (double& coordinate : x) coordinate -= std::floor(coordinate);
    if (distance_from_nearest(x) < radius_) return std::nullopt;
    return Candidate{x};
  }
  bool overlooks_;
  std::size_t first_new_ = 0;
};

constexpr double radius = 0.1;

TEST(DiskSampling, leaves_no_gap_and_keeps_the_distance) {
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    SquareTorusPoints points(radius);
    DiskSampling<2, SquareTorusPoints> sampling(points, Curvature::zero, radius);
    sampling.throw_darts(seed, no_progress());
    sampling.fill_gaps(seed, no_progress());
    EXPECT_GT(points.size(), 50U);
    // A grid so fine that a gap of a hundredth of the radius would have a place in it.
    double farthest = 0;
    constexpr int divisions = 500;
    for (int row = 0; row < divisions; ++row) {
      for (int column = 0; column < divisions; ++column) {
        const Vector<double, 2> x{row / static_cast<double>(divisions), column / static_cast<double>(divisions)};
        farthest = std::max(farthest, points.distance_from_nearest(x));
      }
    }
    EXPECT_LT(farthest, radius * (1 + 1e-6)) << seed;
    EXPECT_LE(farthest, sampling.covering_radius() + 1e-9);
    double nearest = 1;
    for (std::size_t at = 0; at < points.size(); ++at) {
      for (std::size_t other = 0; other < at; ++other) {
        const auto offset = SquareTorusPoints::shortest(difference(points.points[at], points.points[other]));
        nearest = std::min(nearest, std::sqrt(pairing(offset, offset)));
      }
    }
    EXPECT_GE(nearest, radius);
    sampling.measure(no_progress());
    EXPECT_NEAR(sampling.separation(), nearest, 1e-9);
  }
}

/// Darts alone leave gaps: that the first test finds none is the work of the second step.
TEST(DiskSampling, has_gaps_after_the_darts) {
  SquareTorusPoints points(radius);
  DiskSampling<2, SquareTorusPoints> sampling(points, Curvature::zero, radius);
  sampling.throw_darts(1, no_progress());
  sampling.measure(no_progress());
  EXPECT_GT(sampling.covering_radius(), radius);
}

TEST(DiskSampling, gives_up_where_gaps_stay) {
  SquareTorusPoints points(radius, true);
  DiskSampling<2, SquareTorusPoints> sampling(points, Curvature::zero, radius);
  sampling.throw_darts(1, no_progress());
  EXPECT_EQ(message_of<Rejection>([&] { sampling.fill_gaps(1, no_progress()); }),
            "maximal Poisson-disk sampling found gaps for 200 rounds");
}

/// Rounds have the points of one after the other, for any number of threads, in whichever round a cell is looked at.
TEST(DiskSampling, in_rounds_is_the_same_as_one_after_the_other) {
  static_assert(SampledInRounds<SquareTorusPointsInRounds> && !SampledInRounds<SquareTorusPoints>);
  for (const double small : {0.1, 0.03}) {
    SquareTorusPoints points(small);
    DiskSampling<2, SquareTorusPoints> sampling(points, Curvature::zero, small);
    sampling.throw_darts(7, no_progress());
    const std::size_t landed = points.size();
    sampling.fill_gaps(7, no_progress());
    EXPECT_GT(points.size(), landed);
    for (const unsigned threads : {1U, 2U, 4U}) {
      const ThreadLimit limit(threads);
      SquareTorusPointsInRounds same(small);
      DiskSampling<2, SquareTorusPointsInRounds> rounds(same, Curvature::zero, small);
      rounds.throw_darts(7, no_progress());
      EXPECT_EQ(same.points, std::vector(points.points.begin(), points.points.begin() + static_cast<long>(landed)));
      rounds.fill_gaps(7, no_progress());
      EXPECT_EQ(same.points, points.points) << small << " " << threads;
      EXPECT_EQ(rounds.covering_radius(), sampling.covering_radius());
    }
    // Without a look at new points they come too near to each other.
    SquareTorusPointsInRounds other(small, true);
    DiskSampling<2, SquareTorusPointsInRounds> careless(other, Curvature::zero, small);
    careless.throw_darts(7, no_progress());
    EXPECT_NE(other.points, std::vector(points.points.begin(), points.points.begin() + static_cast<long>(landed)));
  }
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
