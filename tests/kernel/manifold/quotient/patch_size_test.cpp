#include "kernel/manifold/quotient/patch_size.hpp"

#include <gtest/gtest.h>

#include "kernel/manifold/space_form_file.hpp"
#include "kernel/number/exact_text.hpp"
#include "tests/kernel/manifold/quotient/samples.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

TEST(PatchSize, is_bounded_by_the_injectivity_radius) {
  const SpaceForm form = verify_space_form(find_space_form("lens-space-5-2"));
  EXPECT_EQ(message_of<Rejection>([&] { require_small_patches(form, 3, ratio(6, 100), 9); }),
            "lens-space-5-2: 12 sampling radii are about 0.720000, more than the injectivity radius, of which about "
            "0.628319 is certified: take a sampling radius of at most 3/58");
  EXPECT_EQ(message_of<Rejection>([&] { require_small_patches(form, 3, ratio(5235, 100000), 9); }), "accepted");
  // Smaller patches leave room for a larger sampling radius.
  EXPECT_EQ(message_of<Rejection>([&] { require_small_patches(form, 3, ratio(6, 100), 7); }), "accepted");
}

TEST(PatchSize, on_a_sphere_is_below_a_right_angle) {
  const SpaceForm form = verify_space_form(find_space_form("sphere-2"));
  EXPECT_EQ(message_of<Rejection>([&] { require_small_patches(form, 2, ratio(1, 5), 9); }),
            "sphere-2: patches of radius about 1.800000 are no smaller than half of the sphere: take a sampling radius "
            "of at most 4/23");
  EXPECT_EQ(message_of<Rejection>([&] { require_small_patches(form, 2, ratio(1, 5), 7); }), "accepted");
  EXPECT_EQ(message_of<Rejection>([&] { require_small_patches(form, 2, ratio(17, 100), 9); }), "accepted");
}

TEST(PatchSize, of_a_flat_manifold_is_decided_exactly) {
  // The injectivity radius of the Klein bottle is 1/2.
  const SpaceForm form = verify_space_form(find_space_form("klein-bottle"));
  EXPECT_EQ(message_of<Rejection>([&] { require_small_patches(form, 2, ratio(1, 24), 9); }), "accepted");
  EXPECT_NE(message_of<Rejection>([&] { require_small_patches(form, 2, ratio(1, 24) + ratio(1, 1000000), 9); }),
            "accepted");
}

TEST(FittingPatchFactor, is_the_greatest_for_which_patches_are_small_enough) {
  const SpaceForm sphere = verify_space_form(find_space_form("sphere-2"));
  EXPECT_EQ(fitting_patch_factor(sphere, 2, ratio(17, 100)), 9);
  EXPECT_EQ(fitting_patch_factor(sphere, 2, ratio(1, 5)), 7);
  EXPECT_EQ(message_of<Rejection>([&] { (void)fitting_patch_factor(sphere, 2, ratio(23, 100)); }),
            "sphere-2: patches of radius about 1.610000 are no smaller than half of the sphere: take a sampling radius "
            "of at most 2/9");
  const SpaceForm klein_bottle = verify_space_form(find_space_form("klein-bottle"));
  EXPECT_EQ(fitting_patch_factor(klein_bottle, 2, ratio(1, 24)), 9);
  EXPECT_EQ(fitting_patch_factor(klein_bottle, 2, ratio(1, 20)), 7);
  EXPECT_EQ(message_of<Rejection>([&] { (void)fitting_patch_factor(klein_bottle, 2, ratio(1, 19)); }),
            "klein-bottle: 10 sampling radii are about 0.526316, more than the injectivity radius, of which about "
            "0.500000 is certified: take a sampling radius of at most 1/20");
  EXPECT_EQ(message_of<InputError>([&] { (void)fitting_patch_factor(klein_bottle, 2, Rational(0)); }),
            "klein-bottle: the sampling radius is not above 0");
}

TEST(PatchSize, what_a_refusal_advises_is_accepted_and_not_much_less_than_what_is) {
  for (const char* name : {"lens-space-5-2", "sphere-2", "klein-bottle", "bolza-surface"}) {
    const SpaceForm form = verify_space_form(find_space_form(name));
    const int dimension = form.form().dimension();
    const std::string refusal =
        message_of<Rejection>([&] { (void)fitting_patch_factor(form, dimension, ratio(1, 2)); });
    const std::size_t advice = refusal.rfind(" at most ");
    ASSERT_NE(advice, std::string::npos) << refusal;
    const Rational advised = parse_exact(refusal.substr(advice + 9));
    EXPECT_EQ(message_of<Rejection>([&] { (void)fitting_patch_factor(form, dimension, advised); }), "accepted") << name;
    EXPECT_NE(message_of<Rejection>([&] { (void)fitting_patch_factor(form, dimension, advised * ratio(33, 32)); }),
              "accepted")
        << name;
  }
}

TEST(PatchSize, wants_a_form_of_the_dimension_and_a_radius) {
  const SpaceForm form = verify_space_form(find_space_form("sphere-2"));
  EXPECT_EQ(message_of<InputError>([&] { require_small_patches(form, 3, ratio(1, 10), 9); }),
            "sphere-2 has dimension 2, expected 3");
  EXPECT_EQ(message_of<InputError>([&] { require_small_patches(form, 2, Rational(0), 9); }),
            "sphere-2: the sampling radius is not above 0");
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
