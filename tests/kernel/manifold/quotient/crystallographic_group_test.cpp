#include "kernel/manifold/quotient/crystallographic_group.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/kernel/manifold/quotient/samples.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

using Rows = std::vector<std::vector<std::string>>;

InvariantForm flat_form(const Rows& gram) { return {FieldElement(0), matrix(nullptr, gram)}; }

InvariantForm square_form() { return flat_form({{"4", "0"}, {"0", "1"}}); }

std::string refusal(const InvariantForm& form, const std::vector<Rows>& generators) {
  std::vector<FieldMatrix> matrices;
  for (const Rows& rows : generators) matrices.push_back(matrix(nullptr, rows));
  return message_of<Rejection>([&] { (void)crystallographic_group(form, matrices); });
}

const Rows glide{{"1", "0", "0"}, {"1/2", "1", "0"}, {"0", "0", "-1"}};

TEST(CrystallographicGroup, of_the_klein_bottle) {
  const auto group = crystallographic_group(square_form(), {matrix(nullptr, glide)});
  EXPECT_EQ(group.representatives.size(), 2U);
  EXPECT_EQ(group_text(group.abelianisation), "Z + Z/2");
  EXPECT_EQ(group.squared_displacement, Rational(1));
}

TEST(CrystallographicGroup, of_no_generators_is_the_lattice) {
  const auto group = crystallographic_group(flat_form({{"1", "1/2"}, {"1/2", "1"}}), {});
  EXPECT_EQ(group_text(group.abelianisation), "Z^2");
  EXPECT_EQ(group.squared_displacement, Rational(1));
}

TEST(CrystallographicGroup, displacements_are_least_over_all_points_and_translations) {
  // The half-turn screw along the third axis of a skewed lattice, the glide of the first amphicosm, against a search.
  const std::vector<std::pair<Rows, Rows>> samples{
      {{{"3", "1", "0"}, {"1", "2", "0"}, {"0", "0", "5"}},
       {{"1", "0", "0", "0"}, {"0", "-1", "0", "0"}, {"1/3", "0", "-1", "0"}, {"1/2", "0", "0", "1"}}},
      {{{"9", "1", "0"}, {"1", "2", "0"}, {"0", "0", "7"}},
       {{"1", "0", "0", "0"}, {"1/2", "1", "0", "0"}, {"0", "0", "1", "0"}, {"0", "0", "0", "-1"}}}};
  for (const auto& [gram, generator] : samples) {
    const auto form = flat_form(gram);
    const auto group = crystallographic_group(form, {matrix(nullptr, generator)});
    // Points of a grid, moved by the elements with translations of size ≤ 3: no displacement is less, one comes close.
    Rational least(1000);
    for (const FieldMatrix& representative : group.representatives) {
      for (int code = 0; code < 5 * 5 * 5; ++code) {
        FieldMatrix element = representative;
        element(1, 0) += FieldElement(code % 5 - 2);
        element(2, 0) += FieldElement(code / 5 % 5 - 2);
        element(3, 0) += FieldElement(code / 25 - 2);
        if (is_identity(element)) continue;
        for (int at = 0; at < 27; ++at) {
          const FieldVector x{FieldElement(1), FieldElement(ratio(at % 3, 6)), FieldElement(ratio(at / 3 % 3, 6)),
                              FieldElement(ratio(at / 9, 6))};
          FieldVector step = element * x;
          for (std::size_t axis = 0; axis < 4; ++axis) step[axis] -= x[axis];
          least = minimum(least, pairing(step, form.matrix() * step).rational());
        }
      }
    }
    EXPECT_EQ(group.squared_displacement, least);
  }
}

TEST(CrystallographicGroup, refuses_fixed_points) {
  EXPECT_EQ(refusal(square_form(), {glide}), "accepted");
  // A reflection, a rotation about a point, a glide that some translation turns into a reflection.
  EXPECT_TRUE(
      mentions(refusal(square_form(), {{{"1", "0", "0"}, {"0", "1", "0"}, {"0", "0", "-1"}}}),
               "does not act freely: up to a translation of the lattice, x ↦ [[1, 0], [0, -1]]x + (0, 0) fixes"));
  EXPECT_TRUE(mentions(refusal(square_form(), {{{"1", "0", "0"}, {"1/3", "-1", "0"}, {"1/5", "0", "-1"}}}), "fixes"));
  EXPECT_TRUE(
      mentions(refusal(flat_form({{"1", "0"}, {"0", "1"}}), {{{"1", "0", "0"}, {"1/2", "0", "1"}, {"-1/2", "1", "0"}}}),
               "fixes a point"));
  // The reflection that exchanges the basis vectors, with a translation along it that no lattice vector cancels.
  EXPECT_EQ(refusal(flat_form({{"1", "0"}, {"0", "1"}}), {{{"1", "0", "0"}, {"1/2", "0", "1"}, {"1/2", "1", "0"}}}),
            "the group does not act freely: up to a translation of the lattice, x ↦ [[0, 1], [1, 0]]x + (1/2, 1/2) "
            "fixes a point");
}

TEST(CrystallographicGroup, refuses_other_coordinates) {
  EXPECT_EQ(
      refusal(square_form(), {{{"1", "0", "0"}, {"1/3", "1", "0"}, {"0", "0", "-1"}}}),
      "the group contains the translation by (2/3, 0), which is not integral: coordinates are those of the lattice "
      "of all translations");
  EXPECT_TRUE(mentions(
      refusal(flat_form({{"1", "0"}, {"0", "1"}}), {{{"1", "0", "0"}, {"0", "3/5", "-4/5"}, {"0", "4/5", "3/5"}}}),
      "generator 1: row 2, entry 2 is 3/5, expected an integer"));
}

TEST(CrystallographicGroup, short_elements_are_all_of_a_search) {
  const auto form = square_form();
  const auto group = crystallographic_group(form, {matrix(nullptr, glide)});
  const Rational bound(7);
  std::size_t expected = 0;
  for (int x = -20; x <= 20; ++x) {
    for (int y = -10; y <= 10; ++y) {
      // Translations (x/2, y): with even x the lattice, with odd x glides. |(x/2, y)|² = x² + y².
      if ((x != 0 || y != 0) && x * x + y * y <= 7) ++expected;
    }
  }
  const auto found = short_elements(form, group, bound);
  EXPECT_EQ(found.size(), expected);
  EXPECT_TRUE(std::none_of(found.begin(), found.end(), [](const FieldMatrix& a) { return is_identity(a); }));
  for (const FieldMatrix& element : found) EXPECT_LE(form.displacement_of_origin(element.column(0)).rational(), bound);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
