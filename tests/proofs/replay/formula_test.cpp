#include "proofs/replay/formula.hpp"

#include <gtest/gtest.h>

#include "proofs/prover/proof_log.hpp"
#include "tests/proofs/prover/prove_text.hpp"

namespace delcert::replay {
namespace DELCERT_THIS_FILE {

std::string read(const std::string& text) { return text_of(*read_formula(text)); }

TEST(ReplayFormulas, are_read_by_precedence) {
  EXPECT_EQ(read("a + b*c^2 - d/e"), "(- (+ a (* b (^ c 2))) (/ d e))");
  EXPECT_EQ(read("-x^2"), "(- (^ x 2))");
  EXPECT_EQ(read("2^-x^3"), "(^ 2 (- (^ x 3)))");
  EXPECT_EQ(read("a - b - c"), "(- (- a b) c)");
  EXPECT_EQ(read("0 < x <= 1/4"), "(and (< 0 x) (<= x (/ 1 4)))");
  EXPECT_EQ(read("p < 1 or q < 1 and not r < 1 implies s < 1 implies t < 1"),
            "(implies (or (< p 1) (and (< q 1) (not (< r 1)))) (implies (< s 1) (< t 1)))");
  EXPECT_EQ(read("max(x, -y, 007) = sqrt(abs(log2(z)))"), "(= (max x (- y) 7) (sqrt (abs (log2 z))))");
  EXPECT_EQ(read("hoop_bound(x, y + 1) < 1"), "(< (/ (* (^ 2 13) x) (^ (+ y 1) 3)) 1)");
}

TEST(ReplayFormulas, that_are_none_are_refused) {
  for (const char* wrong : {"", "x <", "(x < 1", "x < 1)", "x ! 1", "f(x) < 1", "sqrt(x, y) < 1", "min(x) < 1",
                            "hoop_bound(x) < 1", "forall p in s: p < 1", "x == 1", "1.5 < x", "2x < 1"}) {
    EXPECT_THROW((void)read_formula(wrong), Malformed) << wrong;
  }
}

TEST(ReplayFormulas, have_names_replaced) {
  const Meanings meanings{{"c", formula_of(Number::read("-3/4"))}, {"x", read_formula("y + 1")}};
  EXPECT_EQ(text_of(*with_meanings(read_formula("c*x < z"), meanings)), "(< (* (- (/ 3 4)) (+ y 1)) z)");
  EXPECT_EQ(text_of(*formula_of(Number(5))), "5");
}

// Two readers of the same language, written apart from each other.
TEST(ReplayFormulas, are_what_the_prover_reads) {
  for (const char* claim :
       {"x + y*z^2 - 3/4 <= 1", "-x^2 < y", "0 < x <= y < 2", "x < 1 or y < 1 and not z < 1 implies x <= y",
        "(x < 1 implies y < 1) implies z < 1", "max(x, -y, z/2) >= min(x, y)", "sqrt(x) <= log2(y + 1) + abs(x - z)",
        "k^(3/2) >= 2^(-k)", "constant_c(k, x) >= constant_c_tilde(k, y/2)", "flake_parameter(k, x, y) < z",
        "hoop_bound(x, y) < hoop_bound_tilde(k, x, y)", "2^3^2 = x", "x - -y = --z", "not not x = y"}) {
    const Step step = delcert::test::step(
        "forall = { x = '(0, 1]', y = '(0, 1]', z = '(0, 1]', k = 'integer [1, 9]' }\n"
        "claim = '" +
        std::string(claim) + "'");
    EXPECT_EQ(read(claim), s_expression(*expanded(step, step.claim.formula))) << claim;
  }
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::replay
