#include "kernel/manifold/quotient/finite_group.hpp"

#include <gtest/gtest.h>

#include <set>

#include "kernel/manifold/quotient/space_form_families.hpp"
#include "tests/kernel/manifold/quotient/samples.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

const InvariantForm& three_sphere() {
  static const InvariantForm form = InvariantForm::standard(Curvature::positive, 3);
  return form;
}

FieldMatrix left_i() {
  return matrix(nullptr, {{"0", "-1", "0", "0"}, {"1", "0", "0", "0"}, {"0", "0", "0", "-1"}, {"0", "0", "1", "0"}});
}
FieldMatrix left_j() {
  return matrix(nullptr, {{"0", "0", "-1", "0"}, {"0", "0", "0", "1"}, {"1", "0", "0", "0"}, {"0", "-1", "0", "0"}});
}

TEST(FiniteGroup, is_closed_under_products_and_inverses) {
  const FiniteGroup group = closure(three_sphere(), {left_i(), left_j()}, 100);
  ASSERT_EQ(group.elements.size(), 8U);
  EXPECT_TRUE(is_identity(group.elements.front()));
  const std::set<FieldMatrix, Precedes> all(group.elements.begin(), group.elements.end());
  EXPECT_EQ(all.size(), 8U);
  for (const FieldMatrix& a : group.elements) {
    EXPECT_TRUE(all.contains(three_sphere().inverse_of(a)));
    for (const FieldMatrix& b : group.elements) EXPECT_TRUE(all.contains(a * b));
  }
  EXPECT_EQ(group_text(group.abelianisation), "(Z/2)^2");
  EXPECT_NO_THROW(require_free(group));
}

TEST(FiniteGroup, of_no_generators_is_trivial) {
  const FiniteGroup group = closure(three_sphere(), {}, 100);
  EXPECT_EQ(group.elements.size(), 1U);
  EXPECT_EQ(group_text(group.abelianisation), "0");
}

TEST(FiniteGroup, is_refused_when_it_is_infinite) {
  FieldMatrix rotation = FieldMatrix::identity(4);
  rotation(0, 0) = rotation(1, 1) = FieldElement(ratio(3, 5));
  rotation(1, 0) = FieldElement(ratio(4, 5));
  rotation(0, 1) = FieldElement(ratio(-4, 5));
  EXPECT_EQ(message_of<Rejection>([&] { (void)closure(three_sphere(), {rotation}, 100); }),
            "the generators give more than 100 elements: the group is not finite, or too large");
  EXPECT_EQ(closure(three_sphere(), {left_i(), left_j()}, 8).elements.size(), 8U);
  EXPECT_NE(message_of<Rejection>([&] { (void)closure(three_sphere(), {left_i(), left_j()}, 7); }), "accepted");
}

TEST(FiniteGroup, acts_freely_or_an_element_is_named_that_does_not) {
  for (int q = 1; q < 8; ++q) {
    const auto description = lens_space(8, q);
    const FiniteGroup group = closure(description.form, description.generators, 100);
    EXPECT_EQ(group.elements.size(), 8U);
    EXPECT_EQ(group_text(group.abelianisation), "Z/8");
    const std::string message = message_of<Rejection>([&] { require_free(group); });
    EXPECT_EQ(message == "accepted", q % 2 == 1) << message;
    EXPECT_EQ(mentions(message, "has the eigenvalue 1, so it fixes points"), q % 2 == 0);
  }
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
