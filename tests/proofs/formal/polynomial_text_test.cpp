#include "proofs/formal/polynomial_text.hpp"

#include "tests/proofs/formal/polynomials.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

using namespace test;

TEST(PolynomialText, terms_of_coq) {
  const FormalVariables variables{between("root_k", 0, 1), between("y", 0, 1)};
  EXPECT_EQ(polynomial_text(x(), variables), "root_k");
  EXPECT_EQ(polynomial_text(number(3), variables), "3");
  EXPECT_EQ(polynomial_text(number(0), variables), "0");
  EXPECT_EQ(polynomial_text(-x() * x() + number(2) * y() - number(1), variables), "(- root_k ^ 2 + 2 * y - 1)");
  const Polynomial half(plane(), Rational(1) / Rational(2));
  EXPECT_EQ(polynomial_text(half * x() * y(), variables), "((1 / 2) * root_k * y)");
}

TEST(PolynomialText, powers) {
  EXPECT_EQ(power_text("x", 1), "x");
  EXPECT_EQ(power_text("x", 3), "x ^ 3");
}

TEST(PolynomialText, what_ranges_say_of_signs) {
  EXPECT_TRUE(between("x", 0, 1).is_nonnegative());
  EXPECT_FALSE(between("x", 0, 1).is_positive());
  EXPECT_TRUE(between("x", 1, 0).is_positive());
  EXPECT_FALSE(between("x", -1, 1).is_nonnegative());
  FormalVariable open = between("x", 0, 1);
  open.lower_open = true;
  EXPECT_TRUE(open.is_positive());
  EXPECT_FALSE(FormalVariable{}.is_nonnegative());
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
