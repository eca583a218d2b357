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

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
