#include "kernel/manifold/gluing/chart_distortion.hpp"

#include <gtest/gtest.h>

#include "tests/kernel/manifold/gluing/samples.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

TEST(ChartDistortion, of_a_constant_metric_is_only_rounding) {
  const MetricField<2> field(constant_field({{Rational(3), Rational(1)}, {Rational(1), Rational(2)}}));
  const MetricFieldAtlas<2> atlas(field, lattice_points<2>(5), ratio(1, 40));
  const auto distortion = measure_distortion<2>(atlas, ratio(1, 4), no_progress());
  ASSERT_TRUE(distortion.has_value());
  EXPECT_EQ(distortion->transition, Rational(0));
  EXPECT_LE(distortion->rounding, Rational::power_of_two(-26));
  EXPECT_LE(distortion->metric, Rational::power_of_two(-26));
  EXPECT_GT(distortion->metric, Rational(0));
}

TEST(ChartDistortion, holds_for_every_pair_and_is_not_much_too_large) {
  const MetricFieldAtlas<2> atlas(MetricField<2>(shear()), lattice_points<2>(20), ratio(1, 60));
  const auto distortion = *measure_distortion<2>(atlas, ratio(1, 2), no_progress());
  const auto is_close = [&](Label i, Label j, const Rational& xi) {
    const auto b = atlas.chart(i).gram();
    const auto other = atlas.chart(j).gram();
    return is_proved(is_above(other, square(Rational(1) - xi), b)) &&
           is_proved(is_below(other, square(Rational(1) + xi), b));
  };
  bool less_would_do = true;
  for (std::uint32_t index = 0; index < atlas.size(); ++index) {
    for (const auto& other : atlas.neighbours(Label(index))) {
      EXPECT_TRUE(is_close(Label(index), label_of<2>(other), distortion.transition));
      less_would_do =
          less_would_do && is_close(Label(index), label_of<2>(other), distortion.transition * ratio(19, 20));
    }
  }
  EXPECT_FALSE(less_would_do);
}

TEST(ChartDistortion, bounds_the_metric_in_patches) {
  const MetricFieldAtlas<2> atlas(MetricField<2>(hills(2, ratio(1, 5))), lattice_points<2>(20), ratio(1, 60));
  const auto distortion = *measure_distortion<2>(atlas, ratio(1, 2), no_progress());
  const RoundingGuard guard;
  const Interval least = scalar_from<Interval>(square(Rational(1) - distortion.metric));
  const Interval most = scalar_from<Interval>(square(Rational(1) + distortion.metric));
  for (std::uint32_t index = 0; index < atlas.size(); index += 7) {
    for (long step = -4; step <= 4; ++step) {
      auto x = atlas.centre(Label(index));
      x[0] += atlas.patch_radius() * ratio(step, 4);
      const auto g = atlas.field().at<Interval>(x);
      EXPECT_TRUE(is_proved(is_above(g, least, atlas.enclosed_gram(Label(index)))));
      EXPECT_TRUE(is_proved(is_below(g, most, atlas.enclosed_gram(Label(index)))));
    }
  }
  // No more than what boxes and slack add: f changes by 2π/5 a unit, by half of that relative to 2·0.8, in 9/60.
  EXPECT_LE(distortion.metric, ratio(20, 100));
  EXPECT_GE(distortion.metric, ratio(5, 100));
  EXPECT_EQ(relative_stretch({Rational(0), Rational(0), ratio(1, 3)}), Rational(1));
}

TEST(ChartDistortion, shrinks_patches_in_which_charts_are_distorted_too_much) {
  MetricFieldAtlas<2> atlas(MetricField<2>(hills(2, ratio(2, 5))), lattice_points<2>(10), ratio(1, 50));
  ASSERT_EQ(atlas.patch_factor(), 9);
  EXPECT_FALSE(measure_distortion<2>(atlas, ratio(1, 4), no_progress()).has_value());
  const auto distortion = fit_patches<2>(atlas, no_progress());
  EXPECT_LT(atlas.patch_factor(), 9);
  EXPECT_LT(distortion.metric, ratio(1, 4));
  MetricFieldAtlas<2> steep(MetricField<2>(hills(2, ratio(9, 10))), lattice_points<2>(10), ratio(1, 40));
  EXPECT_TRUE(mentions(message_of<Rejection>([&] { (void)fit_patches<2>(steep, no_progress()); }),
                       "hills: charts are distorted by 1/2 or more within 4 sampling radii"));
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
