#include "kernel/manifold/quotient/polynomial_text.hpp"

#include <gtest/gtest.h>

#include "tests/kernel/manifold/quotient/samples.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

using Coefficients = std::vector<Rational>;

std::string refusal(const std::string& text) {
  return message_of<InputError>([&] { (void)parse_polynomial(text); });
}

TEST(PolynomialText, reads_signed_terms_in_any_order) {
  EXPECT_EQ(parse_polynomial("0"), Coefficients{Rational(0)});
  EXPECT_EQ(parse_polynomial("-3/4"), Coefficients{ratio(-3, 4)});
  EXPECT_EQ(parse_polynomial("t"), (Coefficients{Rational(0), Rational(1)}));
  EXPECT_EQ(parse_polynomial("-t"), (Coefficients{Rational(0), Rational(-1)}));
  EXPECT_EQ(parse_polynomial("1 - 1/2*t^2"), (Coefficients{Rational(1), Rational(0), ratio(-1, 2)}));
  EXPECT_EQ(parse_polynomial(" 2*t^3+t - 5 "), (Coefficients{Rational(-5), Rational(1), Rational(0), Rational(2)}));
}

TEST(PolynomialText, says_where_a_text_goes_wrong) {
  EXPECT_EQ(refusal(""), "\"\" at character 1: found the end, expected a number or \"t\"");
  EXPECT_EQ(refusal("1 +"), "\"1 +\" at character 4: found the end, expected a number or \"t\"");
  EXPECT_EQ(refusal("2 t"), "\"2 t\" at character 3: found \"t\", expected \"+\", \"-\" or the end");
  EXPECT_EQ(refusal("t + 2*t"), "\"t + 2*t\" at character 5: found \"2\", expected the first term with t^1");
  EXPECT_EQ(refusal("t^"), "\"t^\" at character 3: found the end, expected an exponent of at most three digits");
  EXPECT_TRUE(mentions(refusal("t^1000"), "at character 6: found \"0\""));
  EXPECT_TRUE(mentions(refusal("0.5*t"), "at character 2: found \".\""));
  EXPECT_TRUE(mentions(refusal("1/0"), "at character 3"));
  EXPECT_TRUE(mentions(refusal("x"), "found \"x\""));
  EXPECT_TRUE(mentions(refusal("--t"), "at character 2"));
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
