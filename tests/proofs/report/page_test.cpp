#include "proofs/report/page.hpp"

#include <gtest/gtest.h>

#include "proofs/report/page_sources.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

std::size_t occurrences(const std::string& text, std::string_view part) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
  return count;
}

std::string data_of(const std::string& page) {
  const std::string begin = "id=\"delcert-data\">";
  const std::size_t at = page.find(begin) + begin.size();
  return page.substr(at, page.find("</script>", at) - at);
}

TEST(Page, keeps_hostile_texts_as_data) {
  const std::string hostile = "</script><script>alert(1)</script><!-- ]]> \xE2\x80\xAE \xFF & \"' \\";
  PageItem item;
  item.data = {{"kind", "certificate"}, {"name", hostile}};
  const std::string page = html_page({item}, "go();", "p{}");
  EXPECT_EQ(occurrences(page, "<script"), 2U);
  EXPECT_EQ(occurrences(page, "</script>"), 2U);
  EXPECT_EQ(occurrences(page, "<!--"), 0U);
  const auto data = nlohmann::json::parse(data_of(page));
  const auto name = data.at("items").at(0).at("name").get<std::string>();
  // All but the byte that is no UTF-8.
  EXPECT_EQ(name.substr(0, 46), hostile.substr(0, 46));
  EXPECT_NE(name.find("\xEF\xBF\xBD"), std::string::npos);
}

TEST(Page, allows_its_own_script_and_style_by_their_hashes_and_nothing_else) {
  const std::string page = html_page({}, "go();", "p{}");
  // printf 'go();' | openssl dgst -sha256 -binary | base64
  EXPECT_NE(page.find("default-src 'none'; script-src 'sha256-bYOqbsii8BMz1hC57p5sZG4K4cMuk6QQDiwupM2aRMM='; style-src "
                      "'sha256-gG2yISYereRMiG2lMXrbiUgi0Ubw9p7QCeWcroOvy9Y=';"),
            std::string::npos)
      << page.substr(0, 600);
  EXPECT_NE(html_page({}, "go() ;", "p{}").find("style-src 'sha256-gG2yISYereRMiG2lMXrbiUgi0Ubw9p7QCeWcroOvy9Y='"),
            std::string::npos);
  EXPECT_EQ(html_page({}, "go() ;", "p{}").find("bYOqbsii8BMz1hC57p5sZG4K4cMuk6QQDiwupM2aRMM="), std::string::npos);
}

TEST(Page, has_the_blocks_of_items_that_have_one) {
  PageItem with, without;
  with.data = without.data = {{"kind", "certificate"}};
  with.block = "QUJD";
  const std::string page = html_page({without, with}, "", "");
  EXPECT_NE(page.find("id=\"delcert-block-1\">QUJD</script>"), std::string::npos);
  EXPECT_EQ(page.find("delcert-block-0"), std::string::npos);
}

TEST(Page, is_made_of_the_bundle) {
  const std::string page = html_page({});
  EXPECT_NE(page.find(std::string("<script>") + std::string(page_script()) + "</script>"), std::string::npos);
  EXPECT_NE(page.find(std::string("<style>") + std::string(page_style()) + "</style>"), std::string::npos);
  EXPECT_GT(page_script().size(), 20000U);
  for (const std::string_view source : {page_script(), page_style()}) {
    EXPECT_EQ(source.find("</"), std::string_view::npos);
    EXPECT_EQ(source.find('\r'), std::string_view::npos);
  }
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
