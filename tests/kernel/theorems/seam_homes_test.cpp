#include "kernel/theorems/seam_homes.hpp"

#include <gtest/gtest.h>

#include "kernel/theorems/blended_triangulation.hpp"
#include "tests/kernel/theorems/glued_run.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

std::shared_ptr<const ChartGluing> gluing(const char* name) {
  return std::make_shared<const ChartGluing>(atlas_named(name));
}

TEST(SeamHomes, are_not_changed_where_nothing_may_be_folded) {
  const auto& [atlas, run] = fine_sphere();
  EXPECT_FALSE(homes_without_folds<2>(gluing("sphere-2-stereographic"), atlas, run.points, run.complex.simplices(), 10,
                                      no_progress())
                   .has_value());
}

/// A projective plane with a few triangles between three charts that are too large for level 5.
const GluedRun<2>& coarse_plane() {
  static const auto run = glued_run<2>("projective-plane-by-charts", ratio(1, 14));
  return run;
}

TEST(SeamHomes, leave_no_simplex_folded_and_every_point_where_it_is) {
  const auto& [atlas, run] = coarse_plane();
  const auto simplices = run.complex.simplices();
  const auto at_first = check_blended_triangulation<2>(atlas, run.points, simplices);
  ASSERT_FALSE(at_first.failures.empty());
  const auto homes =
      homes_without_folds<2>(gluing("projective-plane-by-charts"), atlas, run.points, simplices, 10, no_progress());
  ASSERT_TRUE(homes.has_value());
  EXPECT_GT(homes->changed, 0U);
  EXPECT_LT(homes->changed, atlas.size() / 10);
  FormulaAtlas<2> other(gluing("projective-plane-by-charts"), homes->net, atlas.sampling_radius());
  EXPECT_TRUE(check_blended_triangulation<2>(other, homes->points, simplices).triangulates());
  const GluedPlaces<2> before(atlas, run.points);
  const GluedPlaces<2> after(other, homes->points);
  std::size_t changed = 0;
  for (std::uint32_t label = 0; label < atlas.size(); ++label) {
    changed += before.home(label) == after.home(label) ? 0U : 1U;
    const auto& here = *before.place(after.home(label), label);
    const auto& there = *after.place(after.home(label), label);
    for (std::size_t axis = 0; axis < 2; ++axis) EXPECT_NEAR(here[axis].lower(), there[axis].lower(), 1e-14);
  }
  EXPECT_EQ(changed, homes->changed);
  // The stars are the same in the charts of the other homes.
  const ModelGeometry geometry = geometry_of<2>(other, fit_patches<2>(other, no_progress()));
  const auto again = stars_in_charts<2>(other, geometry, homes->points, {}, no_progress());
  EXPECT_TRUE(again.is_certified());
  EXPECT_EQ(again.complex.simplices(), simplices);
}

/// As many rounds as there are allowed, and not one more.
TEST(SeamHomes, are_none_where_there_are_not_enough_rounds) {
  const auto& [atlas, run] = coarse_plane();
  EXPECT_FALSE(homes_without_folds<2>(gluing("projective-plane-by-charts"), atlas, run.points, run.complex.simplices(),
                                      0, no_progress())
                   .has_value());
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
