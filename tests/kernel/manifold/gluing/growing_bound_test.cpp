#include "kernel/manifold/gluing/growing_bound.hpp"

#include <gtest/gtest.h>

#include "tests/kernel/manifold/gluing/samples.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

TEST(GrowingBound, grows_until_it_suffices_and_no_farther) {
  const RoundingGuard guard;
  GrowingBound bound(0.5);
  const auto above = [](double x) { return [x](const Interval& value) { return less(Interval::exactly(x), value); }; };
  bound.grow_until(above(0.1));
  EXPECT_GT(bound.value(), 0.1);
  EXPECT_LT(bound.value(), 0.1 * 33 / 32 + 1e-9);
  const double before = bound.value();
  bound.grow_until(above(0.05));
  EXPECT_EQ(bound.value(), before);
  EXPECT_TRUE(bound.is_below_limit());
  EXPECT_GE(bound.rounded(), Rational::exactly(before));
  EXPECT_LE(bound.rounded(), Rational::exactly(before) * ratio(1001, 1000));
  bound.grow_until(above(2));
  EXPECT_FALSE(bound.is_below_limit());
}

TEST(GrowingBound, compares_quadratic_forms) {
  const RoundingGuard guard;
  const Matrix<Interval, 2> one{{{Interval(1), Interval(0)}, {Interval(0), Interval(1)}}};
  const Matrix<Interval, 2> other{{{Interval(1), Interval(0)}, {Interval(0), Interval(2)}}};
  // Lengths differ by a factor of √2.
  EXPECT_TRUE(is_proved(is_within(other, Interval::exactly(0.42), one)));
  EXPECT_FALSE(is_proved(is_within(other, Interval::exactly(0.41), one)));
  EXPECT_TRUE(is_proved(is_within(one, Interval::exactly(0.30), other)));
  EXPECT_FALSE(is_proved(is_within(one, Interval::exactly(0.29), other)));
}

TEST(GrowingBound, makes_patches_smaller_until_they_are_measured) {
  const MetricField<2> flat(constant_field(multiple_of_identity(2, Rational(1))));
  MetricFieldAtlas<2> atlas(flat, lattice_points<2>(2), ratio(1, 28));
  const auto measured_at = [&](int factor) {
    return fitted_patches<2>(atlas, "x", ratio(1, 2), [&](const Rational& limit) -> std::optional<Rational> {
      if (atlas.patch_factor() > factor) return std::nullopt;
      return limit;
    });
  };
  EXPECT_EQ(measured_at(7), ratio(1, 4));
  EXPECT_EQ(atlas.patch_factor(), 7);
  EXPECT_EQ(measured_at(4), ratio(1, 2));
  EXPECT_TRUE(mentions(message_of<Rejection>([&] { (void)measured_at(3); }), "x: charts are distorted by 1/2 or more"));
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
