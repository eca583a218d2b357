#include "proofs/errata/errata_text.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace delcert {
namespace DELCERT_THIS_FILE {

Erratum sample(Judgement judgement) {
  Erratum erratum;
  erratum.file = "sample.toml";
  erratum.label = "lem:sample";
  erratum.number = "Lemma 7";
  erratum.lines = {{10, 12}, {20, 20}};
  erratum.judgement = judgement;
  erratum.printed = "|x| ≤ 1\nalways";
  erratum.wrong = "x = 2";
  return erratum;
}

bool mentions(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

TEST(ErrataText, has_a_section_for_what_is_wrong) {
  Erratum erratum = sample(Judgement::constant);
  erratum.decidable = true;
  erratum.command = "delcert attack --replay x.json";
  const std::string text = errata_markdown({erratum});
  EXPECT_TRUE(
      mentions(text,
               "\n### Lemma 7, lines 10-12, 20, lem:sample: changes a constant\n\n> **Printed.** |x| ≤ 1 always\n"
               "\n**Remark.** x = 2\n\n```\ndelcert attack --replay x.json\n```\n"))
      << text;
  EXPECT_FALSE(mentions(text, "**Mended.**"));
  EXPECT_FALSE(mentions(text, "found to hold"));
  EXPECT_TRUE(mentions(text, "| changes a constant | 1 | 1 |\n"));
  EXPECT_TRUE(mentions(text, "| changes a theorem | 0 | 0 |\n"));
}

TEST(ErrataText, has_a_table_of_what_holds) {
  const std::string text = errata_markdown({sample(Judgement::holds)});
  EXPECT_TRUE(mentions(text, "| 10-12, 20 | Lemma 7 | lem:sample | \\|x\\| ≤ 1 always | x = 2 |\n")) << text;
  EXPECT_FALSE(mentions(text, "\n### Lemma"));
  EXPECT_TRUE(mentions(text, "| read: holds | 1 | 0 |\n"));
}

TEST(ErrataText, says_line_where_there_is_one) {
  Erratum erratum = sample(Judgement::word);
  erratum.lines = {{7, 7}};
  EXPECT_TRUE(mentions(errata_markdown({erratum}), "\n### Lemma 7, line 7, lem:sample: needs a word\n"));
}

TEST(ErrataText, has_the_severest_first) {
  std::vector<Erratum> errata{sample(Judgement::misprint), sample(Judgement::word), sample(Judgement::theorem),
                              sample(Judgement::constant)};
  const std::string text = errata_markdown(errata);
  const auto place = [&](const char* kind) { return text.find(std::string("lem:sample: ") + kind); };
  EXPECT_LT(place("changes a theorem"), place("changes a constant"));
  EXPECT_LT(place("changes a constant"), place("needs a word"));
  EXPECT_LT(place("needs a word"), place("misprint"));
  EXPECT_NE(place("misprint"), std::string::npos);
}

TEST(ErrataText, is_json_with_all_keys) {
  const auto document = nlohmann::json::parse(errata_json({sample(Judgement::theorem), sample(Judgement::holds)}));
  ASSERT_EQ(document["errata"].size(), 2U);
  const auto& first = document["errata"][0];
  EXPECT_EQ(first["lines"], "10-12, 20");
  EXPECT_EQ(first["kind"], "changes a theorem");
  EXPECT_EQ(first["printed"], "|x| ≤ 1\nalways");
  EXPECT_EQ(first["decidable"], false);
  EXPECT_EQ(first["mended"], "");
  EXPECT_EQ(first["number"], "Lemma 7");
  EXPECT_EQ(first["defence"], "");
  EXPECT_EQ(first.size(), 13U);
  EXPECT_TRUE(mentions(document["text"], "preprint"));
  EXPECT_TRUE(nlohmann::json::parse(errata_json({}))["errata"].empty());
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
