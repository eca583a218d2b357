#include "kernel/run/kept_stars.hpp"

#include <gtest/gtest.h>

#include "kernel/perturb/perturbation.hpp"
#include "kernel/run/chart_run.hpp"
#include "tests/kernel/stars/curved_patch.hpp"
#include "tests/support/ratio.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

const ModelGeometry round_sphere{Curvature::positive, Rational(3)};

TEST(KeptStars, of_parts_are_those_of_all) {
  const auto atlas = sphere(ratio(1, 4));
  Perturbation<2> perturbation(atlas, measured_parameters(Dimension(2), 1));
  perturbation.place_all(no_progress());
  KeptStars<2> all(atlas, round_sphere, 0, all_labels_of(atlas));
  all.update(perturbation.points(), no_progress());
  const auto middle = static_cast<std::uint32_t>(atlas.size() / 2);
  LocalMargins margins;
  double reach = 0;
  for (const LabelRange range : {LabelRange{0, middle}, LabelRange{middle, static_cast<std::uint32_t>(atlas.size())}}) {
    KeptStars<2> some(atlas, round_sphere, 0, range);
    EXPECT_FALSE(range.size() > 0 && some.farthest_reach() > 0);
    some.update(perturbation.points(), no_progress());
    for (std::uint32_t label = 0; label < atlas.size(); ++label) {
      const auto here = some.stars()[label].simplices;
      EXPECT_EQ(here, range.contains(label) ? all.stars()[label].simplices : std::vector<ChartSimplex<2>>());
    }
    ASSERT_TRUE(some.has_margins());
    if (range.first == 0) margins = some.margins();
    margins.include(some.margins());
    reach = std::max(reach, some.farthest_reach());
  }
  EXPECT_EQ(margins.protection, all.margins().protection);
  EXPECT_EQ(margins.reach, all.margins().reach);
  EXPECT_EQ(reach, all.farthest_reach());
  EXPECT_FALSE(KeptStars<2>(atlas, round_sphere, 0, {3, 3}).has_margins());
}

TEST(KeptStars, are_computed_again_where_a_point_has_moved) {
  const auto atlas = sphere(ratio(1, 4));
  Perturbation<2> perturbation(atlas, measured_parameters(Dimension(2), 1));
  KeptStars<2> stars(atlas, round_sphere, 0, all_labels_of(atlas));
  stars.update(perturbation.points(), no_progress());
  perturbation.place_all(no_progress());
  // Nobody has said that points have moved.
  const std::vector<ChartStar<2>> before = stars.stars();
  stars.update(perturbation.points(), no_progress());
  for (std::uint32_t label = 0; label < atlas.size(); ++label)
    EXPECT_EQ(stars.stars()[label].simplices, before[label].simplices);
  std::vector<Label> all;
  for (std::uint32_t label = 0; label < atlas.size(); ++label) all.emplace_back(label);
  stars.outdate(all);
  stars.update(perturbation.points(), no_progress());
  KeptStars<2> anew(atlas, round_sphere, 0, all_labels_of(atlas));
  anew.update(perturbation.points(), no_progress());
  std::size_t different = 0;
  for (std::uint32_t label = 0; label < atlas.size(); ++label) {
    EXPECT_EQ(stars.stars()[label].simplices, anew.stars()[label].simplices);
    different += stars.stars()[label].simplices == before[label].simplices ? 0U : 1U;
  }
  EXPECT_GT(different, 0U);
}

TEST(KeptStars, that_are_lent_and_given_back_are_what_they_were) {
  const auto atlas = sphere(ratio(1, 4));
  KeptStars<2> stars(atlas, round_sphere, 0, all_labels_of(atlas));
  stars.update(atlas.net(), no_progress());
  const std::vector<ChartStar<2>> before = stars.stars();
  const LocalMargins margins = stars.margins();
  ChartComplex<2> complex = stars.lend_complex();
  EXPECT_TRUE(stars.stars().empty());
  EXPECT_EQ(stars.margins().protection, margins.protection) << "margins are not lent";
  stars.take_back(complex.take_stars());
  stars.outdate({Label(3)});
  stars.update(atlas.net(), no_progress());
  ASSERT_EQ(stars.stars().size(), before.size());
  for (std::uint32_t label = 0; label < atlas.size(); ++label)
    EXPECT_EQ(stars.stars()[label].simplices, before[label].simplices);
}

TEST(KeptStars, that_are_certified_later_have_no_failures_any_more) {
  const auto atlas = sphere(ratio(1, 4));
  KeptStars<2> stars(atlas, round_sphere, 0, all_labels_of(atlas));
  stars.set_displacement_of_the_whole(100);
  stars.update(atlas.net(), no_progress());
  EXPECT_FALSE(stars.failures().empty());
  std::vector<Label> all;
  for (std::uint32_t label = 0; label < atlas.size(); ++label) all.emplace_back(label);
  stars.set_displacement_of_the_whole(0);
  stars.outdate(all);
  stars.update(atlas.net(), no_progress());
  EXPECT_TRUE(stars.failures().empty());
  EXPECT_TRUE(stars.has_margins());
}

TEST(KeptStars, rest_on_how_far_points_of_the_whole_are_moved) {
  const auto atlas = sphere(ratio(1, 4));
  KeptStars<2> stars(atlas, round_sphere, 0, all_labels_of(atlas));
  stars.set_displacement_of_the_whole(100);
  stars.update(atlas.net(), no_progress());
  EXPECT_FALSE(stars.has_margins());
  EXPECT_EQ(star_count(stars.failures()), atlas.size());
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
