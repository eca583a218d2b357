#include "kernel/stars/rounded_balls.hpp"

#include <gtest/gtest.h>

#include <functional>

#include "kernel/stars/chart_complex.hpp"
#include "tests/kernel/stars/certified_samples.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

/// Calls `visit` with every simplex of the star of i in the chart of a neighbour, and with what intervals find of it.
template <int m>
void for_each_simplex(ChartView<m>& view, Label i,
                      const std::function<void(const PlaceSimplex<m>&, const LocalMargins&)>& visit) {
  const auto star = chart_star<m>(view, i).star;
  view.look_by_halves(Label(star.simplices.front().front().index), 9);
  for (const auto& others : star.simplices) {
    LabelSimplex<m> labels;
    for (std::size_t at = 0; at < m; ++at) labels[at] = others[at].index;
    labels[m] = i.value;
    const auto places = places_of<m>(view, labels);
    if (!places) continue;
    LocalMargins margins;
    std::size_t witness = 0;
    if (!chart_simplex_failure<m>(view, *places, 0, margins, witness)) visit(*places, margins);
  }
}

/// A little worse than they are, by more than doubles are wrong by. Other points have to have a power above δ(2r + δ),
/// which a greater radius r makes more of: so the protection δ is lowered by more than that. Thickness is compared in
/// polynomials of degree 2m, whose errors are those of the longest edges that there may be.
LocalMargins relaxed(LocalMargins margins) {
  margins.protection *= 1 - 1e-4;
  margins.thickness *= 1 - 1e-3;
  margins.circumradius *= 1 + 1e-6;
  margins.reach *= 1 + 1e-6;
  return margins;
}

/// Each margin by itself: with all of them a little worse than they are, the simplex meets them; with any one of them a
/// little better, and all others a little worse, it does not.
template <int m>
int expect_told_by_each_margin(ChartView<m>& view, std::uint32_t step) {
  RoundedBalls<m> balls;
  const auto sampling_radius = approximate_double(view.atlas().sampling_radius(Label(0)));
  int told = 0;
  for (std::uint32_t i = 0; i < view.atlas().size(); i += step) {
    for_each_simplex<m>(view, Label(i), [&](const auto& places, const LocalMargins& margins) {
      // Where quantities are of the order of their errors, nothing is known.
      if (margins.protection < 0.01 * sampling_radius || margins.thickness < 0.05) return;
      const LocalMargins met = relaxed(margins);
      balls.look(view, met);
      EXPECT_TRUE(balls.are_met_by(places));
      const auto refuses = [&](double LocalMargins::*margin, double factor) {
        LocalMargins wanted = met;
        wanted.*margin = margins.*margin * factor;
        balls.compare_with(wanted);
        return !balls.are_met_by(places);
      };
      // Intervals look no farther than half a sampling radius beyond a ball: then the protection may be better.
      if (margins.protection < 0.49 * sampling_radius) {
        EXPECT_TRUE(refuses(&LocalMargins::protection, 1 + 1e-4));
        ++told;
      }
      EXPECT_TRUE(refuses(&LocalMargins::thickness, 1 + 1e-6));
      EXPECT_TRUE(refuses(&LocalMargins::circumradius, 1 - 1e-6));
      EXPECT_TRUE(refuses(&LocalMargins::reach, 1 - 1e-6));
    });
  }
  return told;
}

TEST(RoundedBalls, tell_from_all_margins_whether_they_are_met) {
  const SphereSample sphere = perturbed_sphere();
  ChartView<2> view(sphere.atlas, sphere.run.points, unit_sphere);
  EXPECT_GT(expect_told_by_each_margin<2>(view, 10), 30);
}

TEST(RoundedBalls, tell_in_space_from_all_margins_whether_they_are_met) {
  const CurvedPatch<3> atlas(Curvature::positive, farthest_point_net<3>(Curvature::positive, 0.25, 20000, 1),
                             ratio(1, 4));
  ChartView<3> view(atlas, atlas.net(), unit_sphere);
  EXPECT_GT(expect_told_by_each_margin<3>(view, 100), 30);
}

/// What intervals refuse is not let through: with margins that ask for next to nothing, balls that are not empty.
TEST(RoundedBalls, refuse_balls_with_a_point_inside) {
  const SphereSample sphere = perturbed_sphere();
  ChartView<2> view(sphere.atlas, sphere.run.points, unit_sphere);
  view.look_by_halves(Label(7), 9);
  RoundedBalls<2> balls;
  // All but the end of the view lets balls reach so far.
  balls.look(view, {1e-9, 1e-9, 0.39, 3.9});
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
  for_each_simplex<2>(view, Label(7), [&](const auto& places, const LocalMargins& margins) {
    LocalMargins wanted = relaxed(margins);
    balls.look(view, wanted);
    EXPECT_TRUE(balls.are_met_by(places));
    // No ball is that far from the end of the view.
    wanted.protection = view.complete_radius(LocalCoordinates::chart);
    balls.compare_with(wanted);
    EXPECT_FALSE(balls.are_met_by(places));
    // A ball larger than doubles reckon with.
    wanted = relaxed(margins);
    wanted.circumradius = 1;
    balls.compare_with(wanted);
    EXPECT_FALSE(balls.are_met_by(places));
    ++ends;
  });
  EXPECT_GT(ends, 3);
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
