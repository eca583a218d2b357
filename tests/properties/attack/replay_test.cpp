#include "properties/attack/replay.hpp"

#include <gtest/gtest.h>

#include "properties/attack/twins.hpp"
#include "support/error.hpp"
#include "tests/properties/attack/small_claims.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

/// A witness against the circumradius of a claim of the library, on an obtuse or a right triangle.
Witness witness_on(const char* apex) {
  Witness witness;
  witness.claim = DELCERT_SOURCE_DIR "/examples/claims/circumradius-below-edge.toml";
  witness.conclusion = "radius";
  witness.instance_class = "simplex";
  const std::string text = std::string(R"({"delcert_witness":1,"claim":")") + witness.claim +
                           R"(","conclusion":"radius","twin":"","instance":"simplex","bindings":{"k":{"integer":2},)" +
                           R"("m":{"integer":2},"s":{"simplex":{"points":[["0","0"],["1","0"],)" + apex + "]}}}}";
  return parse_witness(text, "witness");
}

TEST(Replay, says_that_a_flat_triangle_refutes_and_a_right_one_does_not) {
  const Replay flat = replayed(witness_on(R"(["1/2","1/100"])"));
  EXPECT_TRUE(is_proved(flat.hypotheses));
  ASSERT_TRUE(flat.conclusion);
  EXPECT_TRUE(is_refuted(flat.conclusion->verdict));
  EXPECT_EQ(flat.conclusion->text, "circumradius(s) <= longest_edge(s)");
  ASSERT_TRUE(flat.conclusion->ratio);
  EXPECT_GT(flat.conclusion->ratio->lower, 12);

  const Replay right = replayed(witness_on(R"(["0","1"])"));
  ASSERT_TRUE(right.conclusion);
  EXPECT_TRUE(is_proved(right.conclusion->verdict));
  EXPECT_LE(right.conclusion->ratio->upper, 0.51);
}

TEST(Replay, of_another_claim_decides_that_one) {
  const Replay replay =
      replayed(witness_on(R"(["1/2","1/100"])"), DELCERT_SOURCE_DIR "/examples/claims/circumradius-by-thickness.toml");
  ASSERT_TRUE(replay.conclusion);
  EXPECT_TRUE(is_proved(replay.conclusion->verdict));
  EXPECT_THROW((void)replayed(witness_on(R"(["0","1"])"), "no-such-claim"), InputError);
}

TEST(Replay, needs_no_file_if_the_witness_carries_the_text) {
  Witness witness = witness_on(R"(["1/2","1/100"])");
  EXPECT_EQ(replayed(witness).remark, "");
  witness = witness_of(find_claim(witness.claim), 0, witness.bindings);
  EXPECT_EQ(replayed(parse_witness(witness_text(witness), "witness")).remark, "");
  witness.claim = "moved-away.toml";
  const Replay replay = replayed(parse_witness(witness_text(witness), "witness"));
  ASSERT_TRUE(replay.conclusion);
  EXPECT_TRUE(is_refuted(replay.conclusion->verdict));
  EXPECT_EQ(replay.remark.substr(0, 41), "moved-away.toml cannot be compared with t");
  witness.text.clear();
  EXPECT_THROW((void)replayed(witness), InputError);
}

TEST(Replay, decides_what_was_witnessed_and_says_that_the_file_has_changed) {
  const Witness before = witness_on(R"(["1/2","1/100"])");
  Claim other = find_claim(before.claim);
  other.conclusions[0] =
      find_claim(DELCERT_SOURCE_DIR "/examples/claims/circumradius-by-thickness.toml").conclusions[0];
  other.conclusions[0].name = "radius";
  const Replay replay = replayed(witness_of(other, 0, before.bindings));
  EXPECT_TRUE(is_proved(replay.conclusion->verdict));
  EXPECT_EQ(replay.remark,
            before.claim + " has changed since the witness was written; decided is the text in the witness");
}

TEST(Replay, of_a_twin_decides_the_twin_in_the_text) {
  const Claim twin = twins_of(test::right_claim()).at(0);
  Bindings bindings = test::triangle_bindings(0, 1);
  bindings["eta"] = Rational(1);
  const Witness witness = witness_of(twin, 0, bindings);
  EXPECT_EQ(claim_in(witness).name, twin.name);
  EXPECT_EQ(statement_of(claim_in(witness)), statement_of(twin));
  Witness forged = witness;
  forged.conclusion = "another";
  EXPECT_THROW((void)claim_in(forged), InputError);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
