// Every claim of the library holds on random instances of its class, but for the conclusions that a stored witness
// refutes: those are results (docs/errata.md).

#include "properties/property/instance_generator.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "properties/attack/attempt.hpp"
#include "properties/attack/claim_library.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

const std::filesystem::path witnesses = std::filesystem::path(DELCERT_SOURCE_DIR) / "proofs/claims/witnesses";

std::filesystem::path witness_against(const Claim& claim, const Conclusion& conclusion) {
  return witnesses / (claim.name + "." + conclusion.name + ".json");
}

/// Whether each conclusion that no stored witness refutes holds on random instances: proved there, not merely not
/// refuted. Prints an instance on which one does not. There is no conclusion that may stay undecided.
/// A curved net takes as long as ten flat ones, so only one case of eight has one.
bool holds_on_random_instances(const Claim& claim) {
  const int one_in = claim.instance == "curved-net" ? 8 : 1;
  std::vector<bool> has_witness;
  for (const Conclusion& conclusion : claim.conclusions) {
    has_witness.push_back(std::filesystem::exists(witness_against(claim, conclusion)));
  }
  return rc::check(claim.name, [&] {
    if (one_in > 1 && *rc::gen::inRange(0, one_in) != 0) return;
    const auto instance = *instances_for(claim);
    const Attempt result = attempt(claim, instance.bindings);
    RC_ASSERT_FALSE(is_undecided(result.hypotheses));
    RC_PRE(is_proved(result.hypotheses));
    for (std::size_t at = 0; at < has_witness.size(); ++at) {
      if (!has_witness[at]) RC_ASSERT(is_proved(result.conclusions[at].verdict));
    }
  });
}

class EveryClaim : public testing::TestWithParam<std::size_t> {
 protected:
  const Claim& claim() const { return builtin_claim_list()[GetParam()]; }
};

TEST_P(EveryClaim, holds_on_random_instances_unless_a_witness_refutes_it) {
  EXPECT_TRUE(holds_on_random_instances(claim()));
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

Claim about_simplices(const std::string& claim) {
  return parse_claim("name = \"a\"\ninstance = \"simplex\"\n[[show]]\nclaim = \"" + claim + "\"\n", "a",
                     full_vocabulary(), all_signatures());
}

// The twins of the property: neither a claim that is false nor one that nobody can decide is found to hold.
TEST(Property, holds_of_a_true_claim) { EXPECT_TRUE(holds_on_random_instances(about_simplices("thickness(s) <= 1"))); }

TEST(Property, fails_of_a_false_claim) {
  EXPECT_FALSE(holds_on_random_instances(about_simplices("circumradius(s) <= longest_edge(s)")));
}

TEST(Property, fails_of_a_claim_that_is_undecided) {
  EXPECT_FALSE(holds_on_random_instances(about_simplices("1/(k - k) <= 1")));
}

TEST(Property, fails_of_a_claim_whose_hypotheses_are_undecided_or_never_met) {
  Claim claim = about_simplices("thickness(s) <= 1");
  claim.hypotheses.push_back(
      {{"undecided", "1/(k - k) <= 1", about_simplices("1/(k - k) <= 1").conclusions[0].formula}, ""});
  EXPECT_FALSE(holds_on_random_instances(claim));
  claim.hypotheses[0].formula = about_simplices("k < 1").conclusions[0].formula;
  EXPECT_FALSE(holds_on_random_instances(claim));
}

TEST(Shrinking, comes_to_simpler_instances_that_take_less_to_write) {
  const Claim claim = find_claim("circumradius-under-distortion");
  const GeneratedInstance instance = instances_for(claim)(rc::Random(1), 100).value();
  const std::size_t size = written_size(*instance.its_class, instance.bindings);
  const auto simpler = simpler_instances(instance);
  EXPECT_FALSE(simpler.empty());
  for (const GeneratedInstance& each : simpler) EXPECT_LT(written_size(*each.its_class, each.bindings), size);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
