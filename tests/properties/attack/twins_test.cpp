#include "properties/attack/twins.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>

#include "properties/attack/claim_library.hpp"
#include "support/error.hpp"
#include "tests/properties/attack/small_claims.hpp"
#include "tests/support/temporary_folder.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

namespace fs = std::filesystem;
using test::claim_about_simplices;
using test::right_claim;
using test::triangle_bindings;
using test::wrong_claim;

class Twins : public testing::Test {
 protected:
  static void write(const fs::path& path, const std::string& text) { std::ofstream(path, std::ios::binary) << text; }

  test::TemporaryFolder folder_;
};

TEST_F(Twins, a_claim_has_those_that_it_does_not_excuse) {
  std::vector<std::string> names;
  for (const Claim& twin : twins_of(right_claim())) names.push_back(twin.name);
  EXPECT_EQ(names, (std::vector<std::string>{"right/radius-twin", "right/without-small"}));
  EXPECT_TRUE(conclusions_without_twin(right_claim()).empty());
  EXPECT_EQ(conclusions_without_twin(wrong_claim()), std::vector<std::string>{"radius"});
  const Claim excused = claim_about_simplices(
      "a",
      "given = [{ claim = \"k >= 1\", no_twin = \"always\" }]\n[[show]]\nclaim = \"k >= 1\"\nno_twin = \"always\"\n");
  EXPECT_TRUE(twins_of(excused).empty());
  EXPECT_TRUE(conclusions_without_twin(excused).empty());
}

TEST_F(Twins, a_bare_truth_is_refuted_on_the_path_along_which_it_fails) {
  // Without a ratio to climb, only the path along xi leads to an image that is so much longer.
  const auto claim = [](const std::string& bound) {
    return parse_claim("name = \"a\"\ninstance = \"simplex-pair\"\ngiven = [\"xi <= " + bound +
                           "\"]\n[[show]]\nclaim = \"not (longest_edge(t) > 1001/1000*longest_edge(s))\"\n",
                       "a.toml", full_vocabulary(), all_signatures());
  };
  const auto refuted = refute(claim("1/990"), {{1, 2}}, {1, 400, 1}, no_progress());
  ASSERT_TRUE(refuted.has_value());
  EXPECT_EQ(decide_witness(claim("1/990"), *refuted), Verdict::refuted);
  EXPECT_FALSE(refute(claim("1/1001"), {{1, 2}}, {1, 400, 1}, no_progress()).has_value());
}

TEST_F(Twins, names_are_taken_apart_and_put_together) {
  const auto twins = twins_of(right_claim());
  EXPECT_EQ(original_name(twins[0]), "right");
  EXPECT_EQ(twin_name(twins[0]), "radius-twin");
  EXPECT_EQ(original_name(right_claim()), "right");
  EXPECT_EQ(twin_name(right_claim()), "");
  EXPECT_EQ(witness_file_name(twins[0], "radius-twin"), "right.radius-twin.json");
  EXPECT_EQ(witness_file_name(twins[1], "radius"), "right.without-small.json");
  EXPECT_EQ(witness_file_name(right_claim(), "radius"), "right.radius.json");
}

TEST_F(Twins, both_twins_are_refuted_and_the_claim_is_not) {
  const Effort effort{60, 40, 1};
  const std::vector<Shape> shapes = {{1, 1}, {2, 2}, {3, 3}};
  for (const Claim& twin : twins_of(right_claim())) {
    const auto witness = refute(twin, shapes, effort, no_progress());
    ASSERT_TRUE(witness.has_value()) << twin.name;
    EXPECT_EQ(witness->twin, twin_name(twin));
    EXPECT_EQ(decide_witness(twin, *witness), Verdict::refuted);
    EXPECT_NO_THROW(require_witness_of(twin, *witness));
    EXPECT_EQ(decide_witness(right_claim(), {"right", "radius", "", "simplex", witness->bindings}), Verdict::proved);
  }
  EXPECT_FALSE(refute(right_claim(), shapes, {20, 20, 1}, no_progress()).has_value());
}

TEST_F(Twins, what_random_samples_do_not_refute_directed_search_does) {
  const Claim claim = claim_about_simplices("a", "[[show]]\nclaim = \"thickness(s) <= 432/1000 or k = 1\"\n");
  EXPECT_FALSE(refute(claim, {{2, 2}}, {40, 1, 1}, no_progress()).has_value());
  EXPECT_TRUE(refute(claim, {{2, 2}}, {40, 3000, 1}, no_progress()).has_value());
}

TEST_F(Twins, a_stored_witness_refutes_its_twin_and_no_other) {
  const auto twins = twins_of(right_claim());
  EXPECT_FALSE(is_refuted_by_stored_witness(twins[0], folder_.path()));
  EXPECT_FALSE(is_refuted_by_stored_witness(twins[0], folder_ / "none"));
  const auto witness = refute(twins[0], {{2, 2}}, {60, 40, 1}, no_progress());
  write(folder_ / "right.radius-twin.json", witness_text(*witness));
  EXPECT_TRUE(is_refuted_by_stored_witness(twins[0], folder_.path()));
  EXPECT_FALSE(is_refuted_by_stored_witness(twins[1], folder_.path()));
  // Under the name of the other twin, cut off, or not refuting.
  write(folder_ / "right.without-small.json", witness_text(*witness));
  EXPECT_THROW((void)is_refuted_by_stored_witness(twins[1], folder_.path()), InputError);
  write(folder_ / "right.radius-twin.json", witness_text(*witness).substr(0, 100));
  EXPECT_THROW((void)is_refuted_by_stored_witness(twins[0], folder_.path()), InputError);
  Witness harmless = *witness;
  harmless.bindings["eta"] = Rational::power_of_two(-100);
  write(folder_ / "right.radius-twin.json", witness_text(harmless));
  EXPECT_THROW((void)is_refuted_by_stored_witness(twins[0], folder_.path()), InputError);
}

TEST_F(Twins, a_witness_whose_hypotheses_fail_refutes_nothing) {
  const Claim claim = claim_about_simplices("a", "given = [\"k = 1\"]\n[[show]]\nname = \"b\"\nclaim = \"k = 1\"\n");
  EXPECT_EQ(decide_witness(claim, {"a", "b", "", "simplex", triangle_bindings(0, 1)}), Verdict::proved);
}

TEST_F(Twins, a_witness_finds_its_claim_or_is_given_another) {
  const fs::path file = folder_ / "wrong.toml";
  write(file,
        "name = \"wrong\"\ninstance = \"simplex\"\n[[show]]\nname = \"radius\"\nclaim = \"circumradius(s) <= "
        "longest_edge(s)\"\n"
        "twin = \"circumradius(s) <= 0\"\n");
  const Witness witness{"moved-away.toml", "radius-twin", "radius-twin", "simplex", triangle_bindings(0, 1)};
  EXPECT_THROW((void)claim_of(witness), InputError);
  EXPECT_EQ(claim_of(witness, file.string()).name, "wrong/radius-twin");
  Witness other = witness;
  other.twin = "without-hope";
  EXPECT_THROW((void)claim_of(other, file.string()), InputError);
  other = witness;
  other.conclusion = "diameter";
  EXPECT_THROW((void)claim_of(other, file.string()), InputError);
  other = witness;
  other.instance_class = "simplex-pair";
  EXPECT_THROW((void)claim_of(other, file.string()), InputError);
  other = witness;
  other.bindings["eta"] = Rational(1);
  EXPECT_THROW((void)claim_of(other, file.string()), InputError);
}

/// Every twin of every claim of the library is refuted by a witness in proofs/claims/witnesses, decided anew. What
/// `delcert attack --all --twins --witnesses proofs/claims/witnesses` finds is written there.
class StoredTwins : public testing::TestWithParam<std::size_t> {};

TEST_P(StoredTwins, are_all_refuted_by_stored_witnesses) {
  const fs::path folder = fs::path(DELCERT_SOURCE_DIR) / "proofs/claims/witnesses";
  const Claim& claim = builtin_claim_list()[GetParam()];
  for (const Claim& twin : twins_of(claim)) {
    EXPECT_TRUE(is_refuted_by_stored_witness(twin, folder)) << twin.name << " has no witness";
  }
  for (const std::string& name : conclusions_without_twin(claim)) {
    ADD_FAILURE() << claim.name << " / " << name << " has neither a twin nor a reason";
  }
}

INSTANTIATE_TEST_SUITE_P(EveryClaim, StoredTwins, testing::Range(std::size_t{0}, builtin_claim_list().size()),
                         [](const testing::TestParamInfo<std::size_t>& of) {
                           std::string name = builtin_claim_list()[of.param].name;
                           std::replace_if(
                               name.begin(), name.end(), [](char c) { return c == '-' || c == '.'; }, '_');
                           return name;
                         });

TEST_F(Twins, no_stored_witness_is_of_a_claim_or_twin_that_is_gone) {
  const fs::path folder = fs::path(DELCERT_SOURCE_DIR) / "proofs/claims/witnesses";
  std::vector<std::string> expected;
  for (const Claim& claim : builtin_claim_list()) {
    for (const Claim& twin : twins_of(claim)) expected.push_back(witness_file_name(twin, ""));
    for (const Conclusion& conclusion : claim.conclusions) {
      expected.push_back(witness_file_name(claim, conclusion.name));
    }
  }
  for (const auto& entry : fs::directory_iterator(folder)) {
    EXPECT_TRUE(std::find(expected.begin(), expected.end(), entry.path().filename().string()) != expected.end())
        << entry.path();
  }
}

/// So a replay says that the file of a claim has changed, if it has. With DELCERT_RENEW in the environment, witnesses
/// that refute the claim as it is now get its text.
TEST_F(Twins, stored_witnesses_carry_the_claim_as_it_is) {
  for (const auto& entry : fs::directory_iterator(fs::path(DELCERT_SOURCE_DIR) / "proofs/claims/witnesses")) {
    const std::string file = entry.path().string();
    Witness witness = read_witness(file);
    const Claim claim = claim_of(witness);
    const std::string text = statement_of(claim);
    if (witness.text != text && std::getenv("DELCERT_RENEW") != nullptr) {
      ASSERT_TRUE(is_refuted(decide_witness(claim, witness))) << file;
      witness.text = text;
      std::ofstream(file) << witness_text(witness);
    }
    EXPECT_EQ(witness.text, text) << file << ": DELCERT_RENEW=1 test_properties_attack --gtest_filter=Twins.stored*";
    EXPECT_EQ(statement_of(claim_in(read_witness(file))), text) << file;
  }
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
