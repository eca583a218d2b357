#include "kernel/stars/rounded_balls.hpp"

#include <gtest/gtest.h>

#include <functional>

#include "kernel/stars/chart_complex.hpp"
#include "tests/kernel/stars/certified_samples.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

/// Calls `visit` with every simplex of the neighbours' stars in the chart of each of these labels, and with what
/// intervals find of it, if it is certified.
template <int m>
void for_each_simplex(ChartView<m>& view, const ChartComplex<m>& complex, int half_reach, std::uint32_t step,
                      const std::function<void(const PlaceSimplex<m>&, const std::optional<LocalMargins>&)>& visit) {
  for (std::uint32_t chart = 0; chart < complex.size(); chart += step) {
    view.look_by_halves(Label(chart), half_reach);
    for (const Label i : complex.neighbours(Label(chart))) {
      for (const auto& others : complex.chart_star(i).simplices) {
        LabelSimplex<m> labels;
        for (std::size_t at = 0; at < m; ++at) labels[at] = others[at].index;
        labels[m] = i.value;
        const auto places = places_of<m>(view, labels);
        if (!places) continue;
        LocalMargins margins;
        std::size_t witness = 0;
        const bool fails = chart_simplex_failure<m>(view, *places, 0, margins, witness, 8).has_value();
        visit(*places, fails ? std::nullopt : std::optional(margins));
      }
    }
  }
}

/// A little worse than they are.
LocalMargins relaxed(LocalMargins margins) {
  margins.protection *= 1 - 1e-6;
  margins.thickness *= 1 - 1e-6;
  margins.circumradius *= 1 + 1e-6;
  margins.reach *= 1 + 1e-6;
  return margins;
}

/// What intervals refuse is not let through: with margins that ask for next to nothing, balls that are not empty.
TEST(RoundedBalls, refuse_balls_with_a_point_inside) {
  const SphereSample sphere = perturbed_sphere();
  ChartView<2> view(sphere.atlas, sphere.run.points, unit_sphere);
  view.look_by_halves(Label(7), 9);
  RoundedBalls<2> balls;
  balls.look(view, {1e-9, 1e-9, 0.39, 0.8});
  int refused = 0;
  int met = 0;
  for (std::uint32_t a = 0; a < view.size(); ++a) {
    for (std::uint32_t b = a + 1; b < view.size(); ++b) {
      for (std::uint32_t c = b + 1; c < view.size(); ++c) {
        if (!balls.are_met_by({a, b, c})) {
          ++refused;
          continue;
        }
        ++met;
        LocalMargins margins;
        std::size_t witness = 0;
        EXPECT_FALSE(chart_simplex_failure<2>(view, {a, b, c}, 1e-9, margins, witness, 8).has_value());
      }
    }
  }
  EXPECT_GT(refused, 1000);
  EXPECT_GT(met, 10);
  EXPECT_FALSE(balls.are_met_by({0, 0, 1})) << "degenerate";
}

/// The fall-back: nothing is said where doubles are of no use.
TEST(RoundedBalls, say_nothing_where_the_view_ends_or_positions_are_wide) {
  const SphereSample sphere = perturbed_sphere();
  ChartView<2> view(sphere.atlas, sphere.run.points, unit_sphere);
  RoundedBalls<2> balls;
  int ends = 0;
  for_each_simplex<2>(view, sphere.run.complex, 9, 50, [&](const auto& places, const auto& margins) {
    if (!margins) return;
    LocalMargins wanted = relaxed(*margins);
    balls.look(view, wanted);
    EXPECT_TRUE(balls.are_met_by(places));
    // No ball is that far from the end of the view.
    wanted.protection = view.complete_radius(LocalCoordinates::chart);
    balls.compare_with(wanted);
    EXPECT_FALSE(balls.are_met_by(places));
    // A ball larger than doubles reckon with.
    wanted = relaxed(*margins);
    wanted.circumradius = 1;
    balls.compare_with(wanted);
    EXPECT_FALSE(balls.are_met_by(places));
    ++ends;
  });
  EXPECT_GT(ends, 10);
  // A frame that is not Cartesian.
  std::vector<Vector<Rational, 2>> points;
  for (long a = 0; a < 12; ++a) {
    for (long b = 0; b < 12; ++b) points.push_back({ratio(a, 12), ratio(b, 12) + ratio((a * 7 + b * 3) % 5, 900)});
  }
  const FlatAtlas<2> atlas(hexagonal_torus(), PointSet<2>(points), ratio(1, 10));
  ChartView<2> skewed(atlas, atlas.net(), {Curvature::zero, ratio(1, 2), 4});
  skewed.look_by_halves(Label(0), 6);
  balls.look(skewed, {1e-9, 1e-9, 0.2, 0.29});
  for (std::uint32_t a = 0; a + 2 < skewed.size(); ++a) EXPECT_FALSE(balls.are_met_by({a, a + 1, a + 2}));
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
