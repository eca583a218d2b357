#include "kernel/manifold/quotient/space_form_families.hpp"

#include <gtest/gtest.h>

#include <numeric>

#include "tests/kernel/manifold/quotient/samples.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

TEST(SpaceFormFamilies, lens_spaces_are_manifolds_exactly_when_p_and_q_are_coprime) {
  for (int p = 3; p <= 9; ++p) {
    for (int q = 1; q < p; ++q) {
      const std::string message = message_of<Rejection>([&] { (void)verify_space_form(lens_space(p, q)); });
      EXPECT_EQ(message == "accepted", std::gcd(p, q) == 1) << p << ", " << q << ": " << message;
    }
  }
  EXPECT_THROW((void)lens_space(2, 1), InputError);
}

TEST(SpaceFormFamilies, polygon_surfaces_of_several_genera) {
  for (const int genus : {2, 3}) {
    const SpaceForm form = verify_space_form(regular_polygon_surface(genus));
    EXPECT_EQ(form.cycles->euler_characteristic, 2 - 2 * genus);
    EXPECT_TRUE(form.is_orientable);
  }
  EXPECT_THROW((void)regular_polygon_surface(1), InputError);
}

/// The product of the Klein bottle with a circle is the first amphicosm.
TEST(SpaceFormFamilies, a_product_with_a_circle_has_a_summand_more) {
  const SpaceForm form = verify_space_form(product_with_circle(find_space_form("klein-bottle"), ratio(3, 4)));
  EXPECT_EQ(group_text(form.first_homology), "Z^2 + Z/2");
  EXPECT_FALSE(form.is_orientable);
  EXPECT_LE(form.injectivity_radius.lower, ratio(3, 8));
  EXPECT_GE(form.injectivity_radius.upper, ratio(3, 8));
  EXPECT_THROW((void)product_with_circle(find_space_form("sphere-2"), Rational(1)), InputError);
  EXPECT_THROW((void)product_with_circle(find_space_form("hantzsche-wendt"), Rational(1)), InputError);
  EXPECT_THROW((void)product_with_circle(find_space_form("klein-bottle"), Rational(0)), InputError);
}

TEST(SpaceFormFamilies, spheres_and_projective_spaces) {
  for (const int m : {2, 3}) {
    EXPECT_EQ(verify_space_form(sphere(m)).finite->elements.size(), 1U);
    EXPECT_EQ(verify_space_form(projective_space(m)).finite->elements.size(), 2U);
  }
  EXPECT_THROW((void)verify_space_form(sphere(4)), Rejection);
}

TEST(SpaceFormFamilies, double_cosines_lie_in_their_fields) {
  for (const int n : {1, 2, 3, 4, 5, 6, 7, 8, 12, 20}) {
    const auto field = real_cyclotomic_field(n);
    const BigInterval enclosure = double_cosine(field, n).enclosure();
    const BigInterval known = cosine((half_turn() + half_turn()) / BigInterval(n)) * BigInterval(2);
    EXPECT_FALSE(is_proved(less(enclosure, known)) || is_proved(less(known, enclosure))) << n;
  }
  EXPECT_EQ(real_cyclotomic_field(5)->degree(), 2);
  EXPECT_EQ(real_cyclotomic_field(20)->degree(), 4);
  EXPECT_EQ(real_cyclotomic_field(6), nullptr);
  EXPECT_THROW((void)real_cyclotomic_field(0), InputError);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
