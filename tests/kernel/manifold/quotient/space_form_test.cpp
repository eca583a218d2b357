#include "kernel/manifold/quotient/space_form.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "kernel/manifold/quotient/space_form_families.hpp"
#include "kernel/manifold/space_form_file.hpp"
#include "tests/kernel/manifold/quotient/samples.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

struct Member {
  std::string name;
  int curvature;
  bool orientable;
  std::string homology;
};

TEST(SpaceForm, every_member_is_verified_with_its_known_homology) {
  const std::vector<Member> members{{"bolza-surface", -1, true, "Z^4"},
                                    {"flat-first-amphicosm", 0, false, "Z^2 + Z/2"},
                                    {"flat-first-amphidicosm", 0, false, "Z + (Z/2)^2"},
                                    {"flat-half-turn", 0, true, "Z + (Z/2)^2"},
                                    {"flat-quarter-turn", 0, true, "Z + Z/2"},
                                    {"flat-second-amphicosm", 0, false, "Z^2"},
                                    {"flat-second-amphidicosm", 0, false, "Z + Z/4"},
                                    {"flat-sixth-turn", 0, true, "Z"},
                                    {"flat-third-turn", 0, true, "Z + Z/3"},
                                    {"flat-torus-3", 0, true, "Z^3"},
                                    {"hantzsche-wendt", 0, true, "(Z/4)^2"},
                                    {"klein-bottle", 0, false, "Z + Z/2"},
                                    {"klein-quartic", -1, true, "Z^6"},
                                    {"lens-space-5-2", 1, true, "Z/5"},
                                    {"lens-space-7-2", 1, true, "Z/7"},
                                    {"poincare-sphere", 1, true, "0"},
                                    {"projective-plane", 1, false, "Z/2"},
                                    {"projective-space-3", 1, true, "Z/2"},
                                    {"quaternion-space", 1, true, "(Z/2)^2"},
                                    {"regular-polygon-surface-3", -1, true, "Z^6"},
                                    {"seifert-weber-space", -1, true, "(Z/5)^3"},
                                    {"sphere-2", 1, true, "0"},
                                    {"sphere-3", 1, true, "0"}};
  ASSERT_EQ(builtin_space_forms().size(), members.size());
  for (const Member& member : members) {
    const SpaceForm form = verify_space_form(find_space_form(member.name));
    EXPECT_EQ(form.description.name, member.name);
    EXPECT_EQ(sign_of(form.form().curvature()), member.curvature) << member.name;
    EXPECT_EQ(form.is_orientable, member.orientable) << member.name;
    EXPECT_EQ(group_text(form.first_homology), member.homology) << member.name;
    EXPECT_GT(form.injectivity_radius.lower, Rational(0)) << member.name;
    EXPECT_LE(form.injectivity_radius.lower, form.injectivity_radius.upper) << member.name;
  }
}

TEST(SpaceForm, orders_of_finite_groups_are_known) {
  const auto order = [](const std::string& name) {
    return verify_space_form(find_space_form(name)).finite->elements.size();
  };
  EXPECT_EQ(order("sphere-3"), 1U);
  EXPECT_EQ(order("projective-space-3"), 2U);
  EXPECT_EQ(order("lens-space-7-2"), 7U);
  EXPECT_EQ(order("quaternion-space"), 8U);
  EXPECT_EQ(order("poincare-sphere"), 120U);
}

TEST(SpaceForm, flat_members_are_scaled_to_a_least_displacement_of_1) {
  for (const BuiltinManifold& builtin : builtin_space_forms()) {
    const auto description = find_space_form(builtin.name);
    if (description.form.curvature() != Curvature::zero) continue;
    EXPECT_EQ(verify_space_form(description).crystallographic->squared_displacement, Rational(1)) << builtin.name;
  }
}

TEST(SpaceForm, elements_within_a_radius) {
  EXPECT_EQ(verify_space_form(find_space_form("quaternion-space")).elements_within(Rational(1)).size(), 8U);
  EXPECT_EQ(verify_space_form(find_space_form("klein-bottle")).elements_within(Rational(1)).size(), 5U);
  // The octagon's own tile and, at twice the inradius, 2 arcosh(1 + √2) = 3.057, its eight neighbours across sides.
  const SpaceForm bolza = verify_space_form(find_space_form("bolza-surface"));
  EXPECT_EQ(bolza.elements_within(ratio(305, 100)).size(), 1U);
  EXPECT_EQ(bolza.elements_within(ratio(306, 100)).size(), 9U);
}

/// What is said of the member whose file has this text replaced, once, by that.
std::string refusal(const std::string& name, const std::string& wanted, const std::string& replacement) {
  const auto& all = builtin_space_forms();
  const auto file = std::find_if(all.begin(), all.end(), [&](const BuiltinManifold& x) { return x.name == name; });
  if (file == all.end()) return "no such member";
  std::string text = file->text;
  const std::size_t at = text.find(wanted);
  if (at == std::string::npos) return "no such text";
  text.replace(at, wanted.size(), replacement);
  return message_of<std::runtime_error>([&] { (void)verify_space_form(parse_space_form(text, name + ".toml")); });
}

TEST(SpaceForm, wrong_groups_are_refused_with_the_reason) {
  struct Wrong {
    std::string name, wanted, replacement, reason;
  };
  const std::vector<Wrong> all{
      // No isometry.
      {"quaternion-space", "\"1\"", "\"2\"", "quaternion-space: generator 1: does not preserve the form"},
      {"poincare-sphere", "\"1/2\", \"-1/2\"", "\"1/3\", \"-1/2\"", "generator 1: does not preserve the form"},
      {"poincare-sphere", "1/2*t - 1/2", "1/2*t - 1/3", "generator 2: does not preserve the form"},
      {"klein-quartic", "8*t^2 + 6*t - 5", "8*t^2 + 6*t - 4", "generator 1: does not preserve the form"},
      {"klein-quartic", "-1/4*t^2 + 1\"]]", "-1/4*t^2 + 2\"]]", "generator 1: does not preserve the form"},
      {"klein-quartic", "-244*t^2 - 196*t + 136", "-244*t^2 - 196*t + 135", "generator 1: does not preserve the form"},
      {"seifert-weber-space", "2*t + 1/2", "2*t + 1/3", "generator 1: does not preserve the form"},
      {"seifert-weber-space", "\"-7/4*t - 3/4\"", "\"-7/4*t - 1/4\"", "generator 1: does not preserve the form"},
      {"klein-bottle", "[\"1\"  , \"0\", \"0\"]", "[\"2\"  , \"0\", \"0\"]",
       "row 1, entry 1 is 2, expected the first row"},
      {"flat-sixth-turn", "\"-1/2\", \"1\" ", "\"-1/3\", \"1\" ", "gram, row 2, entry 1"},
      {"flat-sixth-turn", "[\"1\"   , \"-1/2\"", "[\"2\"   , \"-1/2\"", "generator 1: does not preserve the form"},
      // Another lattice.
      {"flat-sixth-turn", "1/6", "1/5", "contains the translation by (0, 0, 1/5), which is not integral"},
      {"flat-third-turn", "1/3", "1/4", "contains the translation by (0, 0, 3/4), which is not integral"},
      {"flat-half-turn", "1/2", "1/3", "contains the translation by (0, 0, 2/3), which is not integral"},
      {"hantzsche-wendt", "1/2", "1/3", "contains the translation by (2/3, 0, 0), which is not integral"},
      // Fixed points.
      {"klein-bottle", "\"1/2\"", "\"2/2\"",
       "up to a translation of the lattice, x ↦ [[1, 0], [0, -1]]x + (0, 0) fixes a point"},
      {"flat-quarter-turn", "1/4", "3/1", "does not act freely"},
      {"lens-space-7-2", "p = 7", "p = 8", "does not act freely"},
      {"quaternion-space", "[\"0\", \"0\" , \"0\", \"-1\"]", "[\"0\", \"0\" , \"0\", \"1\"]", "does not act freely"},
      // Not what the file says.
      {"poincare-sphere", "order = 120", "order = 60", "the group has order 120, the description says 60"},
      {"seifert-weber-space", "(Z/5)^3", "(Z/5)^2", "its first homology is (Z/5)^3, the description says (Z/5)^2"},
      // No field, another field, another root.
      {"seifert-weber-space", "t^2 - t - 1", "t^2 - t - 2", "is reducible: t"},
      {"seifert-weber-space", "t^2 - t - 1", "t^2 - t - 3", "field polynomial has 0 roots in [3/2, 2], expected one"},
      {"klein-quartic", "root = [\"9/5\", \"2\"]", "root = [\"0\", \"1\"]", "key \"time\": found"}};
  EXPECT_GE(all.size(), 20U);
  for (const Wrong& wrong : all) {
    const std::string message = refusal(wrong.name, wrong.wanted, wrong.replacement);
    EXPECT_TRUE(mentions(message, wrong.reason)) << wrong.name << ", " << wrong.replacement << ": " << message;
  }
}

TEST(SpaceForm, wrong_hyperbolic_groups_are_refused_by_a_condition_of_poincare) {
  // Isometries all, but of other groups: a pairing by a turn of 1/10 is another manifold's only where the angles fit.
  auto description = find_space_form("seifert-weber-space");
  const SpaceForm original = verify_space_form(description);
  const auto refusal_of = [&] { return message_of<Rejection>([&] { (void)verify_space_form(description); }); };
  const auto generators = description.generators;
  description.generators.pop_back();
  EXPECT_TRUE(mentions(refusal_of(), "is not bounded")) << refusal_of();
  description.generators = generators;
  description.generators[5] = generators[4];
  EXPECT_TRUE(mentions(refusal_of(), "generator 5 and generator 6 are the same element")) << refusal_of();
  description.generators = generators;
  description.generators[0] = generators[0] * generators[0];
  EXPECT_TRUE(mentions(refusal_of(), "is not bounded") || mentions(refusal_of(), "is no side")) << refusal_of();
  // Inverses instead of generators are the same group.
  description.generators = generators;
  description.generators[2] = description.form.inverse_of(generators[2]);
  EXPECT_EQ(refusal_of(), "accepted");

  auto klein = find_space_form("klein-quartic");
  std::swap(klein.generators[0], klein.generators[1]);
  EXPECT_NO_THROW((void)verify_space_form(klein));
}

TEST(SpaceForm, another_valid_group_is_noticed_as_another_manifold) {
  // One digit of a translation makes the first amphidicosm the second.
  EXPECT_EQ(refusal("flat-first-amphidicosm", "[\"1/2\", \"1\", \"0\" , \"0\"],\n   [\"0\"",
                    "[\"1/2\", \"1\", \"0\" , \"0\"],\n   [\"1/2\""),
            "flat-first-amphidicosm: the group is that of another manifold: its first homology is Z + Z/4, the "
            "description says Z + (Z/2)^2");
  // A glide reflection in the place of a translation makes the Bolza surface one that is not orientable.
  auto octagon = regular_polygon_surface(2);
  FieldMatrix reflection = FieldMatrix::identity(3);
  reflection(2, 2) = FieldElement(-1);
  octagon.generators[0] = octagon.generators[0] * reflection;
  EXPECT_EQ(message_of<Rejection>([&] { (void)verify_space_form(octagon); }),
            "regular-polygon-surface-2: the group is that of another manifold: its first homology is Z^3 + Z/2, the "
            "description says Z^4");
  EXPECT_EQ(refusal("quaternion-space", "order = 8", "order = 4"),
            "quaternion-space: the group has order 8, the description says 4");
}

TEST(SpaceForm, refuses_orders_of_infinite_groups_identities_and_wrong_sizes) {
  auto description = find_space_form("klein-bottle");
  description.order = 2;
  const auto refusal_of = [&] { return message_of<Rejection>([&] { (void)verify_space_form(description); }); };
  EXPECT_TRUE(mentions(refusal_of(), "an order is given"));
  description.order.reset();
  description.generators.push_back(FieldMatrix::identity(3));
  EXPECT_TRUE(mentions(refusal_of(), "generator 2 is the identity"));
  description.generators.back() = FieldMatrix::identity(4);
  EXPECT_TRUE(mentions(refusal_of(), "generator 2 has order 4, expected 3"));
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
