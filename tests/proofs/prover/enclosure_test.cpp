#include "proofs/prover/enclosure.hpp"

#include <gtest/gtest.h>

#include "proofs/formula/type_check.hpp"
#include "proofs/prover/box.hpp"
#include "tests/proofs/prover/prove_text.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

using test::ratio;

constexpr PrecisionBits bits{128U};

ExpressionPointer term(const std::string& text) {
  return type_checked(parse_formula(text), test::numbers(), {{"k", types::integer}, {"x", types::number}},
                      types::number);
}

ParameterBox box(const std::string& k, const std::string& x) {
  return parameter_box({box_side(parse_step_range("integer " + k), false), box_side(parse_step_range(x), false)}, bits);
}

Sign sign(const std::string& text, const ParameterBox& where) {
  EnclosureTape tape({"k", "x"});
  return tape.sign(tape.add(term(text)), where);
}

bool has_value(const std::string& text, const ParameterBox& where) {
  EnclosureTape tape({"k", "x"});
  const std::size_t number = tape.add(term(text));
  tape.evaluate(where);
  return tape.value(number).has_value();
}

TEST(Enclosures, contain_the_value_at_every_point) {
  EnclosureTape tape({"k", "x"});
  const std::size_t number = tape.add(term("sqrt(k + x^2)/(1 + x) - log2(k)*abs(x - 1) + max(x, 1/3)^(3/2)"));
  tape.evaluate(box("[1, 8]", "[0, 1]"));
  ASSERT_TRUE(tape.value(number));
  const ExtendedInterval wide = *tape.value(number);
  for (const char* k : {"[1, 1]", "[3, 3]", "[8, 8]"}) {
    for (const char* x : {"[0, 0]", "[1/3, 1/3]", "[1, 1]"}) {
      tape.evaluate(box(k, x));
      const ExtendedInterval& narrow = *tape.value(number);
      EXPECT_LT(narrow.approximate_width(), 0x1p-100);
      EXPECT_LE(mpfr_cmp(wide.lower().raw(), narrow.lower().raw()), 0);
      EXPECT_GE(mpfr_cmp(wide.upper().raw(), narrow.upper().raw()), 0);
    }
  }
}

TEST(Enclosures, tell_signs) {
  EXPECT_EQ(sign("x", box("[1, 1]", "(0, 1]")), Sign::positive);
  EXPECT_EQ(sign("x", box("[1, 1]", "[0, 1]")), Sign::nonnegative);
  EXPECT_EQ(sign("x - 2", box("[1, 1]", "[0, 1]")), Sign::negative);
  EXPECT_EQ(sign("x*0", box("[1, 1]", "[0, 1]")), Sign::zero);
  EXPECT_EQ(sign("(2/x)^(4*k^2 + 26) - 2^30", box("[1, infinity)", "(0, 1]")), Sign::nonnegative);
}

TEST(Enclosures, tell_signs_by_monotonicity) {
  // Both terms grow without bound: only the derivative shows which is greater.
  EXPECT_EQ(sign("2^k - k - 1", box("[1, infinity)", "[0, 1]")), Sign::nonnegative);
  EXPECT_EQ(sign("2^k - k - 1", box("[2, infinity)", "[0, 1]")), Sign::positive);
  EXPECT_EQ(sign("k - log2(k)", box("[2, infinity)", "[0, 1]")), Sign::positive);
  EXPECT_EQ(sign("x - x^2/4", box("[1, 1]", "(0, 1]")), Sign::positive) << "strict, as the end does not belong to it";
  EXPECT_EQ(sign("x - x^2/4", box("[1, 1]", "[0, 1]")), Sign::nonnegative);
  EXPECT_EQ(sign("(x - 1/3)*(x - 2/3)", box("[1, 1]", "[0, 1]")), Sign::unknown) << "it has both signs";
  EXPECT_EQ(sign("2^k - 3*k", box("[1, infinity)", "[0, 1]")), Sign::unknown) << "negative for k = 1, positive for 4";
}

TEST(Enclosures, say_where_there_may_be_no_value) {
  EXPECT_FALSE(has_value("1/x", box("[1, 1]", "[0, 1]")));
  EXPECT_TRUE(has_value("1/x", box("[1, 1]", "(0, 1]")));
  EXPECT_FALSE(has_value("sqrt(x - 1/2)", box("[1, 1]", "[0, 1]")));
  EXPECT_FALSE(has_value("log2(x)", box("[1, 1]", "[0, 1]")));
  EXPECT_FALSE(has_value("x^k", box("[1, 2]", "[0, 1]")));
  EXPECT_TRUE(has_value("x^k", box("[1, 2]", "(0, 1]")));
  EXPECT_EQ(sign("1/x", box("[1, 1]", "[0, 1]")), Sign::unknown);
}

TEST(Enclosures, constant_exponents_may_have_any_base) {
  EXPECT_EQ(sign("(x - 1)^3", box("[1, 1]", "[0, 1)")), Sign::negative);
  EXPECT_EQ(sign("(x - 1)^2", box("[1, 1]", "[0, 1]")), Sign::nonnegative);
  EXPECT_EQ(sign("x^(1/2) - 2", box("[1, 1]", "[0, 1]")), Sign::negative);
  EXPECT_EQ(sign("x^0 - 1", box("[1, 1]", "[0, 1]")), Sign::zero);
}

TEST(Enclosures, differences_share_their_terms) {
  EnclosureTape tape({"k", "x"});
  const auto a = term("x + 1");
  const std::size_t number = tape.add_difference(a, a);
  tape.evaluate(box("[1, 1]", "[1/2, 1/2]"));
  EXPECT_TRUE(tape.value(number)->is_zero());
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
