#include "kernel/manifold/quotient/injectivity_radius.hpp"

#include <gtest/gtest.h>

#include "kernel/manifold/quotient/space_form.hpp"
#include "kernel/manifold/quotient/space_form_families.hpp"
#include "kernel/manifold/space_form_file.hpp"
#include "tests/kernel/manifold/quotient/samples.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

/// The bounds contain the value and are close; bounds moved by 2⁻²⁰ would not contain it.
void expect_radius(const InjectivityRadius& radius, const BigInterval& value) {
  EXPECT_LE(radius.lower, value.upper());
  EXPECT_GE(radius.upper, value.lower());
  EXPECT_LE(radius.upper - radius.lower, Rational::power_of_two(-14));
  EXPECT_GT(radius.lower + Rational::power_of_two(-12), value.upper());
}

BigInterval half_angle(int parts) { return half_turn() / BigInterval(parts); }

InjectivityRadius spherical(const SpaceFormDescription& description) {
  return injectivity_radius(description.form, closure(description.form, description.generators, 200));
}

TEST(InjectivityRadius, of_spheres_and_projective_spaces) {
  expect_radius(spherical(sphere(2)), half_turn());
  expect_radius(spherical(sphere(3)), half_turn());
  expect_radius(spherical(projective_space(2)), half_angle(2));
  expect_radius(spherical(projective_space(3)), half_angle(2));
}

TEST(InjectivityRadius, of_homogeneous_spherical_spaces_is_half_the_least_angle) {
  expect_radius(spherical(find_space_form("quaternion-space")), half_angle(4));
  expect_radius(spherical(find_space_form("poincare-sphere")), half_angle(10));
  expect_radius(spherical(lens_space(5, 1)), half_angle(5));
  expect_radius(spherical(lens_space(12, 1)), half_angle(12));
}

TEST(InjectivityRadius, of_lens_spaces_is_the_least_over_the_powers) {
  // The kth power turns by 2πk/p and 2πkq/p, and moves some point by the lesser of both: 2π/p for k = 1.
  for (const int q : {2, 3}) expect_radius(spherical(lens_space(7, q)), half_angle(7));
}

TEST(InjectivityRadius, of_flat_manifolds_from_exact_squares) {
  CrystallographicGroup group;
  group.squared_displacement = Rational(2);
  expect_radius(injectivity_radius(group), square_root(BigInterval(2)) / BigInterval(2));
}

TEST(InjectivityRadius, of_hyperbolic_surfaces_is_half_the_known_systole) {
  // Bolza: 2 arcosh(1 + √2). Klein: 3.935946…
  expect_radius(verify_space_form(find_space_form("bolza-surface")).injectivity_radius,
                area_cosine(BigInterval(1) + square_root(BigInterval(2))));
  const InjectivityRadius klein = verify_space_form(find_space_form("klein-quartic")).injectivity_radius;
  EXPECT_GT(klein.lower, ratio(39359, 20000));
  EXPECT_LT(klein.upper, ratio(39360, 20000));
}

TEST(InjectivityRadius, translation_lengths_of_known_elements) {
  const auto plane = InvariantForm::standard(Curvature::negative, 2);
  const auto space = InvariantForm::standard(Curvature::negative, 3);
  const BigInterval length = area_cosine(BigInterval(ratio(5, 4)));
  const auto expect_length = [&](const InvariantForm& form, const FieldMatrix& element) {
    ASSERT_FALSE(form.why_no_isometry(element).has_value());
    const BigInterval found = translation_length(form, element);
    EXPECT_TRUE(is_undecided(less(found, length)));
    EXPECT_LE(found.upper() - found.lower(), Rational::power_of_two(-50));
  };
  expect_length(plane, matrix(nullptr, {{"5/4", "3/4", "0"}, {"3/4", "5/4", "0"}, {"0", "0", "1"}}));
  expect_length(plane, matrix(nullptr, {{"5/4", "3/4", "0"}, {"3/4", "5/4", "0"}, {"0", "0", "-1"}}));
  const auto in_space = [&](const std::vector<std::vector<std::string>>& turn) {
    FieldMatrix element = matrix(nullptr, {{"5/4", "3/4", "0", "0"},
                                           {"3/4", "5/4", "0", "0"},
                                           {"0", "0", turn[0][0], turn[0][1]},
                                           {"0", "0", turn[1][0], turn[1][1]}});
    expect_length(space, element);
  };
  in_space({{"1", "0"}, {"0", "1"}});
  in_space({{"-1", "0"}, {"0", "-1"}});
  in_space({{"3/5", "-4/5"}, {"4/5", "3/5"}});
  in_space({{"0", "1"}, {"1", "0"}});
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
