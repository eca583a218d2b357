#include "kernel/stars/stable_stars.hpp"

#include <gtest/gtest.h>

#include "tests/kernel/manifold/exhaustive.hpp"
#include "tests/kernel/stars/certified_samples.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

template <int m>
ChartComplex<m> stars_of(const Atlas<m>& atlas, const PointSet<m>& points, const ModelGeometry& geometry) {
  ChartView<m> view(atlas, points, geometry);
  std::vector<ChartStar<m>> stars;
  std::vector<bool> interior;
  for (std::uint32_t index = 0; index < atlas.size(); ++index) {
    interior.push_back(atlas.is_interior(Label(index)));
    stars.push_back(interior.back() ? chart_star<m>(view, Label(index)).star : ChartStar<m>{Label(index), {}});
  }
  return ChartComplex<m>(std::move(stars), interior);
}

FlatAtlas<2> displaced_lattice() {
  std::vector<Vector<Rational, 2>> points;
  for (long a = 0; a < 24; ++a) {
    for (long b = 0; b < 24; ++b) {
      points.push_back(
          {ratio(a, 24) + ratio((a * 7 + b * 5) % 11, 1000), ratio(b, 24) + ratio((a * 3 + b * 8) % 13, 1000)});
    }
  }
  return FlatAtlas<2>(cubic_torus<2>(), PointSet<2>(points), ratio(1, 30));
}

TEST(CheckStability, of_translations_follows_from_the_stars_themselves) {
  // Charts of a flat torus are isometric, so every star is the same in all of them.
  const auto atlas = displaced_lattice();
  const auto complex = stars_of<2>(atlas, atlas.net(), unit_torus);
  ASSERT_TRUE(complex.agreement().failures.empty());
  const auto stability = check_stability<2>(atlas, atlas.net(), unit_torus, complex, no_progress());
  EXPECT_TRUE(stability.failures.empty());
  EXPECT_EQ(stability.differing, 0U);
  EXPECT_EQ(stability.pairs, 2 * complex.label_complex().count(1));
  EXPECT_GT(stability.margins.protection, 0);
  EXPECT_LT(stability.margins.circumradius, 1.0 / 24);
}

TEST(CheckStability, where_charts_are_isometric_says_what_all_charts_say) {
  const auto atlas = displaced_lattice();
  const auto complex = stars_of<2>(atlas, atlas.net(), unit_torus);
  const auto in_all = check_stability<2>(atlas, atlas.net(), unit_torus, complex, no_progress());
  auto isometric = unit_torus;
  isometric.isometric_charts = true;
  const auto at_once = check_stability<2>(atlas, atlas.net(), isometric, complex, no_progress());
  EXPECT_EQ(at_once.pairs, in_all.pairs);
  EXPECT_EQ(at_once.differing, 0U);
  // The same balls, computed in other charts; how far they reach is a bound.
  EXPECT_NEAR(at_once.margins.circumradius, in_all.margins.circumradius, 1e-12);
  EXPECT_NEAR(at_once.margins.thickness, in_all.margins.thickness, 1e-9);
  EXPECT_NEAR(at_once.margins.protection, in_all.margins.protection, 1e-12);
  EXPECT_GE(at_once.margins.reach, in_all.margins.reach);
  EXPECT_LT(at_once.margins.reach, 4.01 * at_once.margins.circumradius);

  // Where patches are too small for that bound, and where stars disagree, every chart is looked at.
  isometric.patch_factor = 3;
  auto small = unit_torus;
  small.patch_factor = 3;
  const auto in_small_patches = check_stability<2>(atlas, atlas.net(), isometric, complex, no_progress());
  EXPECT_GT(in_small_patches.differing, 0U);
  EXPECT_EQ(in_small_patches.differing,
            check_stability<2>(atlas, atlas.net(), small, complex, no_progress()).differing);
  isometric.patch_factor = unit_torus.patch_factor;
  std::vector<ChartStar<2>> stars;
  for (std::uint32_t index = 0; index < atlas.size(); ++index) stars.push_back(complex.chart_star(Label(index)));
  std::swap(stars[3].simplices.front()[0], stars[4].simplices.front()[0]);
  const ChartComplex<2> forged(std::move(stars), std::vector<bool>(atlas.size(), true));
  ASSERT_FALSE(forged.agreement().failures.empty());
  const auto refused = check_stability<2>(atlas, atlas.net(), isometric, forged, no_progress());
  EXPECT_GT(refused.differing, 0U);
  EXPECT_EQ(refused.differing, check_stability<2>(atlas, atlas.net(), unit_torus, forged, no_progress()).differing);
}

TEST(StabilityInChart, is_what_all_charts_together_are_made_of) {
  const auto atlas = sphere(ratio(1, 5));
  const auto complex = stars_of<2>(atlas, atlas.net(), unit_sphere);
  const auto stability = check_stability<2>(atlas, atlas.net(), unit_sphere, complex, no_progress());
  std::size_t pairs = 0;
  std::vector<std::string> reasons;
  // Backwards: the result does not depend on what was looked at before.
  ChartView<2> view(atlas, atlas.net(), unit_sphere);
  for (auto index = static_cast<std::uint32_t>(atlas.size()); index-- > 0;) {
    const auto here = stability_in_chart<2>(view, complex, Label(index));
    EXPECT_EQ(here.pairs, complex.neighbours(Label(index)).size());
    pairs += here.pairs;
    for (auto failure = here.failures.rbegin(); failure != here.failures.rend(); ++failure) {
      EXPECT_EQ(failure->concerned, (std::vector<Label>{failure->label, Label(index)}));
      reasons.push_back(failure->reason);
    }
    ASSERT_TRUE(here.margins.has_value());
    EXPECT_LE(stability.margins.protection, here.margins->protection);
    EXPECT_GE(stability.margins.reach, here.margins->reach);
  }
  EXPECT_EQ(pairs, stability.pairs);
  std::reverse(reasons.begin(), reasons.end());
  ASSERT_EQ(reasons.size(), stability.failures.size());
  for (std::size_t at = 0; at < reasons.size(); ++at) EXPECT_EQ(reasons[at], stability.failures[at].reason);
}

/// Whatever doubles leave out: the margins are those of all simplices in all charts, on intervals, bit by bit.
TEST(CheckStability, has_the_margins_of_all_simplices) {
  const auto sample = perturbed_sphere();
  const auto& complex = sample.run.complex;
  const auto stability = check_stability<2>(sample.atlas, sample.run.points, unit_sphere, complex, no_progress());
  ASSERT_TRUE(stability.failures.empty());
  ChartView<2> view(sample.atlas, sample.run.points, unit_sphere);
  std::optional<LocalMargins> all;
  for (std::uint32_t chart = 0; chart < complex.size(); ++chart) {
    view.look_by_halves(Label(chart), 9);
    for (const Label i : complex.neighbours(Label(chart))) {
      for (const auto& others : complex.chart_star(i).simplices) {
        LocalMargins margins;
        std::size_t witness = 0;
        const auto places = places_of<2>(view, {others[0].index, others[1].index, i.value});
        ASSERT_TRUE(places.has_value());
        ASSERT_FALSE(chart_simplex_failure<2>(view, *places, 0, margins, witness, 8).has_value());
        if (all) margins.include(*all);
        all = margins;
      }
    }
  }
  EXPECT_EQ(stability.margins.protection, all->protection);
  EXPECT_EQ(stability.margins.thickness, all->thickness);
  EXPECT_EQ(stability.margins.circumradius, all->circumradius);
  EXPECT_EQ(stability.margins.reach, all->reach);
}

TEST(CheckStability, of_a_raw_net_of_a_sphere_names_star_and_chart) {
  const auto atlas = sphere(ratio(1, 5));
  const auto complex = stars_of<2>(atlas, atlas.net(), unit_sphere);
  const auto stability = check_stability<2>(atlas, atlas.net(), unit_sphere, complex, no_progress());
  ASSERT_GT(stability.stars, 5U);
  EXPECT_GE(stability.differing, stability.stars);
  EXPECT_EQ(stability.failures.size(), stability.differing);
  EXPECT_TRUE(mentions(stability.failures[0].reason, "in the chart of label ")) << stability.failures[0].reason;
  EXPECT_TRUE(mentions(stability.failures[0].reason, "has another point in its closed circumball: label "));
  // What fails in the chart of another label is certified in its own, and most stars are the same everywhere.
  EXPECT_LT(stability.stars, atlas.size() / 4);
  // No precision would certify them.
  EXPECT_EQ(stability.occupied, stability.stars);
  std::string stages;
  (void)check_stability<2>(atlas, atlas.net(), unit_sphere, complex,
                           [&](std::string_view stage, std::size_t, std::size_t) { stages = stage; });
  EXPECT_EQ(stages, "compare stars in other charts");
}

// Defect: a patch smaller than the reach that is tried first ended the program.
TEST(CheckStability, in_small_patches_says_what_they_do_not_hold) {
  const auto atlas = sphere(ratio(1, 5));
  auto geometry = unit_sphere;
  geometry.patch_factor = 4;
  const auto complex = stars_of<2>(atlas, atlas.net(), geometry);
  const auto stability = check_stability<2>(atlas, atlas.net(), geometry, complex, no_progress());
  const auto sees_too_little = [](const auto& failure) {
    return mentions(failure.reason, "does not lie in the patch") || mentions(failure.reason, "is not seen once");
  };
  EXPECT_TRUE(std::any_of(stability.failures.begin(), stability.failures.end(), sees_too_little));
  // They may be the same.
  EXPECT_TRUE(std::any_of(stability.failures.begin(), stability.failures.end(), [&](const auto& failure) {
    return sees_too_little(failure) && failure.cause == FailureCause::undecided;
  }));
  EXPECT_LT(stability.occupied, stability.stars);
}

TEST(CheckStability, says_where_a_label_is_not_seen) {
  const auto atlas = sphere(ratio(1, 5));
  auto complex = stars_of<2>(atlas, atlas.net(), unit_sphere);
  // A far-away label in a star: a triangle across the sphere.
  std::vector<ChartStar<2>> stars;
  for (std::uint32_t index = 0; index < atlas.size(); ++index) stars.push_back(complex.chart_star(Label(index)));
  std::vector<Sighting<2>> near;
  atlas.sightings(Label(0), 2, near);
  std::uint32_t far = 0;
  while (std::any_of(near.begin(), near.end(), [&](const auto& seen) { return seen.index == far; })) ++far;
  const Label neighbour = complex.neighbours(Label(0)).front();
  stars[0].simplices.front() = {Sighting<2>{far, {}}, Sighting<2>{neighbour.value, {}}};
  const ChartComplex<2> forged(std::move(stars), std::vector<bool>(atlas.size(), true));
  const auto stability = check_stability<2>(atlas, atlas.net(), unit_sphere, forged, no_progress());
  EXPECT_TRUE(std::any_of(stability.failures.begin(), stability.failures.end(),
                          [](const auto& failure) { return mentions(failure.reason, "is not seen once"); }));
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
