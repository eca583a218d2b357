#include "proofs/formal/domination.hpp"

#include "tests/proofs/formal/polynomials.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

using namespace test;

const FormalVariables unit_square{between("x", 0, 1), between("y", 0, 1)};
const FormalVariables beyond_one{between("x", 1, 0), between("y", 1, 0)};

void expect_form(const Polynomial& p, const FormalVariables& variables, bool strict = false) {
  const auto form = domination(p, variables, strict);
  ASSERT_TRUE(form.has_value()) << p.text();
  expect_equal_terms(*form, polynomial_text(p, variables));
}

TEST(Domination, smaller_powers_in_the_unit_square_and_greater_ones_beyond) {
  expect_form(number(2) * x() - x() * x() - x() * y(), unit_square);
  EXPECT_FALSE(domination(number(2) * x() - x() * x() - x() * y(), beyond_one, false));
  expect_form(x() * x() * y() - x(), beyond_one);
  EXPECT_FALSE(domination(x() * x() * y() - x(), unit_square, false));
}

TEST(Domination, is_exact_where_terms_tie) {
  expect_form(number(3) - x() - number(2) * y(), unit_square);
  EXPECT_FALSE(domination(number(3) - x() - number(2) * y(), unit_square, true));
  EXPECT_FALSE(domination(number(3) - x() - number(3) * y(), unit_square, false));
}

TEST(Domination, strict_if_something_positive_is_left) {
  expect_form(number(4) - x() - number(2) * y(), unit_square, true);
  EXPECT_FALSE(domination(number(2) * x() - x() * x(), unit_square, true)) << "0 at x = 0";
  expect_form(number(2) * x() * x() - x(), beyond_one, true);
}

TEST(Domination, scales_ranges_to_end_at_one) {
  expect_form(x() - x() * x(), {between("x", 0, 1), between("y", 0, 1)});
  expect_form(number(4) * x() - x() * x(), {between("x", 0, 4), between("y", 0, 1)});
  EXPECT_FALSE(domination(number(3) * x() - x() * x(), {between("x", 0, 4), between("y", 0, 1)}, false));
  expect_form(x() * x() - number(3) * x(), {between("x", 3, 0), between("y", 0, 1)});
}

TEST(Domination, knows_nothing_of_variables_that_may_be_negative) {
  EXPECT_FALSE(domination(x(), {between("x", -1, 1), between("y", 0, 1)}, false));
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
