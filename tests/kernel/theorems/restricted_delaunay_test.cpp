#include "kernel/theorems/restricted_delaunay.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "kernel/parallel/threads.hpp"
#include "kernel/run/chart_run.hpp"
#include "kernel/sample/submanifold_net.hpp"
#include "tests/kernel/manifold/submanifold/mesh_samples.hpp"
#include "tests/kernel/manifold/submanifold/samples.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

using Triangles = std::vector<LabelSimplex<2>>;

/// A certified run on the unit sphere, or on a mesh.
template <class Manifold>
struct RunOn {
  Manifold manifold;
  Rational radius;
  SubmanifoldAtlas<2> atlas{manifold, submanifold_net<2>(manifold, radius, 1, no_progress()).charts, radius,
                            no_progress()};
  Triangles triangles;
  std::vector<Interval> positions;

  RunOn(Manifold of, Rational sampling_radius) : manifold(std::move(of)), radius(std::move(sampling_radius)) {
    RunRequest request;
    request.certify_model = false;
    const auto run =
        run_in_charts<2>(atlas, geometry_of<2>(atlas), measured_parameters(Dimension(2), 1), request, no_progress());
    triangles = run.complex.simplices();
    positions = graph_vertices<2>(atlas, run.points).positions;
  }
  [[nodiscard]] GraphVertices vertices() const { return {atlas.manifold(), atlas.charts(), positions, {}}; }
};

struct Sphere : RunOn<ZeroSet> {
  explicit Sphere(const Rational& sampling_radius) : RunOn(unit_sphere_in_space(), sampling_radius) {}
};

const Sphere& sphere() {
  static const Sphere result(ratio(1, 8));
  return result;
}

struct Found {
  GraphDensity density;
  RestrictedDelaunay extrinsic;
  RestrictedDelaunay intrinsic;
};

template <class On = Sphere>
Found found_with(const Triangles& triangles, std::optional<double> reach = {}, const On& on = sphere()) {
  const GraphVertices vertices = on.vertices();
  const auto triangulation = check_graph_triangulation<2>(vertices, triangles, no_progress());
  EXPECT_TRUE(triangulation.triangulates());
  const Rational& slope = on.atlas.slope();
  GraphDensity density = graph_density<2>(vertices, triangles, triangulation, slope);
  if (reach) density.reaches.assign(density.reaches.size(), *reach);
  const auto check = [&](GraphMetric metric) {
    return check_restricted_delaunay<2>(vertices, triangles, triangulation, slope, density, metric, no_progress());
  };
  return {density, check(GraphMetric::extrinsic), check(GraphMetric::intrinsic)};
}

TEST(RestrictedDelaunay, of_a_sphere_for_both_distances) {
  const Found found = found_with(sphere().triangles);
  EXPECT_TRUE(found.extrinsic.holds());
  EXPECT_LT(found.density.density, Rational(2) * sphere().radius);
  EXPECT_GT(found.extrinsic.boxes, sphere().atlas.size());
  EXPECT_TRUE(found.intrinsic.holds());
}

TEST(RestrictedDelaunay, of_a_coarse_net_by_how_a_hypersurface_bends) {
  const Sphere coarse(ratio(1, 5));
  EXPECT_TRUE(found_with(coarse.triangles, {}, coarse).intrinsic.holds());
  // By two equations it is known of curves only what they are at most longer than their chords by.
  const RunOn<ZeroSet> other(
      zero_set("sphere", {"x", "y", "z", "w"}, {"x^2 + y^2 + z^2 - 1", "w"}, std::vector<Rational>(4, ratio(3, 2))),
      ratio(1, 5));
  const Found found = found_with(other.triangles, {}, other);
  EXPECT_TRUE(found.extrinsic.holds());
  EXPECT_FALSE(found.intrinsic.holds());
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

TEST(RestrictedDelaunay, of_a_mesh_for_both_distances_where_facets_are_small) {
  const RunOn<PolyhedralMesh> fine(polyhedral_sphere(72), ratio(1, 10));
  const Found found = found_with(fine.triangles, {}, fine);
  EXPECT_TRUE(found.extrinsic.holds());
  EXPECT_TRUE(found.intrinsic.holds()) << found.intrinsic.failures.size() << " of " << fine.atlas.size();
  // Where slopes jump by more, curves may be longer than that.
  const RunOn<PolyhedralMesh> coarse(polyhedral_sphere(24), ratio(1, 8));
  const Found jumping = found_with(coarse.triangles, {}, coarse);
  EXPECT_TRUE(jumping.extrinsic.holds());
  EXPECT_FALSE(jumping.intrinsic.failures.empty());
}

TEST(RestrictedDelaunay, density_knows_that_patches_are_flat_in_the_middle) {
  const GraphVertices vertices = sphere().vertices();
  const auto triangulation = check_graph_triangulation<2>(vertices, sphere().triangles, no_progress());
  const auto with = [&](const Rational& slope) {
    return graph_density<2>(vertices, sphere().triangles, triangulation, slope).density;
  };
  // The circumradii, and what is moved sideways; were the simplices as steep as the rims, 1.4 times as much.
  EXPECT_LT(with(Rational(1)), with(Rational(0)) * ratio(5, 4));
  EXPECT_GT(with(Rational(1)), with(Rational(0)));
}

TEST(RestrictedDelaunay, reaches_are_those_of_simplices_near_by) {
  const GraphDensity density = found_with(sphere().triangles).density;
  const auto [least, most] = std::minmax_element(density.reaches.begin(), density.reaches.end());
  EXPECT_LT(*least, 0.9 * *most);
  EXPECT_LE(Rational::exactly(*most), density.density * (Rational(1) + Rational::power_of_two(-40)));
  // Each point of a triangle is as near to one of its vertices as the reach of that vertex.
  const auto& x = sphere().positions;
  for (const LabelSimplex<2>& triangle : sphere().triangles) {
    double edge = 0;
    double reach = 1;
    for (std::size_t k = 0; k < 3; ++k) {
      double squared = 0;
      for (std::size_t axis = 0; axis < 3; ++axis)
        squared += std::pow(x[3 * triangle[k] + axis].lower() - x[3 * triangle[(k + 1) % 3] + axis].lower(), 2);
      edge = std::max(edge, std::sqrt(squared));
      reach = std::min(reach, density.reaches[triangle[k]]);
    }
    EXPECT_LT(edge / 2, reach);
  }
}

TEST(RestrictedDelaunay, asks_for_discs_in_patches) {
  const double patch = approximate_double(sphere().atlas.patch_radius());
  const Found found = found_with(sphere().triangles, patch);
  EXPECT_EQ(found.extrinsic.failures.size(), sphere().atlas.size());
  EXPECT_EQ(found.intrinsic.failures.size(), sphere().atlas.size());
}

TEST(RestrictedDelaunay, does_not_depend_on_threads) {
  const Found all = found_with(sphere().triangles);
  const ThreadLimit limit(1);
  const Found one = found_with(sphere().triangles);
  EXPECT_EQ(all.density.density, one.density.density);
  EXPECT_EQ(all.density.reaches, one.density.reaches);
  EXPECT_EQ(all.extrinsic.boxes, one.extrinsic.boxes);
  EXPECT_EQ(all.intrinsic.boxes, one.intrinsic.boxes);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
