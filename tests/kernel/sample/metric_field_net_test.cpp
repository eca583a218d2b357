#include "kernel/sample/metric_field_net.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "kernel/sample/separation.hpp"
#include "tests/kernel/manifold/gluing/samples.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

TEST(MetricFieldNet, of_a_flat_metric_is_a_maximal_poisson_disk_set) {
  const MetricField<2> field(constant_field({{Rational(4), Rational(1)}, {Rational(1), Rational(1)}}));
  const auto net = metric_field_net<2>(field, ratio(1, 20), 1, no_progress());
  EXPECT_LE(net.covering_radius, 0.05 * 1.0001);
  EXPECT_GE(net.covering_radius, 0.04);
  // Of √3 in volume.
  EXPECT_GE(net.centres.size(), 400U);
  EXPECT_LE(net.centres.size(), 750U);
  const MetricFieldAtlas<2> atlas(field, net.centres, ratio(1, 20));
  EXPECT_GE(measure_separation<2>(atlas), ratio(999999, 1000000));
}

TEST(MetricFieldNet, is_denser_where_the_metric_is_larger) {
  const MetricField<2> field(hills(2, ratio(3, 5)));
  const auto net = metric_field_net<2>(field, ratio(1, 30), 1, no_progress());
  EXPECT_LE(net.covering_radius, 1.0001 / 30);
  std::size_t inside = 0;
  for (const auto& x : net.centres) {
    if (x[0] >= ratio(1, 4) && x[0] < ratio(3, 4)) ++inside;
  }
  // The volumes of the two halves are 1/2 ∓ 3/(5π).
  const double share = static_cast<double>(inside) / static_cast<double>(net.centres.size());
  EXPECT_GT(share, 0.25);
  EXPECT_LT(share, 0.37);
  const MetricFieldAtlas<2> atlas(field, net.centres, ratio(1, 30));
  EXPECT_GT(measure_separation<2>(atlas), ratio(2, 3));
}

TEST(MetricFieldNet, is_the_same_for_a_seed_and_in_the_unit_cube) {
  const MetricField<3> field(hills(3, ratio(1, 10)));
  const auto net = metric_field_net<3>(field, ratio(1, 9), 7, no_progress());
  EXPECT_EQ(net.centres, metric_field_net<3>(field, ratio(1, 9), 7, no_progress()).centres);
  EXPECT_NE(net.centres, metric_field_net<3>(field, ratio(1, 9), 8, no_progress()).centres);
  for (const auto& x : net.centres) {
    for (const Rational& coordinate : x) {
      EXPECT_GE(coordinate, Rational(0));
      EXPECT_LT(coordinate, Rational(1));
      EXPECT_LE(coordinate.denominator(), Integer(1) << 48);
    }
  }
}

TEST(MetricFieldNet, refuses_radii_that_fit_no_patch) {
  const MetricField<2> field(hills(2, ratio(1, 10)));
  EXPECT_THROW((void)metric_field_net<2>(field, Rational(0), 1, no_progress()), InputError);
  EXPECT_TRUE(mentions(message_of<Rejection>([&] { (void)metric_field_net<2>(field, ratio(1, 8), 1, no_progress()); }),
                       "hills: the radius of a net is below an eighth of the square root of the least eigenvalue"));
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
