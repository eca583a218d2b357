#include "proofs/replay/stated_step.hpp"

#include <gtest/gtest.h>

#include "proofs/formula/builtin_claims.hpp"
#include "proofs/prover/proof_log.hpp"
#include "proofs/replay/builtin_steps.hpp"
#include "tests/proofs/prover/prove_text.hpp"

namespace delcert::replay {
namespace DELCERT_THIS_FILE {

std::string refusal(const std::string& text) {
  StatedClaims claims;
  try {
    add_claim(claims, text, "c.toml");
    return "accepted";
  } catch (const Malformed& malformed) {
    return malformed.what();
  }
}

TEST(StatedRanges, are_read_and_written) {
  for (const char* text :
       {"[0, 1]", "(0, 1/4]", "integer [1, infinity)", "(-infinity, -3/4)", "(-infinity, infinity)"}) {
    EXPECT_EQ(text_of(read_range(text)), text);
  }
  EXPECT_EQ(text_of(read_range(" integer[ 2,4/2 ]")), "integer [2, 2]");
  for (const char* wrong :
       {"", "0, 1", "[0, 1", "[0 1]", "[0, infinity]", "[-infinity, 0]", "real [0, 1]", "(infinity, 1)"}) {
    EXPECT_THROW((void)read_range(wrong), Malformed) << wrong;
  }
  EXPECT_FALSE(read_range("[0, 1]") == read_range("[0, 1)"));
  EXPECT_FALSE(read_range("[0, 1]") == read_range("integer [0, 1]"));
}

TEST(StatedSteps, that_cannot_be_read_are_refused_with_the_file) {
  const std::string head = "name = 'c'\n[[step]]\nname = 'a'\n";
  EXPECT_EQ(refusal(head + "claim = 'x < 1'"), "accepted");
  EXPECT_EQ(refusal("name = ").substr(0, 9), "c.toml:1:");
  EXPECT_EQ(refusal("step = 1"), "c.toml: the key step is no list of tables");
  EXPECT_EQ(refusal(head), "c.toml: step a: the claim of a step is no string");
  EXPECT_EQ(refusal(head + "claim = 'x <'"), "c.toml: step a: the formula \"x <\" cannot be read at \"\"");
  EXPECT_EQ(refusal(head + "claim = 'x < 1'\n[[step]]\nname = 'a'\nclaim = 'x < 1'"),
            "c.toml: step a: it is there twice");
  EXPECT_EQ(refusal(head + "let = { x = 'y', y = 'x' }\nclaim = 'x < 1'"), "c.toml: step a: x is made of itself");
  EXPECT_EQ(refusal(head + "forall = { x = '[0, 1' }\nclaim = 'x < 1'"), "c.toml: step a: no range: [0, 1");
}

// That both readers take them for the same is seen where the logs of all steps are replayed (tests/cli/prove.cmake).
TEST(StatedSteps, of_the_library_are_read_from_the_same_texts) {
  const auto& texts = builtin_texts_to_replay();
  const auto& claims = builtin_claims();
  ASSERT_EQ(texts.size(), claims.size());
  std::size_t steps = 0;
  for (std::size_t at = 0; at < texts.size(); ++at) {
    EXPECT_EQ(texts[at].name, claims[at].name);
    EXPECT_EQ(texts[at].text, claims[at].text);
  }
  for (const auto& [name, claim] : builtin_claims_as_stated()) {
    EXPECT_EQ(claim.source, "proofs/claims/" + name + ".toml");
    steps += claim.steps.size();
  }
  EXPECT_GT(steps, 100U);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::replay
