#include "properties/attack/claim_text.hpp"

#include <gtest/gtest.h>

#include <set>

#include "properties/attack/identity.hpp"
#include "support/error.hpp"
#include "tests/properties/attack/small_claims.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

Claim read_back(const Claim& claim) {
  return parse_claim(claim_text(claim), claim.name, full_vocabulary(), all_signatures());
}

TEST(ClaimText, of_every_claim_of_the_library_is_that_claim) {
  for (const Claim& claim : builtin_claim_list()) {
    const Claim back = read_back(claim);
    EXPECT_EQ(contents_of(back, {2, 2}), contents_of(claim, {2, 2}));
    EXPECT_EQ(back.source, claim.source);
    EXPECT_EQ(back.status, claim.status);
    EXPECT_EQ(claim_text(back), claim_text(claim));
  }
}

TEST(ClaimText, keeps_ranges_and_whatever_stands_in_texts) {
  Claim claim = test::right_claim();
  claim.parameters.at("eta") = {Rational(-1) / Rational(3), Rational::power_of_two(-12), true, false};
  claim.source = "“Lemma” \"7\"\\\n§";
  const Claim back = read_back(claim);
  EXPECT_EQ(contents_of(back, {2, 2}), contents_of(claim, {2, 2}));
  EXPECT_EQ(back.source, claim.source);
}

TEST(ClaimText, keeps_points_abbreviations_and_ranges_without_end) {
  const Claim claim = parse_claim(
      "name = 'own'\ninstance = 'point-set'\nforall = { t = '[1, infinity)' }\n"
      "let = { longest = 'max(e in edges(p): longest_edge(e))', half = 'longest/2' }\ngiven = ['half > 0']\n"
      "[points]\nnumber = '3 .. 4'\ndimension = 2\nbox = ['[0, 1]', '(-1/3, 1)']\nconstraints = ['edge(p, 0, 1) < t']\n"
      "[[show]]\nclaim = 'longest <= t*longest_edge(p)'\n",
      "own.toml", full_vocabulary(), all_signatures());
  const Claim back = read_back(claim);
  EXPECT_EQ(claim_text(back), claim_text(claim));
  EXPECT_EQ(contents_of(back, {2, 2}), contents_of(claim, {2, 2}));
  EXPECT_EQ(back.abbreviations.size(), 2U);
  EXPECT_EQ(back.hypotheses.size(), claim.hypotheses.size());
  EXPECT_FALSE(back.parameters.at("t").upper.has_value());
  Claim changed = claim;
  changed.abbreviations[1].text = "longest/3";
  EXPECT_NE(claim_text(changed), claim_text(claim));
  EXPECT_NE(contents_of(changed, {2, 2}), contents_of(claim, {2, 2}));
}

TEST(ClaimText, changes_with_whatever_an_attack_depends_on_and_with_nothing_else) {
  const Claim claim = test::right_claim();
  std::set<std::string> texts{claim_text(claim)};
  const auto add = [&](auto change) {
    Claim changed = claim;
    change(changed);
    texts.insert(claim_text(changed));
  };
  add([](Claim& changed) { changed.title += "!"; });
  add([](Claim& changed) { changed.file += "!"; });
  add([](Claim& changed) { changed.conclusions[0].twin.reset(); });
  EXPECT_EQ(texts.size(), 1U);
  add([](Claim& changed) { changed.source += "s"; });
  for (const Claim& changed : test::changes_of_right_claim()) texts.insert(claim_text(changed));
  EXPECT_EQ(texts.size(), 9U);
}

TEST(FileText, is_that_of_the_library_or_of_the_disk) {
  const Claim of_the_library = find_claim("thickness-and-singular-value");
  EXPECT_NE(file_text_of(of_the_library).find("name = \"thickness-and-singular-value\""), std::string::npos);
  const std::string file = DELCERT_SOURCE_DIR "/examples/claims/circumradius-below-edge.toml";
  EXPECT_EQ(read_claim(file, full_vocabulary(), all_signatures()).name,
            parse_claim(file_text_of(find_claim(file)), file, full_vocabulary(), all_signatures()).name);
  Claim gone = of_the_library;
  gone.file = "no-such-file.toml";
  EXPECT_THROW((void)file_text_of(gone), InputError);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
