#include "proofs/formal/bernstein_form.hpp"

#include "tests/proofs/formal/polynomials.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

using namespace test;

void expect_form(const Polynomial& p, const FormalVariables& variables, bool strict = false) {
  const auto form = bernstein_form(p, variables, strict);
  ASSERT_TRUE(form.has_value()) << p.text();
  expect_equal_terms(*form, polynomial_text(p, variables));
}

TEST(BernsteinForm, in_a_box) {
  const FormalVariables box{between("x", -1, 2), between("y", 0, 3)};
  expect_form(x() + number(1), box);
  expect_form((x() + number(1)) * (number(3) - y()), box);
  expect_form(x() * x() * y() + number(4) * y(), box);
  EXPECT_FALSE(bernstein_form(x(), box, false));
  EXPECT_FALSE(bernstein_form((x() - y()).power(2), box, false)) << "needs cuts that never end";
}

TEST(BernsteinForm, without_an_upper_or_a_lower_end) {
  FormalVariable down{"y", std::nullopt, Rational(1), false, false};
  const FormalVariables quadrant{between("x", 2, 0), down};
  expect_form(x() * x() - number(4), quadrant);
  expect_form((x() - number(2)) * (number(1) - y()) + number(5), quadrant, true);
  EXPECT_FALSE(bernstein_form(number(3) - x(), quadrant, false));
  EXPECT_FALSE(bernstein_form(x(), {FormalVariable{"x", std::nullopt, std::nullopt, false, false}, down}, false));
}

TEST(BernsteinForm, strict_by_a_constant_or_by_an_open_end) {
  const FormalVariables box{between("x", 0, 1), between("y", 0, 1)};
  expect_form(x() * x() - x() + number(1), box, true);
  EXPECT_FALSE(bernstein_form(x(), box, true));
  FormalVariables open = box;
  open[0].lower_open = true;
  expect_form(x(), open, true);
  expect_form(number(2) * x() - x() * x(), open, true);
  EXPECT_FALSE(bernstein_form(x() * y(), open, true));
}

TEST(BernsteinForm, gives_up_on_too_many_terms) {
  const FormalVariables box{between("x", 0, 1), between("y", 0, 1)};
  EXPECT_FALSE(bernstein_form(x().power(100) * y().power(100), box, false));
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
