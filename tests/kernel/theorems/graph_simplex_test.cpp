#include "kernel/theorems/graph_simplex.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/kernel/theorems/torus_mesh.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

template <int m>
std::vector<GraphSimplex<m>> measures_of(const Mesh<m>& mesh, double displacement) {
  const GraphVertices vertices = mesh.vertices();
  const RoundingGuard guard;
  GraphSimplexCheck<m> check(vertices);
  std::vector<GraphSimplex<m>> result;
  for (const LabelSimplex<m>& simplex : mesh.simplices) result.push_back(check.measure(simplex, displacement));
  return result;
}

TEST(GraphSimplex, of_a_circle_is_as_far_from_it_as_arcs_are) {
  const Mesh<1> mesh = circle_mesh(10);
  const auto measures = measures_of<1>(mesh, 0.02);
  for (std::size_t at = 0; at < measures.size(); ++at) {
    const GraphSimplex<1>& one = measures[at];
    ASSERT_FALSE(one.cause) << at << description_of(*one.cause);
    // f = |x|² − 1 is −ℓ²/4 at the middle of an edge of length ℓ, which is 1 − √(1 − ℓ²/4) from the circle.
    const auto [v, w] = mesh.simplices[at];
    const double dx = approximate_double(mesh.points[v][0] - mesh.points[w][0]);
    const double dy = approximate_double(mesh.points[v][1] - mesh.points[w][1]);
    const double edge = std::sqrt(dx * dx + dy * dy);
    EXPECT_NEAR(one.edge, edge, 1e-12);
    const double gap = 1 - std::sqrt(1 - edge * edge / 4);
    EXPECT_GE(one.displacement, gap * (1 - 1e-9));
    EXPECT_LE(one.displacement, gap * 1.4);
    for (const double room : one.below_lid) EXPECT_GT(room, 0.06);
    EXPECT_LE(one.contraction, 0.1);
    for (const double altitude : one.altitudes) {
      EXPECT_LE(altitude, edge);
      EXPECT_GE(altitude, edge * 0.98);
    }
  }
}

TEST(GraphSimplex, contains_in_its_displacement_what_newton_finds_along_fibres) {
  const Mesh<2> mesh = torus_mesh(20, 8);
  const GraphVertices vertices = mesh.vertices();
  FormulaEvaluation<double> f(mesh.zero_set.map());
  const auto measures = measures_of<2>(mesh, 0.04);
  std::size_t compared = 0;
  double least_ratio = 100;
  for (std::size_t at = 0; at < measures.size(); at += 17) {
    ASSERT_FALSE(measures[at].cause) << description_of(*measures[at].cause);
    // The barycentre moved along the barycentre of the fibres.
    std::vector<double> x(3), direction(3);
    for (const std::uint32_t v : mesh.simplices[at]) {
      const auto& chart = mesh.charts[v].enclosed();
      for (std::size_t axis = 0; axis < 3; ++axis) {
        x[axis] += approximate_double(mesh.points[v][axis]) / 3;
        direction[axis] += chart.at(axis, 2).lower() * chart.preconditioner[0].lower() / 3;
      }
    }
    double s = 0;
    for (int step = 0; step < 20; ++step) {
      const std::vector<double> place{x[0] + s * direction[0], x[1] + s * direction[1], x[2] + s * direction[2]};
      double value = 0;
      std::vector<double> slope(3);
      ASSERT_TRUE(f.first(place.data(), &value, slope.data()));
      s -= value / (slope[0] * direction[0] + slope[1] * direction[1] + slope[2] * direction[2]);
    }
    const double length =
        std::sqrt(direction[0] * direction[0] + direction[1] * direction[1] + direction[2] * direction[2]);
    EXPECT_LE(std::fabs(s), measures[at].shift * (1 + 1e-9));
    EXPECT_LE(std::fabs(s) * length, measures[at].displacement * (1 + 1e-9));
    if (std::fabs(s) > 1e-4) least_ratio = std::min(least_ratio, measures[at].shift / std::fabs(s));
    ++compared;
  }
  EXPECT_GE(compared, 200U);
  // The bound is not idle.
  EXPECT_LE(least_ratio, 3);
}

TEST(GraphSimplex, has_the_contraction_that_differences_find) {
  // E_iᵀ(H − id) along edges from a vertex, H by Newton: its slope is at most γ.
  const Mesh<2> mesh = torus_mesh(20, 8);
  const auto measures = measures_of<2>(mesh, 0.04);
  FormulaEvaluation<double> f(mesh.zero_set.map());
  double greatest_share = 0;
  for (std::size_t at = 0; at < measures.size(); at += 31) {
    const LabelSimplex<2>& simplex = mesh.simplices[at];
    const auto image = [&](const std::array<double, 3>& weights) {
      std::array<double, 3> x{}, direction{};
      for (std::size_t v = 0; v < 3; ++v) {
        const auto& chart = mesh.charts[simplex[v]].enclosed();
        for (std::size_t axis = 0; axis < 3; ++axis) {
          x[axis] += weights[v] * approximate_double(mesh.points[simplex[v]][axis]);
          direction[axis] += weights[v] * chart.at(axis, 2).lower() * chart.preconditioner[0].lower();
        }
      }
      double s = 0;
      for (int step = 0; step < 20; ++step) {
        const std::array<double, 3> place{x[0] + s * direction[0], x[1] + s * direction[1], x[2] + s * direction[2]};
        double value = 0;
        std::array<double, 3> slope{};
        EXPECT_TRUE(f.first(place.data(), &value, slope.data()));
        s -= value / (slope[0] * direction[0] + slope[1] * direction[1] + slope[2] * direction[2]);
      }
      return std::pair(x, std::array<double, 3>{s * direction[0], s * direction[1], s * direction[2]});
    };
    const std::array<std::array<double, 3>, 3> places{{{0.2, 0.3, 0.5}, {0.6, 0.1, 0.3}, {0.9, 0.05, 0.05}}};
    for (std::size_t i = 0; i < 3; ++i) {
      const auto& chart = mesh.charts[simplex[i]].enclosed();
      for (std::size_t a = 0; a < 3; ++a) {
        const auto [x, moved] = image(places[a]);
        const auto [y, also_moved] = image(places[(a + 1) % 3]);
        double chord = 0, change = 0;
        for (std::size_t row = 0; row < 2; ++row) {
          double along = 0, by = 0;
          for (std::size_t axis = 0; axis < 3; ++axis) {
            along += chart.at(axis, row).lower() * (x[axis] - y[axis]);
            by += chart.at(axis, row).lower() * (moved[axis] - also_moved[axis]);
          }
          chord += along * along;
          change += by * by;
        }
        const double share = std::sqrt(change / chord) / measures[at].contraction;
        EXPECT_LE(share, 1 + 1e-6);
        greatest_share = std::max(greatest_share, share);
      }
    }
  }
  EXPECT_GE(greatest_share, 0.05);
}

TEST(GraphSimplex, says_how_much_more_than_it_swings_its_altitudes_are) {
  const Mesh<2> mesh = torus_mesh(20, 8);
  const auto measures = measures_of<2>(mesh, 0.04);
  for (std::size_t at = 0; at < measures.size(); at += 7) {
    const GraphSimplex<2>& one = measures[at];
    double least = 1;
    for (std::size_t v = 0; v < 3; ++v) {
      const EnclosedChart<Interval>& chart = mesh.charts[mesh.simplices[at][v]].enclosed();
      double longest = 0;
      for (const std::uint32_t w : mesh.simplices[at]) {
        double squared = 0;
        for (std::size_t column = 0; column < 2; ++column) {
          double along = 0;
          for (std::size_t axis = 0; axis < 3; ++axis) {
            along += chart.at(axis, column).lower() *
                     approximate_double(mesh.points[w][axis] - mesh.points[mesh.simplices[at][v]][axis]);
          }
          squared += along * along;
        }
        longest = std::max(longest, std::sqrt(squared));
      }
      EXPECT_LT(one.rooms[v], one.altitudes[v]);
      // γ is that of the vertex, and the contraction the greatest.
      least = std::min(least, one.rooms[v] - (one.altitudes[v] - one.contraction * longest));
    }
    EXPECT_NEAR(least, 0, 1e-10);
  }
}

TEST(GraphSimplex, says_why_it_is_not_one) {
  const auto first_cause = [](const Mesh<2>& mesh, double displacement) {
    return measures_of<2>(mesh, displacement)[0].cause;
  };
  Mesh<2> mesh = torus_mesh(20, 8);
  mesh.simplices.resize(1);
  EXPECT_FALSE(first_cause(mesh, 0.04));
  EXPECT_EQ(first_cause(mesh, 1e-6), GraphCause::displacement);
  EXPECT_EQ(first_cause(mesh, 2), GraphCause::fibre);
  Mesh<2> narrow = mesh;
  for (const std::uint32_t label : mesh.simplices[0])
    narrow.charts[label].set_size(Rational(1) / Rational(8), Rational(1) / Rational(2));
  EXPECT_EQ(first_cause(narrow, 0.04), GraphCause::outside);
  Mesh<2> low = mesh;
  for (const std::uint32_t label : mesh.simplices[0])
    low.charts[label].set_size(Rational(1), Rational(1) / Rational(32));
  EXPECT_EQ(first_cause(low, 0.04), GraphCause::outside);
  // Between ω and 3ω from the lid: level 5, but not 5i.
  const auto under_lid = [](const Mesh<2>& some) { return measures_of<2>(some, 0.04)[0]; };
  Mesh<2> lower = mesh;
  for (const std::uint32_t label : mesh.simplices[0])
    lower.charts[label].set_size(Rational(1), Rational(7) / Rational(64));
  EXPECT_FALSE(under_lid(lower).cause);
  for (const double room : under_lid(lower).below_lid) EXPECT_LT(room, 0.12);
  for (const double room : under_lid(mesh).below_lid) EXPECT_GT(room, 0.12);
  Mesh<2> thin = mesh;
  thin.points[mesh.simplices[0][2]] = mesh.points[mesh.simplices[0][1]];
  EXPECT_EQ(first_cause(thin, 0.04), GraphCause::degenerate);
  // A chart whose fibre is another's: W changes much across the simplex.
  Mesh<2> turned = mesh;
  const std::uint32_t last = mesh.simplices[0][2];
  ChartData data = mesh.charts[last].data();
  data.preconditioner[0] = -data.preconditioner[0];
  turned.charts[last] = TangentChart(data, 2);
  EXPECT_EQ(first_cause(turned, 0.04), GraphCause::fibre);
}

TEST(GraphSimplex, far_from_the_manifold_needs_a_larger_displacement) {
  const Mesh<2> mesh = torus_mesh(20, 8);
  GraphVertices vertices = mesh.vertices();
  vertices.residuals.assign(mesh.points.size(), 0);
  const RoundingGuard guard;
  GraphSimplexCheck<2> exact(vertices);
  const double shift = exact.measure(mesh.simplices[0], 0.04).shift;
  vertices.residuals.assign(mesh.points.size(), 0.25);
  GraphSimplexCheck<2> residual(vertices);
  const double larger = residual.measure(mesh.simplices[0], 0.04).shift;
  EXPECT_GE(larger, shift + 0.25);
  EXPECT_LE(larger, shift + 0.6);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
