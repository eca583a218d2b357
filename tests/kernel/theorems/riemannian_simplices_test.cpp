#include "kernel/theorems/riemannian_simplices.hpp"

#include <gtest/gtest.h>

#include "tests/kernel/stars/certified_samples.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

TEST(MeasureRiemannianSimplices, has_the_thickness_about_the_perturbed_points) {
  const auto sample = perturbed_sphere();
  const auto measured =
      measure_riemannian_simplices<2>(sample.atlas, sample.run.points, unit_sphere, sample.run.complex, no_progress());
  double thickness = 1;
  double radius = 0;
  for (std::uint32_t i = 0; i < sample.atlas.size(); ++i) {
    for (const auto& others : sample.run.complex.star(Label(i))) {
      // exp⁻¹ at p in space: q less its part along p, as long as the angle.
      const auto& p = sample.places[i];
      std::array<Vector<double, 3>, 3> corners{};
      for (std::size_t k = 0; k < 2; ++k) {
        const auto& q = sample.places[others[k]];
        const double cosine = pairing(p, q);
        Vector<double, 3> along = difference(q, scaled(cosine, p));
        corners[k + 1] = scaled(std::acos(cosine) / std::sqrt(pairing(along, along)), along);
        radius = std::max(radius, std::acos(cosine));
      }
      const auto length = [&](std::size_t a, std::size_t b) {
        const auto edge = difference(corners[a], corners[b]);
        return std::sqrt(pairing(edge, edge));
      };
      const double a = length(0, 1);
      const double b = length(1, 2);
      const double c = length(2, 0);
      const double s = (a + b + c) / 2;
      const double longest = std::max({a, b, c});
      thickness = std::min(thickness, std::sqrt(s * (s - a) * (s - b) * (s - c)) / longest / longest);
    }
  }
  EXPECT_LE(measured.thickness, thickness * (1 + 1e-9));
  EXPECT_NEAR(measured.thickness, thickness, 1e-9);
  EXPECT_NEAR(measured.star_radius, radius, 1e-9);
  // Far too coarse for the theorem: t₀/6 is a tenth of the stars.
  EXPECT_NEAR(measured.scale, thickness / 6, 1e-9);
  EXPECT_TRUE(is_refuted(measured.holds));
}

TEST(MeasureRiemannianSimplices, on_a_flat_torus_asks_for_a_quarter_of_the_injectivity_radius) {
  const auto sample = perturbed_torus();
  const auto measure = [&](const Rational& injectivity_radius) {
    return measure_riemannian_simplices<2>(sample.atlas, sample.run.points, {Curvature::zero, injectivity_radius},
                                           sample.run.complex, no_progress());
  };
  const auto measured = measure(ratio(1, 2));
  EXPECT_TRUE(is_proved(measured.holds));
  EXPECT_NEAR(measured.scale, 0.125, 1e-15);
  EXPECT_NEAR(measured.thickness, sample.run.margins.thickness, 1e-12);
  EXPECT_TRUE(is_refuted(measure(Rational::exactly(3.9 * measured.star_radius)).holds));
  EXPECT_TRUE(is_proved(measure(Rational::exactly(4.1 * measured.star_radius)).holds));
}

TEST(MeasureRiemannianSimplices, leaves_undecided_what_is_not_seen) {
  const auto sample = perturbed_sphere();
  const std::vector<bool> interior(sample.atlas.size(), true);
  std::vector<ChartStar<2>> stars;
  for (std::uint32_t i = 0; i < sample.atlas.size(); ++i) stars.push_back({Label(i), {}});
  const ChartComplex<2> empty(std::move(stars), interior);
  EXPECT_TRUE(is_undecided(
      measure_riemannian_simplices<2>(sample.atlas, sample.run.points, unit_sphere, empty, no_progress()).holds));
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
