#include "kernel/theorems/stable_patches.hpp"

#include <gtest/gtest.h>

#include "tests/kernel/theorems/glued_run.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

/// What is so in the patches that the atlas has.
StarStability stability_of(const GluedRun<2>& sample) {
  const Rational distortion = measure_transitions<2>(sample.atlas, greatest_distortion(), no_progress()).value();
  return check_stability<2>(sample.atlas, sample.run.points, geometry_of<2>(sample.atlas, distortion),
                            sample.run.complex, no_progress());
}

std::optional<StablePatches> widened(GluedRun<2>& sample, const StarStability& found) {
  return widen_patches<2>(sample.atlas, sample.run.points, sample.run.complex, found, no_progress());
}

TEST(WidenPatches, until_stars_are_the_same_in_all_charts_of_a_conformal_atlas) {
  auto sample = glued_run<2>("sphere-2-stereographic", ratio(1, 20));
  const int before = sample.atlas.patch_factor();
  const StarStability narrow = stability_of(sample);
  EXPECT_GT(narrow.stars, 0U);
  EXPECT_EQ(narrow.occupied, 0U);
  const auto wide = widened(sample, narrow);
  ASSERT_TRUE(wide);
  EXPECT_GT(sample.atlas.patch_factor(), before);
  EXPECT_TRUE(wide->stability.failures.empty());
  EXPECT_LT(wide->stability.margins.reach, approximate_double(sample.atlas.patch_radius()));
  EXPECT_LT(wide->distortion, greatest_distortion());
  // Patches that are less wide do not do.
  sample.atlas.set_patch_factor(sample.atlas.patch_factor() - 1);
  EXPECT_GT(stability_of(sample).stars, 0U);
}

TEST(WidenPatches, shows_the_points_that_are_in_balls_of_other_atlases) {
  auto sample = glued_run<2>("projective-plane-by-charts", ratio(1, 20));
  const StarStability narrow = stability_of(sample);
  EXPECT_LT(narrow.occupied, narrow.stars);
  const auto wide = widened(sample, narrow);
  ASSERT_TRUE(wide);
  EXPECT_GT(wide->stability.occupied, 0U);
  EXPECT_EQ(wide->stability.occupied, wide->stability.stars);
}

TEST(WidenPatches, does_nothing_where_no_patches_fit) {
  auto coarse = glued_run<2>("sphere-2-stereographic", ratio(1, 8));
  const int before = coarse.atlas.patch_factor();
  EXPECT_FALSE(widened(coarse, stability_of(coarse)));
  EXPECT_EQ(coarse.atlas.patch_factor(), before);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
