#include "kernel/sample/metric_field_separation.hpp"

#include <gtest/gtest.h>

#include "tests/kernel/manifold/gluing/samples.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

MetricFieldAtlas<2> atlas_of(const std::vector<Vector<Rational, 2>>& points) {
  return {MetricField<2>(constant_field({{Rational(4), Rational(0)}, {Rational(0), Rational(1)}})), points,
          ratio(1, 14)};
}

TEST(MetricFieldSeparation, is_exact_to_its_last_digit) {
  // At the distance 1/28 = ε/2, which is a little more along the first axis.
  const Vector<Rational, 2> origin{};
  EXPECT_EQ(measure_separation<2>(atlas_of({origin, {Rational(0), ratio(1, 28)}})), ratio(1, 2));
  EXPECT_EQ(measure_separation<2>(atlas_of({origin, {ratio(1, 56), Rational(0)}})), ratio(1, 2));
  const Rational less = ratio(1, 28) - Rational::power_of_two(-40);
  EXPECT_EQ(measure_separation<2>(atlas_of({origin, {Rational(0), less}})), ratio(1, 2) - Rational::power_of_two(-20));
  // At most 1.
  EXPECT_EQ(measure_separation<2>(atlas_of({origin, {ratio(1, 2), ratio(1, 2)}})), Rational(1));
}

TEST(MetricFieldSeparation, sees_lifts) {
  EXPECT_EQ(measure_separation<2>(atlas_of({{Rational(0), ratio(1, 56)}, {Rational(0), ratio(55, 56)}})), ratio(1, 2));
}

TEST(MetricFieldSeparation, is_the_least_in_all_charts) {
  // The second chart has shorter units: f = 1 + cos/2 is 3/2 at 0.
  const MetricField<2> field(hills(2, ratio(1, 2)));
  const MetricFieldAtlas<2> atlas(field, {{Rational(0), Rational(0)}, {ratio(1, 20), Rational(0)}}, ratio(1, 16));
  const Rational separation = measure_separation<2>(atlas);
  const auto& smaller = atlas.chart(Label(1)).matrix()[0][0];
  EXPECT_LT(smaller, atlas.chart(Label(0)).matrix()[0][0]);
  EXPECT_LE(separation, smaller * ratio(16, 20));
  EXPECT_GE(separation, smaller * ratio(16, 20) - Rational::power_of_two(-20));
}

TEST(MetricFieldSeparation, names_points_that_coincide) {
  const Vector<Rational, 2> x{ratio(1, 3), ratio(1, 3)};
  EXPECT_EQ(message_of<InputError>([&] {
              (void)measure_separation<2>(atlas_of({x, x}));
            }),
            "labels 0 and 1 are points closer than 2^-20 times the sampling radius, or the same");
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
