#include "kernel/manifold/quotient/element_table.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "kernel/manifold/space_form_file.hpp"
#include "tests/kernel/manifold/quotient/samples.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

template <int m>
ElementTable<m> table_of(const SpaceForm& form, const Rational& radius) {
  return ElementTable<m>(form.form(), form.elements_within(radius), Rational(2) * form.injectivity_radius.lower);
}

/// Products as exact matrices, and as the table finds them.
template <int m>
void expect_exact_products(const std::string& name, const Rational& radius) {
  const SpaceForm form = verify_space_form(find_space_form(name));
  const auto table = table_of<m>(form, radius);
  ASSERT_GT(table.size(), 2U);
  EXPECT_TRUE(is_identity(table.elements().front()));
  std::size_t found = 0;
  for (std::uint32_t a = 0; a < table.size(); a += 3) {
    EXPECT_EQ(table.elements()[table.inverse(a)], form.form().inverse_of(table.elements()[a]));
    for (std::uint32_t b = 0; b < table.size(); b += 2) {
      const FieldMatrix exact = table.elements()[a] * table.elements()[b];
      std::optional<std::uint32_t> expected;
      try {
        expected = table.number_of(exact);
      } catch (const std::out_of_range&) {
        EXPECT_THROW((void)table.product(a, b), std::out_of_range);
        continue;
      }
      EXPECT_EQ(table.product(a, b), *expected);
      ++found;
    }
  }
  EXPECT_GT(found, table.size() / 2);
}

TEST(ElementTable, finds_products_exactly) {
  expect_exact_products<3>("lens-space-5-2", Rational(0));
  expect_exact_products<3>("poincare-sphere", Rational(0));
  expect_exact_products<2>("bolza-surface", ratio(7, 2));
  expect_exact_products<2>("klein-bottle", Rational(3));
  expect_exact_products<3>("hantzsche-wendt", Rational(3));
}

TEST(ElementTable, does_not_depend_on_the_order_of_its_elements) {
  const SpaceForm form = verify_space_form(find_space_form("lens-space-7-2"));
  std::vector<FieldMatrix> backwards(form.finite->elements.rbegin(), form.finite->elements.rend());
  backwards.push_back(backwards.front());
  const ElementTable<3> table(form.form(), backwards, form.injectivity_radius.lower);
  EXPECT_EQ(table.elements(), table_of<3>(form, Rational(0)).elements());
  EXPECT_EQ(table.size(), 7U);
}

TEST(ElementTable, has_the_identity_without_being_given_it) {
  const SpaceForm form = verify_space_form(find_space_form("sphere-2"));
  const ElementTable<2> table(form.form(), {}, Rational(3));
  EXPECT_EQ(table.size(), 1U);
  EXPECT_EQ(table.product(0, 0), 0U);
  EXPECT_EQ(table.inverse(0), 0U);
}

TEST(ElementTable, says_what_is_missing) {
  const SpaceForm form = verify_space_form(find_space_form("bolza-surface"));
  const FieldMatrix generator = form.description.generators.front();
  const ElementTable<2> table(form.form(), {generator}, Rational(2) * form.injectivity_radius.lower);
  EXPECT_EQ(table.number_of(generator), 1U);
  EXPECT_THROW((void)table.number_of(generator * generator), std::out_of_range);
  EXPECT_THROW((void)table.product(1, 1), std::out_of_range);
  EXPECT_THROW((void)table.inverse(1), std::out_of_range);
}

TEST(ElementTable, encloses_matrices_at_every_precision) {
  const SpaceForm form = verify_space_form(find_space_form("klein-quartic"));
  const auto table = table_of<2>(form, Rational(5));
  ASSERT_GT(table.size(), 1U);
  for (const unsigned bits : {128U, 512U}) {
    const BigInterval::Precision precision(PrecisionBits{bits});
    const auto big = table.big_matrix(1);
    for (std::size_t row = 0; row < 3; ++row) {
      for (std::size_t column = 0; column < 3; ++column) {
        const Interval& small = table.matrix(1)[row][column];
        EXPECT_LE(Rational::exactly(small.lower()), big[row][column].lower());
        EXPECT_GE(Rational::exactly(small.upper()), big[row][column].upper());
        EXPECT_LE(big[row][column].upper() - big[row][column].lower(),
                  Rational::power_of_two(32 - static_cast<long>(bits)));
      }
    }
  }
}

TEST(ElementTable, charts_of_flat_forms_have_their_metric) {
  const SpaceForm flat = verify_space_form(find_space_form("klein-bottle"));
  EXPECT_EQ(chart_metric<2>(flat.form()).gram()[0][0], Rational(4));
  EXPECT_TRUE(chart_metric<2>(find_space_form("bolza-surface").form).is_cartesian());
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
