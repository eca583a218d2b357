#include "properties/instances/pair_image.hpp"

#include "properties/instances/pair_distortion.hpp"
#include "properties/instances/random_simplex.hpp"
#include "tests/properties/instances/class_checks.hpp"
#include "tests/support/ratio.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

/// Not more than ξ, up to roundings of 2⁻⁴⁰.
void expect_within(const SimplexObject& simplex, const SimplexObject& image, const Rational& xi) {
  EXPECT_TRUE(is_distortion_at_most(simplex, image, xi * (Rational(1) + Rational::power_of_two(-40))));
}

TEST(PairImage, StaysWithinTheDistortionFromFatToThin) {
  for (std::uint32_t number = 0; number < 60; ++number) {
    RandomChoices choices(1, 2, number);
    const auto points = random_simplex({3, 4}, choices);
    if (!points) continue;
    const SimplexObject simplex(*points);
    const Rational xi = Rational::power_of_two(-static_cast<long>(number % 20) * 15) / Rational(3);
    expect_within(simplex, *linear_image(simplex, xi, choices), xi);
    expect_within(simplex, *relengthened_image(simplex, xi, false, choices), xi);
    expect_within(simplex, *displaced_image(simplex, random_directions(simplex, choices), xi), xi);
  }
}

TEST(PairImage, MovedVerticesComeNearTheDistortion) {
  RandomChoices choices(1, 3, 0);
  const SimplexObject simplex({{Rational(0), Rational(0)}, {Rational(4), Rational(0)}, {Rational(0), Rational(3)}});
  for (const Rational& xi : {ratio(1, 10), Rational::power_of_two(-250)}) {
    const auto image = displaced_image(simplex, random_directions(simplex, choices), xi);
    expect_within(simplex, *image, xi);
    EXPECT_GE(measured_distortion(simplex, *image), ratio(999, 1000) * xi);
  }
}

TEST(PairImage, AStarOfARegularSimplexReachesTheDistortionExactly) {
  RandomChoices choices(1, 4, 0);
  for (int k = 2; k <= 6; ++k) {
    const auto regular = regular_simplex_by_edges(k);
    const auto image = relengthened_image(*regular, ratio(1, 8), true, choices);
    EXPECT_TRUE(is_distortion_at_most(*regular, *image, ratio(1, 8)));
    EXPECT_FALSE(is_distortion_at_most(*regular, *image, ratio(1, 8) - Rational::power_of_two(-100)));
  }
}

TEST(PairImage, LengthsThatNoSimplexHasArePulledBack) {
  RandomChoices choices(1, 5, 0);
  const auto regular = regular_simplex_by_edges(3);
  // The far edges of length 1 + ξ over near ones of 1 − ξ, or the other way round: impossible for one of them.
  for (int time = 0; time < 10; ++time) {
    const auto image = relengthened_image(*regular, ratio(9, 10), true, choices);
    EXPECT_TRUE(is_distortion_at_most(*regular, *image, ratio(9, 10)));
  }
}

TEST(PairImage, ReflectionsKeepLengths) {
  RandomChoices choices(1, 6, 0);
  for (int time = 0; time < 20; ++time) {
    const auto normal = random_normal(3, choices);
    const std::vector<Rational> point{Rational(1), ratio(2, 3), Rational(-5)};
    const auto image = reflected(point, normal);
    EXPECT_EQ(square(image[0]) + square(image[1]) + square(image[2]), Rational(26) + ratio(4, 9));
    EXPECT_EQ(reflected(image, normal), point);
    EXPECT_NE(image, point);
  }
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
