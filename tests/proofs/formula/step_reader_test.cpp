#include "proofs/formula/step_reader.hpp"

#include <gtest/gtest.h>

#include "proofs/formula/claim.hpp"
#include "tests/proofs/formula/vocabulary_checks.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

const std::string head = "name = 'n'\n[[step]]\nname = 's'\n";

std::vector<Step> steps(const std::string& text) { return parse_claim(text, "f.toml", full_vocabulary(), {}).steps; }

std::string error_of(const std::string& text) {
  try {
    (void)steps(text);
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(Steps, all_keys_are_read) {
  const auto all = steps(
      "name = 'n'\nstatus = 'paper'\nsource = 'lem:x'\n"
      "[[step]]\nname = 'ratio'\nlines = '612, 640-641'\nstatus = 'mended'\nnote = 'N'\n"
      "forall = { xi = '(0, 1/4]', k = 'integer [1, infinity)' }\n"
      "let = { a = 'b + c', b = '1/(1 + xi)' }\ngiven = ['k >= 2', 'a > 0']\nconstants = { c = '4/5' }\n"
      "claim = 'a >= c and b^k > 0'\n"
      "[[step]]\nname = 'other'\nlines = '7'\nclaim = '1 < 2'\n");
  ASSERT_EQ(all.size(), 2U);
  const Step& step = all[0];
  EXPECT_EQ(step.name, "ratio");
  EXPECT_EQ(step.lines, "612, 640-641");
  EXPECT_EQ(step.status, ClaimStatus::mended);
  EXPECT_EQ(step.note, "N");
  ASSERT_EQ(step.parameters.size(), 2U);
  EXPECT_TRUE(step.parameters.at("k").is_integer);
  ASSERT_EQ(step.abbreviations.size(), 2U);
  EXPECT_EQ(step.abbreviations[0].name, "b") << "in the order in which they need one another";
  EXPECT_EQ(step.abbreviations[1].name, "a");
  ASSERT_EQ(step.hypotheses.size(), 2U);
  EXPECT_EQ(step.hypotheses[1].name, "hypothesis-2");
  EXPECT_EQ(step.constants.at("c"), test::ratio(4, 5));
  EXPECT_EQ(step.claim.text, "a >= c and b^k > 0");
  EXPECT_EQ(all[1].status, ClaimStatus::paper) << "that of the file";
}

TEST(Steps, abbreviations_may_be_a_list) {
  const auto all = steps(
      head +
      "forall = { x = '[0, 1]' }\nlet = [{ name = 'b', is = '2*x' }, { name = 'a', is = 'b + 1' }]\nclaim = 'a > 0'\n");
  EXPECT_EQ(all.at(0).abbreviations.at(0).name, "b");
  EXPECT_EQ(error_of(head + "let = [{ name = 'b', is = 'a' }, { name = 'a', is = 'b' }]\nclaim = '1 > 0'\n"),
            "f.toml:4:27: b is made of itself");
  EXPECT_EQ(error_of(head + "let = [{ name = 'b' }]\nclaim = '1 > 0'\n"), "f.toml:4:8: the key is is missing");
  EXPECT_EQ(error_of(head + "let = 'b'\nclaim = '1 > 0'\n"),
            "f.toml:4:7: the key let expects a table such as { ratio = \"1/(1 + xi)\" }");
}

TEST(Steps, errors_have_their_place) {
  EXPECT_EQ(error_of(head + "clam = '1 > 0'\n"), "f.toml:4:1: unknown key clam, did you mean claim?");
  EXPECT_EQ(error_of(head + "forall = { x = '(0, 1' }\nclaim = 'x > 0'\n"),
            "f.toml:4:22: the end where the end of the interval, ) or ] was expected");
  EXPECT_EQ(error_of(head + "forall = { x = '(0, 1]' }\nclaim = 'x > y'\n"),
            "f.toml:5:14: nothing here is called y (there are x)");
  EXPECT_EQ(error_of(head + "forall = { sqrt = '(0, 1]' }\nclaim = '1 > 0'\n"),
            "f.toml:4:12: sqrt is no name here: letters, digits and '_', and no function");
  EXPECT_EQ(error_of(head + "forall = { x = '(0, 1]' }\nlet = { x = '1' }\nclaim = '1 > 0'\n"),
            "f.toml:5:9: x is already something else");
  EXPECT_EQ(error_of(head + "constants = { c = '0.8' }\nclaim = '1 > 0'\n").substr(0, 12), "f.toml:4:21:");
  EXPECT_EQ(error_of(head + "claim = 'forall i in 1 .. 3: i > 0'\n"),
            "f.toml:4:10: a quantifier in a step, which speaks of numbers only");
  EXPECT_EQ(error_of(head + "given = ['x']\nclaim = '1 > 0'\n").substr(0, 12), "f.toml:4:11:");
  EXPECT_EQ(error_of(head), "f.toml:2:1: the key claim is missing");
}

TEST(Steps, of_the_paper_say_where_they_stand) {
  const std::string paper = "name = 'n'\nstatus = 'paper'\nsource = 'x'\n[[step]]\nname = 's'\nclaim = '1 > 0'\n";
  EXPECT_EQ(error_of(paper), "f.toml:4:1: a step of the paper says where it stands there: the key lines is missing");
  EXPECT_EQ(error_of(paper + "status = 'user'\n"), "accepted");
  EXPECT_EQ(error_of(paper + "status = 'papers'\n"),
            "f.toml:7:10: a status is \"paper\", \"mended\", \"sharper\" or \"user\", not \"papers\"");
  for (const char* fits : {"1", "12-13", "1, 3-4, 10"})
    EXPECT_EQ(error_of(paper + "lines = '" + fits + "'\n"), "accepted");
  for (const char* wrong : {"", "0", "3-2", "1,2", "5, 4", "1-", "x", "1, "}) {
    EXPECT_TRUE(error_of(paper + "lines = '" + wrong + "'\n").starts_with("f.toml:7:9: ")) << wrong;
  }
}

TEST(Steps, names_are_unique) {
  EXPECT_EQ(error_of(head + "claim = '1 > 0'\n[[step]]\nname = 's'\nclaim = '1 > 0'\n"),
            "f.toml:6:8: two steps of the claim are called s");
  EXPECT_EQ(error_of("name = 'n'\n[[step]]\nname = 'S'\nclaim = '1 > 0'\n").substr(0, 12), "f.toml:3:8: ");
}

TEST(Steps, alone_in_a_file_need_no_instances) {
  EXPECT_EQ(error_of(head + "claim = '1 > 0'\n"), "accepted");
  EXPECT_EQ(error_of("name = 'n'\ninstance = 'simplex'\n[[step]]\nname = 's'\nclaim = '1 > 0'\n"),
            "f.toml:2:12: a file of steps only has no key instance");
  EXPECT_EQ(error_of("name = 'n'\nstep = 'x'\n"), "f.toml:2:8: the key step expects a list");
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
