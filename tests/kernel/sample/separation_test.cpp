#include "kernel/sample/separation.hpp"

#include <gtest/gtest.h>

#include "kernel/manifold/flat_atlas.hpp"
#include "kernel/manifold/gluing/metric_field_atlas.hpp"
#include "kernel/manifold/quotient/space_form_atlas.hpp"
#include "kernel/manifold/space_form_file.hpp"
#include "kernel/sample/lattice_net.hpp"
#include "kernel/sample/space_form_net.hpp"
#include "tests/kernel/manifold/exhaustive.hpp"
#include "tests/kernel/manifold/gluing/samples.hpp"
#include "tests/kernel/manifold/quotient/samples.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

TEST(SeparationOnSpaceForms, of_a_maximal_poisson_disk_set_is_one) {
  const SpaceForm form = verify_space_form(find_space_form("bolza-surface"));
  const Rational radius = ratio(1, 8);
  const auto net = space_form_net<2>(form, radius, 1, no_progress());
  EXPECT_EQ(measure_separation<2>(SpaceFormAtlas<2>(form, net.centres, radius)), Rational(1));
  // For a larger sampling radius it is the quotient; the net comes quite close to its radius.
  const Rational larger = measure_separation<2>(SpaceFormAtlas<2>(form, net.centres, ratio(5, 32), 6));
  EXPECT_GE(larger, ratio(4, 5) - Rational::power_of_two(-20));
  EXPECT_LE(larger, ratio(4, 5) * ratio(101, 100));
}

TEST(SeparationOnSpaceForms, is_exact_to_its_last_digit) {
  // Two points of the sphere at the distance 2 arctan(1/16) from each other.
  const SpaceForm form = verify_space_form(find_space_form("sphere-2"));
  const SpaceFormAtlas<2> atlas(form, {{Rational(0), Rational(0)}, {ratio(1, 8), Rational(0)}}, ratio(13, 100));
  const Rational separation = measure_separation<2>(atlas);
  const BigInterval distance = arctangent(BigInterval(ratio(1, 16))) * BigInterval(2);
  EXPECT_TRUE(is_proved(less(BigInterval(separation * ratio(13, 100)), distance)));
  EXPECT_TRUE(is_refuted(less(BigInterval((separation + Rational::power_of_two(-20)) * ratio(13, 100)), distance)));
}

TEST(SeparationOnSpaceForms, sees_lifts) {
  // On the projective plane two points near the border of the half-sphere, opposite to each other, are close.
  const SpaceForm form = verify_space_form(find_space_form("projective-plane"));
  const SpaceFormAtlas<2> atlas(form, {{ratio(31, 16), Rational(0)}, {ratio(-31, 16), Rational(0)}}, ratio(1, 8));
  EXPECT_LT(measure_separation<2>(atlas), ratio(6, 10));
}

TEST(SeparationOnSpaceForms, names_points_that_coincide) {
  const SpaceForm form = verify_space_form(find_space_form("projective-plane"));
  const auto message = [&](const Vector<Rational, 2>& a, const Vector<Rational, 2>& b) {
    return message_of<InputError>([&] { (void)measure_separation<2>(SpaceFormAtlas<2>(form, {a, b}, ratio(1, 8))); });
  };
  const std::string expected = "labels 0 and 1 are points closer than 2^-20 times the sampling radius, or the same";
  EXPECT_EQ(message({ratio(1, 3), Rational(0)}, {ratio(1, 3), Rational(0)}), expected);
  EXPECT_EQ(message({Rational(2), Rational(0)}, {Rational(-2), Rational(0)}), expected);
  EXPECT_EQ(message({ratio(1, 3), Rational(0)}, {ratio(1, 2), Rational(0)}), "accepted");
}

MetricFieldAtlas<2> atlas_of(const std::vector<Vector<Rational, 2>>& points) {
  return {MetricField<2>(constant_field({{Rational(4), Rational(0)}, {Rational(0), Rational(1)}})), points,
          ratio(1, 14)};
}

TEST(SeparationOnMetricFields, is_exact_to_its_last_digit) {
  // At the distance 1/28 = ε/2, which is a little more along the first axis.
  const Vector<Rational, 2> origin{};
  EXPECT_EQ(measure_separation<2>(atlas_of({origin, {Rational(0), ratio(1, 28)}})), ratio(1, 2));
  EXPECT_EQ(measure_separation<2>(atlas_of({origin, {ratio(1, 56), Rational(0)}})), ratio(1, 2));
  const Rational less = ratio(1, 28) - Rational::power_of_two(-40);
  EXPECT_EQ(measure_separation<2>(atlas_of({origin, {Rational(0), less}})), ratio(1, 2) - Rational::power_of_two(-20));
  // At most 1.
  EXPECT_EQ(measure_separation<2>(atlas_of({origin, {ratio(1, 2), ratio(1, 2)}})), Rational(1));
}

TEST(SeparationOnMetricFields, sees_lifts) {
  EXPECT_EQ(measure_separation<2>(atlas_of({{Rational(0), ratio(1, 56)}, {Rational(0), ratio(55, 56)}})), ratio(1, 2));
}

TEST(SeparationOnMetricFields, is_the_least_in_all_charts) {
  // The second chart has shorter units: f = 1 + cos/2 is 3/2 at 0.
  const MetricField<2> field(hills(2, ratio(1, 2)));
  const MetricFieldAtlas<2> atlas(field, {{Rational(0), Rational(0)}, {ratio(1, 20), Rational(0)}}, ratio(1, 16));
  const Rational separation = measure_separation<2>(atlas);
  const auto& smaller = atlas.chart(Label(1)).matrix()[0][0];
  EXPECT_LT(smaller, atlas.chart(Label(0)).matrix()[0][0]);
  EXPECT_LE(separation, smaller * ratio(16, 20));
  EXPECT_GE(separation, smaller * ratio(16, 20) - Rational::power_of_two(-20));
}

TEST(SeparationOnMetricFields, names_points_that_coincide) {
  const Vector<Rational, 2> x{ratio(1, 3), ratio(1, 3)};
  EXPECT_EQ(message_of<InputError>([&] {
              (void)measure_separation<2>(atlas_of({x, x}));
            }),
            "labels 0 and 1 are points closer than 2^-20 times the sampling radius, or the same");
}

template <int m>
Rational separation_of(const FlatSpace<m>& space, const ExactPoints<m>& points, const Rational& sampling_radius) {
  return measure_separation<m>(FlatAtlas<m>(space, PointSet<m>(points), sampling_radius));
}

/// The largest multiple of 2⁻²⁰ that is at most 1 and at most distance/ε.
void expect_separation(const Rational& measured, const Rational& squared_distance, const Rational& sampling_radius) {
  const Rational step = Rational::power_of_two(-20);
  EXPECT_EQ(rounded_down(measured, -20), measured);
  EXPECT_LE(square(measured * sampling_radius), squared_distance);
  EXPECT_TRUE(measured == Rational(1) || square((measured + step) * sampling_radius) > squared_distance);
}

TEST(SeparationOnFlatManifolds, of_lattices_is_capped_at_1) {
  LatticeNet tenths;
  tenths.divisions = 10;
  EXPECT_EQ(separation_of<2>(cubic_torus<2>(), lattice_net<2>(cubic_torus<2>(), tenths), ratio(8, 100)), Rational(1));
  EXPECT_EQ(separation_of<2>(cubic_torus<2>(), lattice_net<2>(cubic_torus<2>(), tenths), ratio(1, 10)), Rational(1));
  const Rational radius = ratio(1, 9);
  const Rational measured = separation_of<2>(cubic_torus<2>(), lattice_net<2>(cubic_torus<2>(), tenths), radius);
  expect_separation(measured, ratio(1, 100), radius);
  EXPECT_LT(measured, Rational(1));
}

TEST(SeparationOnFlatManifolds, is_the_least_distance_of_all_pairs_of_lifts) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const auto space = skewed_torus();
    const auto points = random_points<3>(30, seed, 12, Rational(-2), Rational(4));
    const Rational radius = ratio(1, 2);
    Rational least = square(radius);
    for (std::uint32_t index = 0; index < points.size(); ++index) {
      for (const auto& lift : lifts_within<3>(space, points, points[index], radius)) {
        if (lift == Lift<3>{index, {}}) continue;
        least = minimum(least, squared_distance<3>(space, at<3>(points, lift), points[index]));
      }
    }
    expect_separation(separation_of<3>(space, points, radius), least, radius);
  }
}

TEST(SeparationOnFlatManifolds, counts_the_lifts_of_one_point) {
  // The only point of a short circle: its neighbours are its own lifts.
  EXPECT_EQ(separation_of<1>(cubic_torus<1>(), {{ratio(1, 3)}}, Rational(2)), ratio(1, 2));
}

TEST(SeparationOnFlatManifolds, names_labels_that_coincide_or_nearly_do) {
  const auto refusal = [](const ExactPoints<2>& points) {
    return message_of<InputError>([&] { (void)separation_of<2>(cubic_torus<2>(), points, ratio(1, 4)); });
  };
  const ExactPoints<2> same{{Rational(0), ratio(1, 2)}, {ratio(1, 3), Rational(0)}, {Rational(0), ratio(1, 2)}};
  EXPECT_TRUE(mentions(refusal(same), "labels 0 and 2")) << refusal(same);
  // The same point of the torus, at another lift.
  const ExactPoints<2> lifted{{ratio(1, 3), Rational(0)}, {Rational(0), ratio(1, 2)}, {ratio(4, 3), Rational(-5)}};
  EXPECT_TRUE(mentions(refusal(lifted), "labels 0 and 2"));
  const Rational limit = ratio(1, 4) * Rational::power_of_two(-20);
  const ExactPoints<2> close{{Rational(0), Rational(0)}, {limit * ratio(999, 1000), Rational(0)}};
  EXPECT_TRUE(mentions(refusal(close), "labels 0 and 1"));
  const ExactPoints<2> at_the_limit{{Rational(0), Rational(0)}, {limit, Rational(0)}};
  EXPECT_EQ(separation_of<2>(cubic_torus<2>(), at_the_limit, ratio(1, 4)), Rational::power_of_two(-20));
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
