#include "kernel/sample/space_form_separation.hpp"

#include <gtest/gtest.h>

#include "kernel/manifold/space_form_file.hpp"
#include "kernel/sample/space_form_net.hpp"
#include "tests/kernel/manifold/quotient/samples.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

TEST(SpaceFormSeparation, of_a_maximal_poisson_disk_set_is_one) {
  const SpaceForm form = verify_space_form(find_space_form("bolza-surface"));
  const Rational radius = ratio(1, 8);
  const auto net = space_form_net<2>(form, radius, 1, no_progress());
  EXPECT_EQ(measure_separation<2>(SpaceFormAtlas<2>(form, net.centres, radius)), Rational(1));
  // For a larger sampling radius it is the quotient; the net comes quite close to its radius.
  const Rational larger = measure_separation<2>(SpaceFormAtlas<2>(form, net.centres, ratio(5, 32), 6));
  EXPECT_GE(larger, ratio(4, 5) - Rational::power_of_two(-20));
  EXPECT_LE(larger, ratio(4, 5) * ratio(101, 100));
}

TEST(SpaceFormSeparation, is_exact_to_its_last_digit) {
  // Two points of the sphere at the distance 2 arctan(1/16) from each other.
  const SpaceForm form = verify_space_form(find_space_form("sphere-2"));
  const SpaceFormAtlas<2> atlas(form, {{Rational(0), Rational(0)}, {ratio(1, 8), Rational(0)}}, ratio(13, 100));
  const Rational separation = measure_separation<2>(atlas);
  const BigInterval distance = arctangent(BigInterval(ratio(1, 16))) * BigInterval(2);
  EXPECT_TRUE(is_proved(less(BigInterval(separation * ratio(13, 100)), distance)));
  EXPECT_TRUE(is_refuted(less(BigInterval((separation + Rational::power_of_two(-20)) * ratio(13, 100)), distance)));
}

TEST(SpaceFormSeparation, sees_lifts) {
  // On the projective plane two points near the border of the half-sphere, opposite to each other, are close.
  const SpaceForm form = verify_space_form(find_space_form("projective-plane"));
  const SpaceFormAtlas<2> atlas(form, {{ratio(31, 16), Rational(0)}, {ratio(-31, 16), Rational(0)}}, ratio(1, 8));
  EXPECT_LT(measure_separation<2>(atlas), ratio(6, 10));
}

TEST(SpaceFormSeparation, names_points_that_coincide) {
  const SpaceForm form = verify_space_form(find_space_form("projective-plane"));
  const auto message = [&](const Vector<Rational, 2>& a, const Vector<Rational, 2>& b) {
    return message_of<InputError>([&] { (void)measure_separation<2>(SpaceFormAtlas<2>(form, {a, b}, ratio(1, 8))); });
  };
  const std::string expected = "labels 0 and 1 are points closer than 2^-20 times the sampling radius, or the same";
  EXPECT_EQ(message({ratio(1, 3), Rational(0)}, {ratio(1, 3), Rational(0)}), expected);
  EXPECT_EQ(message({Rational(2), Rational(0)}, {Rational(-2), Rational(0)}), expected);
  EXPECT_EQ(message({ratio(1, 3), Rational(0)}, {ratio(1, 2), Rational(0)}), "accepted");
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
