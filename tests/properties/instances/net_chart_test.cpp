#include "properties/instances/net_chart.hpp"

#include <gtest/gtest.h>

namespace delcert::test {
namespace DELCERT_THIS_FILE {

TEST(NetChart, draws_maps_of_exactly_the_distortion_asked_for) {
  int reached = 0;
  int folded = 0;
  for (std::uint32_t number = 0; number < 40; ++number) {
    RandomChoices choices(1, 1, number);
    const int dimension = number % 2 == 0 ? 2 : 3;
    const Rational distortion = Rational::power_of_two(-static_cast<long>(number) - 1);
    const ChartMap map = draw_chart_map(dimension, distortion, choices);
    EXPECT_TRUE(has_chart_distortion(map, dimension, distortion));
    const Rational less = distortion * (Rational(1) - Rational::power_of_two(-30));
    reached += has_chart_distortion(map, dimension, less) ? 0 : 1;
    folded += map.size() > static_cast<std::size_t>(dimension * dimension) ? 1 : 0;
  }
  EXPECT_GT(reached, 30);
  EXPECT_GT(folded, 8);
  EXPECT_LT(folded, 32);
}

/// The identity, and a fold a|⟨w, x⟩ − b| with a = (0, 1/4), w = (1, 0), b = 1.
ChartMap folded_identity() {
  const Rational quarter = Rational::power_of_two(-2);
  return {Rational(1), Rational(0), Rational(0), Rational(1), Rational(0),
          quarter,     Rational(1), Rational(0), Rational(1)};
}

TEST(NetChart, a_fold_moves_both_sides_of_its_hyperplane_alike) {
  const Rational quarter = Rational::power_of_two(-2);
  EXPECT_EQ(chart_image(folded_identity(), {Rational(3), Rational(0)}),
            (std::vector<Rational>{Rational(3), Rational(2) * quarter}));
  EXPECT_EQ(chart_image(folded_identity(), {Rational(-1), Rational(0)}),
            (std::vector<Rational>{Rational(-1), Rational(2) * quarter}));
  EXPECT_EQ(chart_image(folded_identity(), {Rational(1), Rational(5)}),
            (std::vector<Rational>{Rational(1), Rational(5)}));
}

TEST(NetChart, a_fold_has_its_part_of_the_distortion) {
  const Rational quarter = Rational::power_of_two(-2);
  const Rational less = quarter * (Rational(1) - Rational::power_of_two(-30));
  EXPECT_TRUE(has_chart_distortion(folded_identity(), 2, quarter * (Rational(1) + Rational::power_of_two(-39))));
  EXPECT_FALSE(has_chart_distortion(folded_identity(), 2, less));
  ChartMap stretched = folded_identity();
  stretched[0] = Rational(9) / Rational(8);
  EXPECT_FALSE(has_chart_distortion(stretched, 2, Rational(37) / Rational(100)));
  EXPECT_TRUE(has_chart_distortion(stretched, 2, Rational(38) / Rational(100)));
  stretched.pop_back();
  EXPECT_THROW((void)has_chart_distortion(stretched, 2, Rational(1)), InputError);
}

TEST(NetChart, no_distance_is_distorted_more_than_decided) {
  for (std::uint32_t number = 0; number < 30; ++number) {
    RandomChoices choices(2, 3, number);
    const Rational distortion = Rational::power_of_two(-3);
    const ChartMap map = draw_chart_map(2, distortion, choices);
    std::vector<std::vector<Rational>> points;
    for (long x = -3; x <= 3; ++x) {
      for (long y = -3; y <= 3; ++y) points.push_back({Rational(x) / Rational(2), Rational(y) / Rational(3)});
    }
    for (const auto& a : points) {
      for (const auto& b : points) {
        const auto squared = [](const std::vector<Rational>& u, const std::vector<Rational>& v) {
          return square(u[0] - v[0]) + square(u[1] - v[1]);
        };
        const Rational before = squared(a, b);
        const Rational after = squared(chart_image(map, a), chart_image(map, b));
        EXPECT_LE(after, before * square(Rational(1) + distortion));
        EXPECT_GE(after, before * square(Rational(1) - distortion));
      }
    }
  }
}

TEST(NetChart, decides_distortions_by_hand) {
  // A shear: singular values (√5 ± 1)/2.
  const ChartMap shear{Rational(1), Rational(1), Rational(0), Rational(1)};
  EXPECT_TRUE(has_chart_distortion(shear, 2, Rational(Integer(62), Integer(100))));
  EXPECT_FALSE(has_chart_distortion(shear, 2, Rational(Integer(61), Integer(100))));
  EXPECT_THROW((void)has_chart_distortion(shear, 3, Rational(1)), InputError);
  EXPECT_EQ(chart_image(shear, {Rational(2), Rational(3)}), (std::vector<Rational>{Rational(5), Rational(3)}));
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
