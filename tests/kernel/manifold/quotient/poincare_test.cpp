#include "kernel/manifold/quotient/poincare.hpp"

#include <gtest/gtest.h>

#include "kernel/manifold/quotient/space_form_families.hpp"
#include "kernel/manifold/space_form_file.hpp"
#include "tests/kernel/manifold/quotient/samples.hpp"
#include "tests/kernel/manifold/quotient/side_pairings.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

PoincareResult verified(const InvariantForm& form, const SidePairings& pairings) {
  const auto polyhedron =
      dirichlet_polyhedron(form, pairings.elements, pairings.names, ElementsWithoutSide::are_left_out);
  return verify_poincare(form, polyhedron, pairings.names);
}

std::string refusal(const InvariantForm& form, const SidePairings& pairings) {
  return message_of<Rejection>([&] { (void)verified(form, pairings); });
}

TEST(Poincare, regular_polygons_with_opposite_sides_paired) {
  for (const int genus : {2, 3, 5}) {
    const auto description = regular_polygon_surface(genus);
    const PoincareResult result = verified(description.form, with_inverses(description));
    ASSERT_EQ(result.cycles.size(), 1U);
    EXPECT_EQ(result.cycles[0].sides.size(), static_cast<std::size_t>(4 * genus));
    EXPECT_EQ(result.euler_characteristic, 2 - 2 * genus);
    EXPECT_EQ(group_text(result.abelianisation), "Z^" + std::to_string(2 * genus));
    const BigInterval full = half_turn() + half_turn();
    EXPECT_TRUE(is_undecided(less(result.cycles[0].angle_sum, full)));
  }
}

TEST(Poincare, klein_quartic_has_two_cycles_of_seven) {
  const auto description = find_space_form("klein-quartic");
  const PoincareResult result = verified(description.form, with_inverses(description));
  ASSERT_EQ(result.cycles.size(), 2U);
  EXPECT_EQ(result.cycles[0].sides.size(), 7U);
  EXPECT_EQ(result.cycles[1].sides.size(), 7U);
  EXPECT_EQ(result.euler_characteristic, -4);
  EXPECT_EQ(group_text(result.abelianisation), "Z^6");
}

TEST(Poincare, seifert_weber_space_has_six_cycles_of_five) {
  const auto description = find_space_form("seifert-weber-space");
  const PoincareResult result = verified(description.form, with_inverses(description));
  ASSERT_EQ(result.cycles.size(), 6U);
  for (const RidgeCycle& cycle : result.cycles) EXPECT_EQ(cycle.sides.size(), 5U);
  EXPECT_EQ(result.euler_characteristic, 0);
  EXPECT_EQ(group_text(result.abelianisation), "(Z/5)^3");
}

// Flat and spherical groups are verified in another way; that their Dirichlet polyhedra fulfil the conditions, with the
// same first homology, checks both.

TEST(Poincare, agrees_with_crystallographic_groups) {
  for (const std::string name : {"klein-bottle", "flat-torus-3", "flat-half-turn", "flat-third-turn",
                                 "flat-quarter-turn", "flat-sixth-turn", "hantzsche-wendt", "flat-first-amphicosm",
                                 "flat-second-amphicosm", "flat-first-amphidicosm", "flat-second-amphidicosm"}) {
    const auto description = find_space_form(name);
    const auto group = crystallographic_group(description.form, description.generators);
    // Far enough for all sides: no cell reaches farther from its centre than 1.
    const auto near = short_elements(description.form, group, Rational(4));
    const PoincareResult result = verified(description.form, numbered(near));
    EXPECT_EQ(result.euler_characteristic, 0) << name;
    EXPECT_EQ(group_text(result.abelianisation), group_text(group.abelianisation)) << name;
  }
}

TEST(Poincare, agrees_with_finite_groups) {
  for (const std::string name : {"quaternion-space", "poincare-sphere"}) {
    const auto description = find_space_form(name);
    const auto group = closure(description.form, description.generators, 200);
    std::vector<FieldMatrix> near;
    for (const FieldMatrix& element : group.elements) {
      // The antipode of o has no side of its own; the others beyond a right angle neither.
      if (element(0, 0).sign() >= 0) near.push_back(element);
    }
    const PoincareResult result = verified(description.form, numbered(near));
    EXPECT_EQ(result.euler_characteristic, 0) << name;
    EXPECT_EQ(group_text(result.abelianisation), group_text(group.abelianisation)) << name;
  }
}

/// The octagon's pairings, some of them followed by the reflection in their axis: glide reflections.
SpaceFormDescription octagon_with_glides(bool first, bool third) {
  auto description = regular_polygon_surface(2);
  FieldMatrix reflection = FieldMatrix::identity(3);
  reflection(2, 2) = FieldElement(-1);
  if (first) description.generators[0] = description.generators[0] * reflection;
  reflection(2, 2) = FieldElement(1);
  reflection(1, 1) = FieldElement(-1);
  if (third) description.generators[2] = description.generators[2] * reflection;
  return description;
}

TEST(Poincare, other_pairings_give_another_surface_or_none) {
  // One glide reflection: still one class of vertices, so a surface, which is not orientable.
  const auto surface = octagon_with_glides(true, false);
  const PoincareResult result = verified(surface.form, with_inverses(surface));
  EXPECT_EQ(result.euler_characteristic, -2);
  EXPECT_EQ(group_text(result.abelianisation), "Z^3 + Z/2");
  // Two: two classes of four, with half a turn each.
  const auto none = octagon_with_glides(true, true);
  const std::string message = refusal(none.form, with_inverses(none));
  EXPECT_TRUE(mentions(message, "the product is not 1; the dihedral angles sum up to 3.14159")) << message;
}

/// The regular octagon whose opposite sides are 2ρ apart, cosh 2ρ = 8cos²(α/2)/(2 − 2cos π/4) − 1, α the angle.
SpaceFormDescription octagon(const Rational& squared_cosine_of_half_angle) {
  const auto field = real_cyclotomic_field(8);
  const FieldElement root = double_cosine(field, 8);
  const FieldElement boost =
      FieldElement(Rational(8) * squared_cosine_of_half_angle) / (FieldElement(2) - root) - FieldElement(1);
  const FieldElement stretch = boost * boost - FieldElement(1);
  FieldMatrix translation = FieldMatrix::identity(3);
  translation(0, 0) = boost;
  translation(0, 1) = FieldElement(1);
  translation(1, 0) = stretch;
  translation(1, 1) = boost;
  FieldMatrix eighth = FieldMatrix::identity(3);
  eighth(1, 1) = eighth(2, 2) = root / FieldElement(2);
  eighth(2, 1) = FieldElement(1);
  eighth(1, 2) = FieldElement(ratio(-1, 2));
  FieldMatrix gram = FieldMatrix::identity(2);
  gram(1, 1) = FieldElement(ratio(1, 2));
  SpaceFormDescription result{"octagon", InvariantForm(-stretch, gram), {}, {}, {}};
  FieldMatrix turn = FieldMatrix::identity(3);
  for (int k = 0; k < 4; ++k) {
    result.generators.push_back(turn * translation * inverse(turn));
    EXPECT_FALSE(result.form.why_no_isometry(result.generators.back()).has_value());
    turn = turn * eighth;
  }
  return result;
}

TEST(Poincare, refuses_angles_that_do_not_fit) {
  // Angles of 90°: eight of them are two full turns, and the product is 1. Angles of 120°: it is not.
  const auto right_angled = octagon(ratio(1, 2));
  EXPECT_TRUE(mentions(refusal(right_angled.form, with_inverses(right_angled)),
                       ": the dihedral angles sum up to 12.566371, expected 2π"))
      << refusal(right_angled.form, with_inverses(right_angled));
  const auto wide = octagon(ratio(1, 4));
  EXPECT_TRUE(mentions(refusal(wide.form, with_inverses(wide)),
                       ": the product is not 1; the dihedral angles sum up to 16.755161, expected 2π"))
      << refusal(wide.form, with_inverses(wide));
}

TEST(Poincare, refuses_elements_that_fix_only_vertices) {
  // Three glide reflections generate the space group Pbca, whose polyhedron about o is a cube. They fix nothing on
  // sides and ridges, but the vertices are centres of inversions of the group.
  const SpaceFormDescription group{
      "Pbca",
      InvariantForm::standard(Curvature::zero, 3),
      {matrix(nullptr, {{"1", "0", "0", "0"}, {"0", "-1", "0", "0"}, {"1/2", "0", "1", "0"}, {"0", "0", "0", "1"}}),
       matrix(nullptr, {{"1", "0", "0", "0"}, {"0", "1", "0", "0"}, {"0", "0", "-1", "0"}, {"1/2", "0", "0", "1"}}),
       matrix(nullptr, {{"1", "0", "0", "0"}, {"1/2", "1", "0", "0"}, {"0", "0", "1", "0"}, {"0", "0", "0", "-1"}})},
      {},
      {}};
  const std::string message = refusal(group.form, with_inverses(group));
  EXPECT_TRUE(mentions(message, "the link of vertex")) << message;
  EXPECT_TRUE(mentions(message, "has twice the Euler characteristic 2, expected 4: an element fixes the vertex"))
      << message;
  // The other verification finds the inversion itself.
  EXPECT_TRUE(mentions(message_of<Rejection>([&] { (void)crystallographic_group(group.form, group.generators); }),
                       "x ↦ [[-1, 0, 0], [0, -1, 0], [0, 0, -1]]x"));
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
