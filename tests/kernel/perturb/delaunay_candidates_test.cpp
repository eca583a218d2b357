#include "kernel/perturb/delaunay_candidates.hpp"

#include <cmath>

#include "kernel/sample/poisson_disk.hpp"
#include "tests/kernel/perturb/scene.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

Scene<2> scene_with_clearance(std::uint64_t seed) {
  const Rational radius = ratio(1, 8);
  auto scene = any_scene<2>(cubic_torus<2>(), poisson_disk_net<2>(cubic_torus<2>(), radius, seed, no_progress()),
                            radius, ratio(1, 50), seed);
  scene.parameters.clearance = ratio(1, 20);
  return scene;
}

/// From the definition, in doubles: the balls of triangles of placed points, shrunk, that no point is inside of.
std::vector<Ball<2>> slow_spheres(const Scene<2>& scene, std::uint32_t i) {
  std::vector<Ball<2>> result;
  auto wide = scene;
  wide.parameters.tolerance = scene.parameters.clearance;  // which spheres are within reach
  for (const auto& set : wide.candidates(i)) {
    if (set.size() != 3) continue;
    const auto ball = *wide.ball(set);
    const double radius = std::sqrt(approximate_double(ball.squared_radius));
    const double unit = approximate_double(scene.sampling_radius);
    bool is_empty = true;
    for (std::uint32_t other = 0; other < scene.net.size(); ++other) {
      if (other == i) continue;
      const auto& where = scene.placed[other] ? scene.points : scene.net;
      const double slack = unit * (0.05 + (scene.placed[other] ? 0 : 0.25));
      if (radius <= slack) continue;
      const auto inside = lifts_within<2>(scene.space, {where[other]}, ball.centre, Rational::exactly(radius - slack));
      is_empty = is_empty && inside.empty();
    }
    if (is_empty) result.push_back(ball);
  }
  return result;
}

TEST(DelaunayCandidates, are_those_with_nearly_empty_balls) {
  std::size_t spheres = 0;
  std::size_t candidates = 0;
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    const auto scene = scene_with_clearance(seed);
    const auto atlas = scene.atlas();
    const PointSet<2> points(scene.points);
    CandidateTest<2> test(atlas, points, scene.placed, scene.parameters);
    test.look_around(reach_of_delaunay_candidates(scene.parameters));
    DelaunayCandidates<2> delaunay(scene.parameters);
    for (std::uint32_t i = 2; i < scene.net.size(); i += 3) {
      {
        const FilterGuard guard;
        test.prepare(Label(i));
        delaunay.prepare(scene.sampling_radius, test);
      }
      const auto expected = slow_spheres(scene, i);
      EXPECT_EQ(delaunay.size(), expected.size());
      spheres += expected.size();
      candidates += test.candidate_count();
      const auto x = sum(scene.net[i], Vector<Rational, 2>{ratio(1, 100), ratio(-1, 80)});
      double least = std::numeric_limits<double>::infinity();
      for (const auto& ball : expected) {
        const double distance = std::sqrt(approximate_double(squared_distance<2>(scene.space, x, ball.centre)));
        least = std::min(least, std::abs(distance - std::sqrt(approximate_double(ball.squared_radius))));
      }
      const double clearance = [&] {
        const FilterGuard guard;
        Vector<Filter, 2> enclosure;
        for (std::size_t axis = 0; axis < 2; ++axis) enclosure[axis] = scalar_from<Filter>(x[axis]);
        return delaunay.clearance(enclosure);
      }();
      if (expected.empty()) {
        EXPECT_EQ(clearance, least);
      } else {
        EXPECT_NEAR(clearance, least, 1e-12);
      }
    }
  }
  EXPECT_GT(spheres, 10U);
  EXPECT_GT(candidates, 3 * spheres);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
