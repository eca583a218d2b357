#include "proofs/formula/arithmetic_vocabulary.hpp"

#include "tests/proofs/formula/vocabulary_checks.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

TEST(ArithmeticVocabulary, Roots) {
  const Bindings none;
  expect_equal("sqrt(2)*sqrt(8)", "4", none);
  expect_equal("sqrt(2) + sqrt(3)", "sqrt(5 + 2*sqrt(6))", none);
  EXPECT_EQ(verdict("sqrt(0 - 1) >= 0", none), Verdict::undecided);
  expect_equal("abs(sqrt(2) - sqrt(3))", "sqrt(3) - sqrt(2)", none);
}

TEST(ArithmeticVocabulary, ExtremaOfSeveralNumbers) {
  const Bindings none;
  expect_equal("min(3, 2, 5/2)", "2", none);
  expect_equal("max(3, sqrt(10), 5/2)", "sqrt(10)", none);
}

TEST(ArithmeticVocabulary, BinaryLogarithms) {
  const Bindings none;
  expect_equal("log2(1/8)", "-3", none);
  EXPECT_EQ(verdict("log2(3) > 19/12", none), Verdict::proved);
  EXPECT_EQ(verdict("log2(3) > 27/17", none), Verdict::refuted);
  EXPECT_EQ(verdict("log2(0) < 1", none), Verdict::undecided);
}

TEST(ArithmeticVocabulary, Ranges) {
  const Bindings n{{"n", 3L}};
  EXPECT_EQ(verdict("forall i in 1..n: i <= 3", n), Verdict::proved);
  EXPECT_EQ(verdict("forall i in 0..n: i < 3", n), Verdict::refuted);
  EXPECT_EQ(verdict("exists i in 4..n: i = i", n), Verdict::refuted);
}

TEST(ArithmeticVocabulary, TheConstantsOfThePaper) {
  const Bindings m{{"m", 2L}, {"mu0", Rational(1)}, {"rho0", ratio(1, 4)}};
  // 4·4 + 5·2 + 21 = 47, 5·4 + 5·2 + 21 = 51.
  expect_equal("constant_c(m, mu0)", "2*sqrt(2)*2^47", m);
  expect_equal("constant_c_tilde(m, mu0)", "2*sqrt(2)*2^51", m);
  expect_equal("flake_parameter(m, mu0, rho0)*constant_c(m, mu0)", "rho0", m);
  expect_equal("hoop_bound(3, 1/2)", "2^16*3", m);
  expect_equal("hoop_bound_tilde(m, 3, 1/2)", "2^19*3*2*sqrt(2)", m);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
