#include "kernel/manifold/quotient/invariant_form.hpp"

#include <gtest/gtest.h>

#include "kernel/manifold/quotient/space_form_families.hpp"
#include "tests/kernel/manifold/quotient/samples.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

TEST(InvariantForm, says_why_a_matrix_is_no_isometry) {
  const auto sphere = InvariantForm::standard(Curvature::positive, 2);
  const auto plane = InvariantForm::standard(Curvature::zero, 2);
  const auto hyperbolic = InvariantForm::standard(Curvature::negative, 2);
  const FieldMatrix rotation = matrix(nullptr, {{"1", "0", "0"}, {"0", "3/5", "-4/5"}, {"0", "4/5", "3/5"}});
  for (const auto& form : {sphere, plane, hyperbolic}) EXPECT_FALSE(form.why_no_isometry(rotation).has_value());
  FieldMatrix wrong = rotation;
  wrong(1, 1) = FieldElement(ratio(4, 5));
  for (const auto& form : {sphere, plane, hyperbolic})
    EXPECT_EQ(form.why_no_isometry(wrong).value(),
              "does not preserve the form: row 2, entry 2 of AᵀJA is 32/25, of J 1");
  const FieldMatrix boost = matrix(nullptr, {{"5/4", "3/4", "0"}, {"3/4", "5/4", "0"}, {"0", "0", "1"}});
  EXPECT_FALSE(hyperbolic.why_no_isometry(boost).has_value());
  EXPECT_TRUE(sphere.why_no_isometry(boost).has_value());
  EXPECT_TRUE(mentions(plane.why_no_isometry(boost).value(), "row 1, entry 1 is 5/4, expected the first row"));
  const FieldMatrix sheets = matrix(nullptr, {{"-1", "0", "0"}, {"0", "1", "0"}, {"0", "0", "1"}});
  EXPECT_TRUE(mentions(hyperbolic.why_no_isometry(sheets).value(), "exchanges the sheets"));
  EXPECT_FALSE(sphere.why_no_isometry(sheets).has_value());
}

TEST(InvariantForm, inverts_isometries) {
  for (const auto& description : {lens_space(5, 2), regular_polygon_surface(2)}) {
    for (const FieldMatrix& generator : description.generators) {
      EXPECT_TRUE(is_identity(generator * description.form.inverse_of(generator)));
      EXPECT_EQ(description.form.inverse_of(generator), inverse(generator));
    }
  }
  const FieldMatrix glide = matrix(nullptr, {{"1", "0", "0"}, {"1/2", "1", "0"}, {"1/3", "0", "-1"}});
  EXPECT_TRUE(is_identity(glide * InvariantForm::standard(Curvature::zero, 2).inverse_of(glide)));
}

TEST(InvariantForm, bisectors_are_as_far_from_o_as_from_its_image) {
  // Flat: o = (0, 0), image (2, 0), in the metric diag(1, 4).
  const InvariantForm plane(FieldElement(0), matrix(nullptr, {{"1", "0"}, {"0", "4"}}));
  const FieldMatrix shift = matrix(nullptr, {{"1", "0", "0"}, {"2", "1", "0"}, {"1", "0", "1"}});
  const FieldVector covector = plane.bisector(shift);
  const auto at = [&](const Rational& x, const Rational& y) {
    return pairing(covector, {FieldElement(1), FieldElement(x), FieldElement(y)}).sign();
  };
  EXPECT_EQ(at(Rational(0), Rational(0)), -1);
  EXPECT_EQ(at(Rational(2), Rational(1)), 1);
  EXPECT_EQ(at(Rational(1), ratio(1, 2)), 0);
  EXPECT_EQ(at(Rational(3), ratio(-1, 2)),
            0);  // the middle (1, 1/2) and (2, −1), which is orthogonal to (2, 1) in this metric
  EXPECT_EQ(plane.displacement_of_origin(shift.column(0)), FieldElement(8));

  const auto surface = regular_polygon_surface(2);
  for (const FieldMatrix& generator : surface.generators) {
    const FieldVector side = surface.form.bisector(generator);
    const FieldVector image = generator.column(0);
    FieldVector middle = image;
    middle[0] += FieldElement(1);
    EXPECT_EQ(side[0].sign(), -1);
    EXPECT_EQ(pairing(side, image).sign(), 1);
    EXPECT_TRUE(pairing(side, middle).is_zero());
    EXPECT_EQ(surface.form.dual_product(side, side).sign(), 1);
  }
}

TEST(InvariantForm, matrices_in_the_standard_basis_preserve_the_standard_form) {
  std::vector<SpaceFormDescription> all{lens_space(7, 3), regular_polygon_surface(3)};
  for (const auto& description : all) {
    const int k = sign_of(description.form.curvature());
    for (const FieldMatrix& generator : description.generators) {
      const auto a = description.form.in_standard_basis(generator);
      const std::size_t n = a.size();
      for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t j = 0; j < n; ++j) {
          BigInterval product = BigInterval(k) * a[0][i] * a[0][j];
          for (std::size_t row = 1; row < n; ++row) product += a[row][i] * a[row][j];
          const Rational expected(i != j ? 0 : i == 0 ? k : 1);
          EXPECT_LE(product.lower(), expected);
          EXPECT_GE(product.upper(), expected);
          EXPECT_LE(product.upper() - product.lower(), Rational::power_of_two(-100));
        }
      }
    }
  }
}

TEST(InvariantForm, the_standard_basis_orthonormalises_any_gram_matrix) {
  // A rotation of order 6 in the hexagonal basis, acting on the sphere about o.
  const InvariantForm form(FieldElement(1), matrix(nullptr, {{"1", "-1/2"}, {"-1/2", "1"}}));
  const FieldMatrix turn = matrix(nullptr, {{"1", "0", "0"}, {"0", "1", "-1"}, {"0", "1", "0"}});
  ASSERT_FALSE(form.why_no_isometry(turn).has_value());
  const auto a = form.in_standard_basis(turn);
  EXPECT_TRUE(a[1][1].lower() <= ratio(1, 2) && ratio(1, 2) <= a[1][1].upper());
  EXPECT_TRUE(a[2][2].lower() <= ratio(1, 2) && ratio(1, 2) <= a[2][2].upper());
  EXPECT_LE(square(a[1][2]).lower(), ratio(3, 4));
  EXPECT_GE(square(a[1][2]).upper(), ratio(3, 4));
}

TEST(InvariantForm, needs_a_symmetric_positive_definite_gram_matrix) {
  const auto refusal = [](const std::vector<std::vector<std::string>>& gram) {
    return message_of<InputError>([&] { InvariantForm(FieldElement(0), matrix(nullptr, gram)); });
  };
  EXPECT_EQ(refusal({{"2", "1"}, {"1", "2"}}), "accepted");
  EXPECT_TRUE(mentions(refusal({{"2", "1"}, {"0", "2"}}), "gram, row 2, entry 1: found 0, expected 1"));
  EXPECT_TRUE(mentions(refusal({{"1", "1"}, {"1", "1"}}), "not positive definite"));
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
