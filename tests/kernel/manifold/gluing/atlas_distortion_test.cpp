#include "kernel/manifold/gluing/atlas_distortion.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "kernel/sample/atlas_net.hpp"
#include "tests/kernel/manifold/gluing/atlas_samples.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

FormulaAtlas<2> sampled(const std::string& name, const Rational& radius) {
  auto gluing = std::make_shared<const ChartGluing>(atlas_named(name));
  const auto net = atlas_net<2>(*gluing, radius, 1, no_progress());
  return {gluing, net.places, radius};
}

TEST(AtlasDistortion, of_translations_is_nothing) {
  const auto atlas = sampled("torus-2-by-charts", ratio(1, 40));
  EXPECT_EQ(measure_transitions<2>(atlas, ratio(1, 4), no_progress()).value(), Rational::power_of_two(-40));
}

TEST(AtlasDistortion, holds_for_every_pair_and_is_not_much_too_large) {
  auto atlas = sampled("sphere-2-stereographic", ratio(1, 24));
  atlas.set_patch_factor(5);
  const Rational xi = measure_transitions<2>(atlas, Rational(2), no_progress()).value();
  const double bound = approximate_double(xi);
  double worst = 0;
  for (std::uint32_t index = 0; index < atlas.size(); ++index) {
    const Label i(index);
    for (const auto& seen : atlas.neighbours(i)) {
      // By differences of exact places, 2⁻³⁰ apart.
      const Rational step = Rational::power_of_two(-30);
      const auto origin = *atlas.carry(i, seen, Vector<Rational, 2>{});
      Matrix<double, 2> derivative;
      for (std::size_t k = 0; k < 2; ++k) {
        Vector<Rational, 2> home{};
        home[k] = step;
        const auto moved = difference(*atlas.carry(i, seen, home), origin);
        for (std::size_t row = 0; row < 2; ++row) derivative[row][k] = approximate_double(moved[row] / step);
      }
      // The greater singular value of a 2×2 matrix.
      const double squares = derivative[0][0] * derivative[0][0] + derivative[0][1] * derivative[0][1] +
                             derivative[1][0] * derivative[1][0] + derivative[1][1] * derivative[1][1];
      const double determinant = derivative[0][0] * derivative[1][1] - derivative[0][1] * derivative[1][0];
      const double root = std::sqrt(std::max(0.0, squares * squares / 4 - determinant * determinant));
      worst = std::max(worst, std::sqrt(squares / 2 + root) - 1);
    }
  }
  EXPECT_LE(worst, bound * (1 + 1e-6));
  // Boxes of a quarter of a radius, and the rim of patches, add to it.
  EXPECT_GE(worst, bound / 2);
}

TEST(AtlasDistortion, makes_patches_smaller_or_refuses) {
  auto atlas = sampled("sphere-2-stereographic", ratio(1, 24));
  const int before = atlas.patch_factor();
  const Rational xi = fit_patches<2>(atlas, no_progress());
  EXPECT_LE(atlas.patch_factor(), before);
  EXPECT_LT(xi, ratio(1, 2));
  const ModelGeometry geometry = geometry_of<2>(atlas, xi);
  EXPECT_EQ(geometry.patch_factor, atlas.patch_factor());
  EXPECT_EQ(geometry.distortion, xi);
  EXPECT_FALSE(geometry.isometric_charts);
  EXPECT_FALSE(measure_transitions<2>(atlas, ratio(1, 1000), no_progress()).has_value());
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
