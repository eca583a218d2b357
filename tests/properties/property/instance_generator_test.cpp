// Every claim of the library holds on random instances of its class, but for the conclusions that a stored witness
// refutes: those are results (docs/errata.md).

#include "properties/property/instance_generator.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>

namespace delcert::test {
namespace {

const std::filesystem::path witnesses = std::filesystem::path(DELCERT_SOURCE_DIR) / "proofs/claims/witnesses";

std::filesystem::path witness_against(const Claim& claim, const Conclusion& conclusion) {
  return witnesses / (claim.name + "." + conclusion.name + ".json");
}

class EveryClaim : public testing::TestWithParam<std::size_t> {
 protected:
  const Claim& claim() const { return builtin_claim_list()[GetParam()]; }
};

TEST_P(EveryClaim, holds_on_random_instances_unless_a_witness_refutes_it) {
  std::vector<bool> is_refuted;
  for (const Conclusion& conclusion : claim().conclusions) {
    is_refuted.push_back(std::filesystem::exists(witness_against(claim(), conclusion)));
  }
  const bool held = rc::check(claim().name, [&] {
    const auto instance = *instances_for(claim());
    const Attempt result = attempt(claim(), instance.bindings);
    RC_PRE(is_proved(result.hypotheses));
    for (std::size_t at = 0; at < is_refuted.size(); ++at) {
      if (!is_refuted[at]) RC_ASSERT_FALSE(delcert::is_refuted(result.conclusions[at].verdict));
    }
  });
  EXPECT_TRUE(held);
}

TEST_P(EveryClaim, is_refuted_by_the_witness_that_is_stored_against_it) {
  for (std::size_t at = 0; at < claim().conclusions.size(); ++at) {
    const auto path = witness_against(claim(), claim().conclusions[at]);
    if (!std::filesystem::exists(path)) continue;
    const Witness witness = read_witness(path.string());
    EXPECT_EQ(witness.twin, "");
    const Attempt result = attempt(claim(), witness.bindings);
    ASSERT_TRUE(is_proved(result.hypotheses)) << path;
    EXPECT_TRUE(is_refuted(result.conclusions[at].verdict)) << path;
  }
}

INSTANTIATE_TEST_SUITE_P(Claims, EveryClaim, testing::Range<std::size_t>(0, builtin_claim_list().size()),
                         [](const testing::TestParamInfo<std::size_t>& parameter) {
                           std::string name = builtin_claim_list()[parameter.param].name;
                           std::replace_if(
                               name.begin(), name.end(), [](char c) { return c == '-' || c == '.'; }, '_');
                           return name;
                         });

// The twin of the property: one that is false is not found to hold.
TEST(Properties, find_a_false_claim) {
  const Claim claim = parse_claim(
      "name = \"false\"\ninstance = \"simplex\"\n[[show]]\nclaim = \"circumradius(s) <= longest_edge(s)\"\n", "false",
      full_vocabulary(), all_signatures());
  std::size_t violations = 0;
  for (std::uint32_t number = 0; number < 200; ++number) {
    const auto instance = instances_for(claim)(rc::Random(number), 100).value();
    const Attempt result = attempt(claim, instance.bindings);
    if (is_refuted(result.conclusions.at(0).verdict)) ++violations;
  }
  EXPECT_GT(violations, 0U);
}

}  // namespace
}  // namespace delcert::test
