#include "proofs/publication/citation.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>

#include "delcert_version.hpp"
#include "support/error.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

std::string citation_file() {
  std::ifstream file(DELCERT_SOURCE_DIR "/CITATION.cff");
  return {std::istreambuf_iterator<char>(file), {}};
}

bool has_line(const std::string& text, const std::string& line) { return text.find(line + "\n") != std::string::npos; }

std::string field(const Reference& reference, const std::string& name) {
  for (const auto& [key, value] : reference.fields) {
    if (key == name) return value;
  }
  return "no " + name;
}

CertificateSummary certificate() {
  CertificateSummary result;
  result.manifold.name = "my_torus";
  result.manifold.dimension = Dimension(2);
  result.software = {{"delcert", "0.2.0"}};
  result.levels = {{"0", {}}, {"2s", {}}};
  result.points.resize(3);
  result.simplices.resize(4);
  result.seal = std::string(63, 'a') + "b";
  result.sealed_bytes = result.seal;
  return result;
}

TEST(Citation, says_what_the_citation_file_says) {
  const std::string file = citation_file();
  const Reference paper = reference_of_paper();
  const std::string article = file.substr(file.find("- type: article"));
  for (const char* name : {"title", "journal", "volume", "year", "doi"})
    EXPECT_TRUE(has_line(article, std::string("    ") + name + ": " + field(paper, name))) << name;
  EXPECT_TRUE(has_line(article, "    issue: " + field(paper, "number")));
  const std::string pages = field(paper, "pages");
  EXPECT_TRUE(has_line(article, "    start: " + pages.substr(0, pages.find('-'))));
  EXPECT_TRUE(has_line(article, "    end: " + pages.substr(pages.find('-') + 1)));
  for (const char* name : {"Boissonnat", "Dyer", "Ghosh"}) {
    EXPECT_TRUE(has_line(article, std::string("      - family-names: ") + name) ||
                has_line(article, std::string("        family-names: ") + name));
    EXPECT_NE(field(paper, "author").find(name), std::string::npos);
  }
  const Reference software = reference_of_software();
  EXPECT_TRUE(has_line(file, "title: " + field(software, "title")));
  EXPECT_TRUE(has_line(file, "  - name: " + field(software, "author")));
  EXPECT_TRUE(has_line(file, std::string("version: ") + version));
  EXPECT_TRUE(has_line(file, "license: GPL-3.0-or-later"));
  EXPECT_FALSE(has_line(file, "title: delzert"));
}

TEST(Citation, has_a_key_and_the_digest_of_each_certificate) {
  const Reference reference = reference_of(certificate());
  EXPECT_EQ(reference.key, "delcert-aaaaaaaaaaaa");
  EXPECT_NE(text_of(reference).find("of my_torus. Data, made by delcert 0.2.0. 3 points, 4 simplices of dimension 2, "
                                    "levels 0, 2s; SHA-256 " +
                                    std::string(63, 'a') + "b.\n"),
            std::string::npos)
      << text_of(reference);
  const std::string bibtex = bibtex_of(reference);
  EXPECT_EQ(bibtex.rfind("@misc{delcert-aaaaaaaaaaaa,\n", 0), 0U);
  EXPECT_NE(bibtex.find("of my\\_torus}}"), std::string::npos) << bibtex;
  EXPECT_NE(bibtex.find("\\allowbreak aaaaaaab}"), std::string::npos) << bibtex;
}

TEST(Citation, refuses_a_certificate_that_was_changed) {
  CertificateSummary changed = certificate();
  changed.sealed_bytes = std::string(64, 'c');
  EXPECT_THROW((void)reference_of(changed), InputError);
}

TEST(Citation, cannot_be_led_out_of_its_braces) {
  CertificateSummary hostile = certificate();
  hostile.manifold.name = "}\\input{x}%\n@misc{y}";
  const std::string bibtex = bibtex_of(reference_of(hostile));
  EXPECT_EQ(bibtex.find("\\input"), std::string::npos) << bibtex;
  EXPECT_EQ(bibtex.find("\n@"), std::string::npos) << bibtex;
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
