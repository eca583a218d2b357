#include "proofs/formal/sign_script.hpp"

#include "tests/proofs/formal/polynomials.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

using namespace test;

const FormalVariables box{between("x", 0, 1), between("y", 0, 1)};

TEST(SignScript, one_form_if_it_does) {
  const auto script = sign_script(number(2) - x() - y(), box, false);
  ASSERT_TRUE(script);
  EXPECT_EQ(script->find("destruct"), std::string::npos);
  EXPECT_TRUE(script->ends_with("nonneg."));
}

TEST(SignScript, cuts_the_range_if_it_does_not) {
  // (x − 1/2)² + 1/100 has a negative coefficient on [0, 1].
  const Polynomial p = number(100) * x() * x() - number(100) * x() + number(26);
  const auto script = sign_script(p, box, true);
  ASSERT_TRUE(script);
  EXPECT_NE(script->find("destruct (Rle_lt_dec x (1 / 2)) as [cut_1|cut_1]."), std::string::npos) << *script;
  EXPECT_TRUE(sign_script(x() * x() - number(6) * x() + number(10), {between("x", 0, -1), box[1]}, true));
}

TEST(SignScript, nothing_for_what_is_false_or_ties_inside) {
  EXPECT_FALSE(sign_script(x() - y(), box, false));
  EXPECT_FALSE(sign_script(number(100) * x() * x() - number(100) * x() + number(24), box, false));
  EXPECT_FALSE(sign_script(x(), box, true));
}

TEST(SignScript, guesses) {
  EXPECT_EQ(sign_at_some_point(x() + y(), box), 1);
  EXPECT_EQ(sign_at_some_point(-x(), box), -1);
  EXPECT_EQ(sign_at_some_point(x() - y(), box), 0);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
