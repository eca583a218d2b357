#include "proofs/formal/symbolic_powers.hpp"

#include "tests/proofs/prover/prove_text.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

/// The claim of a step with its symbolic powers replaced, as a term of Coq.
std::string replaced(const std::string& lines) {
  const Step step = test::step(lines);
  const FormalParameters parameters = formal_parameters(step);
  SymbolicPowers powers(parameters);
  const auto result = powers.replaced(expanded(step, step.claim.formula));
  return result ? coq_of(**result).value_or("no term") : "none";
}

TEST(SymbolicPowers, exponents_begin_at_the_lower_end) {
  EXPECT_EQ(replaced("forall = { g = '(0, 1]', m = 'integer [1, infinity)' }\nclaim = 'g^(2*m + 1) <= g'"),
            "(((1 * (power_1 ^ 2)) * (g ^ 3)) <= g)");
  EXPECT_EQ(replaced("forall = { g = '(0, 1]', m = 'integer [0, infinity)' }\nclaim = 'g^(m - 2) <= 1'"),
            "(((1 * (power_1 ^ 1)) / (g ^ 2)) <= 1)");
}

TEST(SymbolicPowers, bases_are_taken_apart) {
  EXPECT_EQ(replaced("forall = { u = '(0, 1]', m = 'integer [0, infinity)' }\nclaim = '(2/u)^m >= 1'"),
            "(((1 / (power_1 ^ 1)) * (power_2 ^ 1)) >= 1)");
}

TEST(SymbolicPowers, what_is_known_of_the_variables) {
  const Step step = test::step("forall = { g = '(0, 1]', m = 'integer [0, infinity)' }\nclaim = 'g^m <= 2^(m/2)'");
  const FormalParameters parameters = formal_parameters(step);
  SymbolicPowers powers(parameters);
  ASSERT_TRUE(powers.replaced(expanded(step, step.claim.formula)));
  ASSERT_EQ(powers.variables().size(), 2U);
  EXPECT_EQ(powers.variables()[0].upper, Rational(1));
  EXPECT_TRUE(powers.variables()[0].is_positive());
  EXPECT_EQ(powers.variables()[1].lower, Rational(1));
  EXPECT_FALSE(powers.variables()[1].upper.has_value());
  EXPECT_NE(powers.script().find("pose (power_2 := Rpower 2 ((1 / 2) * (m)))."), std::string::npos) << powers.script();
}

TEST(SymbolicPowers, not_if_a_base_may_be_below_and_above_one_or_0) {
  EXPECT_EQ(replaced("forall = { g = '(0, 2]', m = 'integer [0, infinity)' }\nclaim = 'g^m <= 1'"), "none");
  EXPECT_EQ(replaced("forall = { g = '[0, 1]', m = 'integer [0, infinity)' }\nclaim = 'g^m <= 1'"), "none");
  EXPECT_EQ(replaced("forall = { g = '(0, 1]', m = 'integer [0, infinity)' }\nclaim = '(1 + g)^m >= 1'"), "none");
  EXPECT_EQ(replaced("forall = { g = '(0, 1]', m = 'integer (-infinity, 1]' }\nclaim = 'g^m >= g'"), "none");
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
