#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "kernel/manifold/any_manifold.hpp"
#include "kernel/number/middle.hpp"
#include "kernel/run/chart_run.hpp"
#include "kernel/sample/submanifold_net.hpp"
#include "kernel/theorems/graph_triangulation.hpp"
#include "tests/oracles/label_complex.hpp"

// Runs on submanifolds for other software to look at.
namespace delcert::test {

/// What the command `certify` computes on a zero set up to level 5, with the seed 1.
template <int m>
struct SubmanifoldSample {
  ZeroSet zero_set;
  Rational radius;
  SubmanifoldAtlas<m> atlas;
  LabelComplex<m> simplices;
  GraphVertices vertices;
  GraphTriangulation<m> triangulation;

  SubmanifoldSample(const std::string& manifold, const Rational& sampling_radius)
      : SubmanifoldSample(ZeroSet(std::get<SubmanifoldDescription>(find_any_manifold(manifold))), sampling_radius) {}
  SubmanifoldSample(ZeroSet manifold, const Rational& sampling_radius)
      : zero_set(std::move(manifold)),
        radius(sampling_radius),
        atlas(zero_set, submanifold_net<m>(zero_set, radius, 1, no_progress()).charts, radius, no_progress()),
        vertices{atlas.manifold(), atlas.charts(), {}, {}} {
    RunRequest request;
    request.certify_model = false;
    const auto run =
        run_in_charts<m>(atlas, geometry_of<m>(atlas), measured_parameters(Dimension(m), 1), request, no_progress());
    EXPECT_TRUE(run.is_certified());
    simplices = run.complex.simplices();
    vertices.positions = graph_vertices<m>(atlas, run.points).positions;
    triangulation = check_graph_triangulation<m>(vertices, simplices, no_progress());
    EXPECT_TRUE(triangulation.triangulates());
  }
  SubmanifoldSample(const SubmanifoldSample&) = delete;
  SubmanifoldSample& operator=(const SubmanifoldSample&) = delete;

  [[nodiscard]] std::size_t size() const { return atlas.size(); }
  /// The middle of the enclosure of p′, in doubles.
  [[nodiscard]] std::vector<double> position(std::uint32_t label) const {
    std::vector<double> result;
    for (std::size_t axis = 0; axis < zero_set.ambient(); ++axis) {
      result.push_back(middle_of(vertices.position(label)[axis]));
    }
    return result;
  }
};

}  // namespace delcert::test
