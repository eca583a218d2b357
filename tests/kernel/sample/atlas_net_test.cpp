#include "kernel/sample/atlas_net.hpp"

#include <gtest/gtest.h>

#include "kernel/sample/separation.hpp"
#include "tests/kernel/manifold/gluing/atlas_samples.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

std::shared_ptr<const ChartGluing> glued(const std::string& name) {
  return std::make_shared<const ChartGluing>(atlas_named(name));
}

TEST(AtlasNet, of_the_square_torus_is_a_maximal_poisson_disk_set) {
  const auto gluing = glued("torus-2-by-charts");
  const auto net = atlas_net<2>(*gluing, ratio(1, 24), 1, no_progress());
  EXPECT_LE(net.covering_radius, 1.0001 / 24);
  EXPECT_GE(net.covering_radius, 0.8 / 24);
  // As dense as one of the flat torus: between the hexagonal lattice and what is usual.
  EXPECT_GE(net.places.size(), 24U * 24U * 2U / 3U);
  EXPECT_LE(net.places.size(), 24U * 24U * 7U / 8U);
  const FormulaAtlas<2> atlas(gluing, net.places, ratio(1, 24));
  EXPECT_GE(measure_separation<2>(atlas), ratio(999999, 1000000));
}

TEST(AtlasNet, is_the_same_for_a_seed_and_in_the_charts) {
  const auto gluing = glued("projective-plane-by-charts");
  const auto net = atlas_net<2>(*gluing, ratio(1, 10), 7, no_progress());
  EXPECT_EQ(net.places, atlas_net<2>(*gluing, ratio(1, 10), 7, no_progress()).places);
  EXPECT_NE(net.places, atlas_net<2>(*gluing, ratio(1, 10), 8, no_progress()).places);
  std::size_t chart = 0;
  for (const auto& place : net.places) {
    EXPECT_GE(place.chart, chart);
    chart = place.chart;
    for (std::size_t axis = 0; axis < 2; ++axis) {
      EXPECT_LT(absolute(place.x[axis]), ratio(5, 4));
      EXPECT_LE(place.x[axis].denominator(), Integer(1) << 48);
    }
  }
  EXPECT_EQ(chart, 2U);
}

TEST(AtlasNet, covers_where_charts_are_bent) {
  const auto gluing = glued("sphere-2-stereographic");
  const auto net = atlas_net<2>(*gluing, ratio(1, 20), 1, no_progress());
  EXPECT_LE(net.covering_radius, 1.0001 / 20);
  const FormulaAtlas<2> atlas(gluing, net.places, ratio(1, 20));
  EXPECT_GT(measure_separation<2>(atlas), ratio(2, 3));
}

TEST(AtlasNet, refuses_a_radius_of_0) {
  EXPECT_THROW((void)atlas_net<2>(*glued("sphere-2-stereographic"), Rational(0), 1, no_progress()), InputError);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
