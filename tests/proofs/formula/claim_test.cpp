#include "proofs/formula/claim.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "proofs/formula/builtin_claims.hpp"
#include "properties/instances/instance_class.hpp"
#include "support/error.hpp"
#include "tests/proofs/formula/source_folder.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

namespace fs = std::filesystem;

Signatures signatures() {
  Signatures result;
  for (const InstanceClass* each : instance_classes()) result[each->name()] = each->signature();
  return result;
}

Claim parsed(const std::string& text) { return parse_claim(text, "a.toml", full_vocabulary(), signatures()); }

std::string error_of(const std::string& text) {
  try {
    (void)parsed(text);
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(Claims, all_keys_are_read) {
  const Claim claim = parsed(
      "name = \"n-1\"\ntitle = \"T\"\nsource = \"lem:x\"\nstatus = \"mended\"\ninstance = \"simplex\"\nnote = \"N\"\n"
      "forall = { eta = \"(0, 1]\" }\n"
      "given = [\"eta < 1\", { name = \"second\", claim = \"k > 1\", no_twin = \"because\" }]\n"
      "[[show]]\nclaim = \"thickness(s) <= 1\"\ntwin = \"thickness(s) <= 1/2\"\n"
      "[[show]]\nname = \"other\"\nclaim = \"eta <= 1\"\nno_twin = \"reason\"\n");
  EXPECT_EQ(claim.file, "a.toml");
  EXPECT_EQ(claim.name, "n-1");
  EXPECT_EQ(claim.title, "T");
  EXPECT_EQ(claim.source, "lem:x");
  EXPECT_EQ(claim.status, ClaimStatus::mended);
  EXPECT_EQ(claim.instance, "simplex");
  EXPECT_EQ(claim.note, "N");
  ASSERT_EQ(claim.parameters.size(), 1U);
  EXPECT_TRUE(claim.parameters.at("eta").has_upper);
  EXPECT_FALSE(claim.parameters.at("eta").has_lower);
  ASSERT_EQ(claim.hypotheses.size(), 2U);
  EXPECT_EQ(claim.hypotheses[0].name, "hypothesis-1");
  EXPECT_EQ(claim.hypotheses[0].text, "eta < 1");
  EXPECT_TRUE(claim.hypotheses[0].no_twin.empty());
  EXPECT_EQ(claim.hypotheses[1].name, "second");
  EXPECT_EQ(claim.hypotheses[1].no_twin, "because");
  ASSERT_EQ(claim.conclusions.size(), 2U);
  EXPECT_EQ(claim.conclusions[0].name, "conclusion-1");
  ASSERT_TRUE(claim.conclusions[0].twin);
  EXPECT_EQ(claim.conclusions[0].twin->name, "conclusion-1-twin");
  EXPECT_EQ(claim.conclusions[1].name, "other");
  EXPECT_FALSE(claim.conclusions[1].twin);
  EXPECT_EQ(claim.conclusions[1].no_twin, "reason");
  EXPECT_EQ(claim.conclusions[1].formula->type, types::truth);
}

TEST(Claims, what_may_be_missing_has_its_default) {
  const Claim claim = parsed("name = \"n\"\ninstance = \"simplex\"\n[[show]]\nclaim = \"k > 0\"\n");
  EXPECT_EQ(claim.status, ClaimStatus::user);
  EXPECT_TRUE(claim.title.empty() && claim.source.empty() && claim.note.empty());
  EXPECT_TRUE(claim.hypotheses.empty() && claim.parameters.empty());
}

TEST(Claims, statuses_have_names) {
  EXPECT_EQ(name_of(ClaimStatus::paper), "paper");
  EXPECT_EQ(name_of(ClaimStatus::mended), "mended");
  EXPECT_EQ(name_of(ClaimStatus::sharper), "sharper");
  EXPECT_EQ(name_of(ClaimStatus::user), "user");
}

TEST(Claims, errors_in_formulas_point_into_the_file) {
  const std::string head = "name = \"n\"\ninstance = \"simplex\"\n";
  EXPECT_EQ(error_of(head + "[[show]]\nclaim = \"k > 1.5\"\n"),
            "a.toml:4:15: a decimal number: decimal numbers are not exact, write a fraction such as 1/4");
  EXPECT_EQ(error_of(head + "[[show]]\nclaim = 'k > q'\n"),
            "a.toml:4:14: nothing here is called q (there are k, m, s)");
  EXPECT_EQ(error_of(head + "[[show]]\nclaim = \"\"\"\nk > 1\n  and q > 1\n\"\"\"\n"),
            "a.toml:6:7: nothing here is called q (there are k, m, s)");
  EXPECT_EQ(error_of(head + "[[show]]\nclaim = \"\"\"k > 1 \\\n  and q > 1\"\"\"\n"),
            "a.toml:5:7: nothing here is called q (there are k, m, s)");
  EXPECT_EQ(
      error_of(head + "given = [{ no_twin = \"\u03b5\u03b5\", claim = \"q > 1\" }]\n[[show]]\nclaim = \"k > 1\"\n"),
      "a.toml:3:37: nothing here is called q (there are k, m, s)");
  EXPECT_EQ(error_of(head + "[[show]]\nclaim = \"k >\"\n"),
            "a.toml:4:13: the end where a number, a name or ( was expected");
  EXPECT_EQ(error_of(head + "forall = { e = \"(0, x)\" }\n[[show]]\nclaim = \"k > 1\"\n"),
            "a.toml:3:21: 'x' where a number was expected");
}

TEST(Claims, texts_of_the_user_are_shown_on_one_line) {
  EXPECT_EQ(error_of("\"a\\nb\" = 1"),
            "a.toml:1:1: unknown key a?b, expected: name, title, source, status, instance, note, points, forall, let, "
            "given, show, step");
  EXPECT_EQ(error_of("name = \"n\"\ninstance = \"a\\nb\"\n"), "a.toml:2:12: no instance class is called a?b");
}

TEST(Claims, a_file_that_cannot_be_read_is_an_error) {
  EXPECT_THROW((void)read_claim("there-is-none.toml", full_vocabulary(), signatures()), InputError);
  EXPECT_THROW((void)read_claim("/", full_vocabulary(), signatures()), InputError);
  EXPECT_THROW((void)read_claim("/dev/zero", full_vocabulary(), signatures()), InputError);
}

TEST(Claims, every_file_of_the_library_is_a_claim_named_after_it) {
  for (const BuiltinClaim& file : builtin_claims()) {
    const Claim claim = parse_claim(file.text, file.name + ".toml", full_vocabulary(), signatures());
    EXPECT_EQ(claim.name, file.name);
    // Two claims are readings of the paper, and not its statements.
    const bool reading = file.name == "top-simplices-suffice" || file.name == "circumcentres-under-distortion";
    EXPECT_EQ(claim.status == ClaimStatus::user, reading) << file.name;
    for (const Conclusion& conclusion : claim.conclusions) {
      EXPECT_TRUE(conclusion.twin || !conclusion.no_twin.empty())
          << file.name << ": " << conclusion.name << " has neither a twin nor a reason why not";
    }
  }
}

std::vector<fs::path> malformed_files() {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(source_folder() / "tests/cli/malformed/claims")) {
    files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

class MalformedClaim : public ::testing::TestWithParam<fs::path> {};

/// The first line of each is "# expect: " and the message after the name of the file.
TEST_P(MalformedClaim, is_refused_with_the_expected_message) {
  std::ifstream stream(GetParam(), std::ios::binary);
  std::string line;
  std::getline(stream, line);
  const std::string prefix = "# expect: ";
  ASSERT_TRUE(line.starts_with(prefix));
  try {
    (void)read_claim(GetParam().string(), full_vocabulary(), signatures());
    FAIL() << GetParam() << " was accepted";
  } catch (const InputError& error) {
    EXPECT_EQ(error.what(), GetParam().string() + line.substr(prefix.size()));
  }
}

std::string name_of_case(const ::testing::TestParamInfo<fs::path>& info) {
  std::string name = info.param.stem().string();
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

INSTANTIATE_TEST_SUITE_P(claims, MalformedClaim, ::testing::ValuesIn(malformed_files()), name_of_case);

TEST(MalformedClaims, are_of_many_kinds) { EXPECT_GE(malformed_files().size(), 35U); }

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
