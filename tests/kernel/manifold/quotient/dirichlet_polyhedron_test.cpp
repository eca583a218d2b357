#include "kernel/manifold/quotient/dirichlet_polyhedron.hpp"

#include <gtest/gtest.h>

#include "kernel/manifold/quotient/space_form_families.hpp"
#include "kernel/manifold/space_form_file.hpp"
#include "tests/kernel/manifold/quotient/samples.hpp"
#include "tests/kernel/manifold/quotient/side_pairings.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

DirichletPolyhedron polyhedron_of(const SpaceFormDescription& description, const SidePairings& pairings,
                                  ElementsWithoutSide without_side = ElementsWithoutSide::are_errors) {
  return dirichlet_polyhedron(description.form, pairings.elements, pairings.names, without_side);
}

std::string refusal(const SpaceFormDescription& description, const SidePairings& pairings) {
  return message_of<Rejection>([&] { (void)polyhedron_of(description, pairings); });
}

TEST(DirichletPolyhedron, of_surfaces_is_the_regular_polygon) {
  for (const int genus : {2, 3, 4}) {
    const auto description = regular_polygon_surface(genus);
    const auto polygon = polyhedron_of(description, with_inverses(description));
    const auto sides = static_cast<std::size_t>(4 * genus);
    EXPECT_EQ(polygon.sides.size(), sides);
    EXPECT_EQ(polygon.vertices.size(), sides);
    EXPECT_EQ(polygon.ridges.size(), sides);
    for (const auto& side : polygon.sides) {
      EXPECT_EQ(side.vertices.size(), 2U);
      EXPECT_TRUE(is_identity(side.element * polygon.sides[side.opposite].element));
      // The other side: all vertices are on or inside, only two of them on.
      std::size_t inside = 0;
      for (const FieldVector& vertex : polygon.vertices) inside += pairing(side.covector, vertex).sign() < 0 ? 1U : 0U;
      EXPECT_EQ(inside, sides - 2);
    }
    for (std::size_t at = 0; at < sides; ++at) {
      FieldVector longer = polygon.vertices[at];
      for (FieldElement& entry : longer) entry *= FieldElement(3);
      EXPECT_EQ(polygon.vertex_on(longer), at);
    }
    EXPECT_EQ(polygon.vertex_on({FieldElement(1), FieldElement(0), FieldElement(0)}), sides);
  }
}

TEST(DirichletPolyhedron, the_circumradius_of_the_octagon_is_known) {
  // cosh D = cot² π/8 = 3 + 2√2.
  const auto description = regular_polygon_surface(2);
  const BigInterval radius = circumradius(description.form, polyhedron_of(description, with_inverses(description)));
  const BigInterval known = area_cosine(BigInterval(3) + BigInterval(2) * square_root(BigInterval(2)));
  EXPECT_TRUE(is_undecided(less(radius, known)));
  EXPECT_LE(radius.upper() - radius.lower(), Rational::power_of_two(-100));
}

TEST(DirichletPolyhedron, of_the_seifert_weber_space_is_a_dodecahedron) {
  const auto description = find_space_form("seifert-weber-space");
  const auto polyhedron = polyhedron_of(description, with_inverses(description));
  EXPECT_EQ(polyhedron.sides.size(), 12U);
  EXPECT_EQ(polyhedron.vertices.size(), 20U);
  EXPECT_EQ(polyhedron.ridges.size(), 30U);
  for (const auto& side : polyhedron.sides) EXPECT_EQ(side.vertices.size(), 5U);
}

TEST(DirichletPolyhedron, leaves_out_elements_without_a_side_only_when_asked_to) {
  const auto description = regular_polygon_surface(2);
  SidePairings more = with_inverses(description);
  const FieldMatrix product = description.generators[0] * description.generators[0];
  more.elements.push_back(product);
  more.elements.push_back(description.form.inverse_of(product));
  more.names.insert(more.names.end(), {"aa", "AA"});
  EXPECT_TRUE(mentions(refusal(description, more), "the bisector of aa is no side of the polyhedron: 0 vertices"));
  EXPECT_EQ(polyhedron_of(description, more, ElementsWithoutSide::are_left_out).sides.size(), 8U);
}

TEST(DirichletPolyhedron, refuses_what_bounds_no_polyhedron) {
  const auto description = regular_polygon_surface(2);
  const SidePairings all = with_inverses(description);
  const auto without = [&](std::size_t first) {
    SidePairings result = all;
    result.elements.erase(result.elements.begin() + static_cast<std::ptrdiff_t>(first),
                          result.elements.begin() + static_cast<std::ptrdiff_t>(first) + 2);
    result.names.erase(result.names.begin() + static_cast<std::ptrdiff_t>(first),
                       result.names.begin() + static_cast<std::ptrdiff_t>(first) + 2);
    return result;
  };
  EXPECT_TRUE(mentions(refusal(description, without(0)), "is not bounded"));
  EXPECT_TRUE(mentions(refusal(description, numbered({})), "it has no vertex"));
  SidePairings twice = all;
  twice.elements.push_back(all.elements[0]);
  twice.names.emplace_back("again");
  EXPECT_EQ(refusal(description, twice), "a and again are the same element");
}

TEST(DirichletPolyhedron, refuses_elements_that_fix_points) {
  const auto form = InvariantForm::standard(Curvature::zero, 2);
  const FieldMatrix half_turn_about_o = matrix(nullptr, {{"1", "0", "0"}, {"0", "-1", "0"}, {"0", "0", "-1"}});
  const FieldMatrix quarter = matrix(nullptr, {{"1", "0", "0"}, {"0", "0", "-1"}, {"0", "1", "0"}});
  const auto refuse = [&](const std::vector<FieldMatrix>& elements) {
    const SidePairings pairings = numbered(elements);
    return message_of<Rejection>(
        [&] { (void)dirichlet_polyhedron(form, pairings.elements, pairings.names, ElementsWithoutSide::are_errors); });
  };
  EXPECT_EQ(refuse({half_turn_about_o}), "0 is its own inverse: it fixes a point");
  EXPECT_EQ(refuse({quarter, inverse(quarter)}), "0 fixes the origin");
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
