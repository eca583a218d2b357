#include "properties/instances/net_chart.hpp"

#include <gtest/gtest.h>

namespace delcert::test {
namespace DELCERT_THIS_FILE {

TEST(NetChart, draws_maps_of_exactly_the_distortion_asked_for) {
  int reached = 0;
  for (std::uint32_t number = 0; number < 40; ++number) {
    RandomChoices choices(1, 1, number);
    const int dimension = number % 2 == 0 ? 2 : 3;
    const Rational distortion = Rational::power_of_two(-static_cast<long>(number) - 1);
    const ChartMap map = draw_chart_map(dimension, distortion, choices);
    EXPECT_TRUE(has_chart_distortion(map, dimension, distortion));
    const Rational less = distortion * (Rational(1) - Rational::power_of_two(-40));
    reached += has_chart_distortion(map, dimension, less) ? 0 : 1;
  }
  EXPECT_GT(reached, 30);
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
