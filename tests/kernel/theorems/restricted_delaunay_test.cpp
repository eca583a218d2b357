#include "kernel/theorems/restricted_delaunay.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "kernel/parallel/threads.hpp"
#include "kernel/run/chart_run.hpp"
#include "kernel/sample/submanifold_net.hpp"
#include "tests/kernel/manifold/submanifold/samples.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

using Triangles = std::vector<LabelSimplex<2>>;

/// A certified run on the unit sphere.
struct Sphere {
  ZeroSet zero_set = unit_sphere_in_space();
  Rational radius;
  SubmanifoldAtlas<2> atlas{zero_set, submanifold_net<2>(zero_set, radius, 1, no_progress()).charts, radius,
                            no_progress()};
  Triangles triangles;
  std::vector<Interval> positions;

  explicit Sphere(Rational sampling_radius) : radius(std::move(sampling_radius)) {
    RunRequest request;
    request.certify_model = false;
    const auto run =
        run_in_charts<2>(atlas, geometry_of<2>(atlas), measured_parameters(Dimension(2), 1), request, no_progress());
    triangles = run.complex.simplices();
    positions = graph_vertices<2>(atlas, run.points).positions;
  }
  [[nodiscard]] GraphVertices vertices() const { return {atlas.manifold(), atlas.charts(), positions, {}}; }
};

const Sphere& sphere() {
  static const Sphere result(ratio(1, 8));
  return result;
}

struct Found {
  Rational density;
  RestrictedDelaunay extrinsic;
  RestrictedDelaunay intrinsic;
};

Found found_with(const Triangles& triangles, std::optional<Rational> density = {}, const Sphere& on = sphere()) {
  const GraphVertices vertices = on.vertices();
  const auto triangulation = check_graph_triangulation<2>(vertices, triangles, no_progress());
  EXPECT_TRUE(triangulation.triangulates());
  const Rational& slope = on.atlas.slope();
  if (!density) density = graph_density<2>(vertices, triangles, triangulation, slope);
  const auto check = [&](GraphMetric metric) {
    return check_restricted_delaunay<2>(vertices, triangles, triangulation, slope, *density, metric, no_progress());
  };
  return {*density, check(GraphMetric::extrinsic), check(GraphMetric::intrinsic)};
}

TEST(RestrictedDelaunay, of_a_sphere_for_both_distances) {
  const Found found = found_with(sphere().triangles);
  EXPECT_TRUE(found.extrinsic.holds());
  EXPECT_LT(found.density, Rational(2) * sphere().radius);
  EXPECT_GT(found.extrinsic.boxes, sphere().atlas.size());
  // Curves are told from chords where the net is finer.
  EXPECT_FALSE(found.intrinsic.holds());
  const Sphere fine(ratio(1, 16));
  EXPECT_TRUE(found_with(fine.triangles, {}, fine).intrinsic.holds());
}

TEST(RestrictedDelaunay, is_not_what_has_the_other_diagonal_of_two_triangles) {
  // A triangulation of the sphere all the same: the two triangles at the edge with the flattest quadrilateral.
  Triangles triangles = sphere().triangles;
  const auto squared = [&](std::uint32_t a, std::uint32_t b) {
    double result = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double d = sphere().positions[3 * a + axis].lower() - sphere().positions[3 * b + axis].lower();
      result += d * d;
    }
    return result;
  };
  struct Flip {
    double ratio = 2;
    std::size_t first = 0, second = 0;
    std::array<std::uint32_t, 2> edge{}, apexes{};
  } best;
  for (std::size_t s = 0; s < triangles.size(); ++s) {
    for (std::size_t t = 0; t < s; ++t) {
      std::vector<std::uint32_t> common, rest;
      std::set_intersection(triangles[s].begin(), triangles[s].end(), triangles[t].begin(), triangles[t].end(),
                            std::back_inserter(common));
      if (common.size() != 2) continue;
      std::set_symmetric_difference(triangles[s].begin(), triangles[s].end(), triangles[t].begin(), triangles[t].end(),
                                    std::back_inserter(rest));
      const double quotient = squared(rest[0], rest[1]) / squared(common[0], common[1]);
      if (quotient < best.ratio) best = {quotient, s, t, {common[0], common[1]}, {rest[0], rest[1]}};
    }
  }
  for (const auto& [place, end] : {std::pair{best.first, best.edge[0]}, std::pair{best.second, best.edge[1]}}) {
    triangles[place] = {best.apexes[0], best.apexes[1], end};
    std::sort(triangles[place].begin(), triangles[place].end());
  }
  std::sort(triangles.begin(), triangles.end());
  const Found found = found_with(triangles);
  EXPECT_FALSE(found.extrinsic.failures.empty());
  EXPECT_FALSE(found.intrinsic.failures.empty());
  std::vector<std::uint32_t> concerned{best.edge[0], best.edge[1], best.apexes[0], best.apexes[1]};
  for (const Label label : found.extrinsic.failures)
    EXPECT_NE(std::find(concerned.begin(), concerned.end(), label.value), concerned.end());
}

TEST(RestrictedDelaunay, asks_for_discs_in_patches) {
  const Rational patch = sphere().atlas.patch_radius();
  const Found found = found_with(sphere().triangles, patch);
  EXPECT_EQ(found.extrinsic.failures.size(), sphere().atlas.size());
  EXPECT_EQ(found.intrinsic.failures.size(), sphere().atlas.size());
}

TEST(RestrictedDelaunay, does_not_depend_on_threads) {
  const Found all = found_with(sphere().triangles);
  const ThreadLimit limit(1);
  const Found one = found_with(sphere().triangles);
  EXPECT_EQ(all.density, one.density);
  EXPECT_EQ(all.extrinsic.boxes, one.extrinsic.boxes);
  EXPECT_EQ(all.intrinsic.boxes, one.intrinsic.boxes);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
