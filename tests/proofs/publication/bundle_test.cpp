#include "proofs/publication/bundle.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "proofs/certificate/sha256.hpp"
#include "support/error.hpp"
#include "tests/proofs/certificate/small_run.hpp"
#include "tests/support/temporary_folder.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

BundledCertificate torus(const std::string& file) {
  const test::TemporaryFolder folder;
  small_run().write(folder / "c.json");
  return {file, bytes_of(folder / "c.json"), read_certificate(folder / "c.json")};
}

const BundleFacts& some_facts() {
  static const BundleFacts facts{"Tori & <others>", {"Doe, Jane", "The group"}, "CC-BY-4.0", "2026-05-31"};
  return facts;
}

std::string text_named(const std::vector<ArchiveFile>& files, const std::string& name) {
  const auto file = std::find_if(files.begin(), files.end(), [&](const auto& each) { return each.name == name; });
  return file == files.end() ? "no " + name : file->bytes;
}

std::string digest_of(const std::string& bytes) {
  Sha256 hash;
  hash.update(bytes);
  return hash.digest();
}

std::string refusal(const std::vector<BundledCertificate>& certificates, const BundleFacts& facts) {
  try {
    (void)bundle_files(certificates, facts);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

TEST(Bundle, has_every_file_with_its_digest) {
  const auto files = bundle_files({torus("a.json"), torus("b.json.zst")}, some_facts());
  ASSERT_EQ(files.back().name, "SHA256SUMS");
  std::string expected;
  for (const ArchiveFile& file : files) {
    if (file.name != "SHA256SUMS") expected += digest_of(file.bytes) + "  " + file.name + "\n";
  }
  EXPECT_EQ(files.back().bytes, expected);
  for (const char* name : {"certificates/a.json", "manifolds/a.json", "exports/a.vtu", "exports/a.off",
                           "certificates/b.json.zst", "exports/b.off", "references.bib", "README.md"})
    EXPECT_FALSE(text_named(files, name).starts_with("no ")) << name;
  EXPECT_EQ(text_named(files, "certificates/a.json"), torus("a.json").bytes);
  EXPECT_EQ(nlohmann::json::parse(text_named(files, "manifolds/a.json")).at("name"), "torus-2");
}

TEST(Bundle, has_the_source_of_the_checker_where_it_is_given) {
  const auto with = bundle_files({torus("a.json")}, some_facts(), {{"checker/VERSION", "0.2\n"}});
  EXPECT_EQ(text_named(with, "checker/VERSION"), "0.2\n");
  EXPECT_TRUE(has(text_named(with, "SHA256SUMS"), "  checker/VERSION\n"));
  EXPECT_TRUE(has(text_named(with, "ro-crate-metadata.json"), "checker/VERSION"));
  EXPECT_TRUE(has(text_named(with, "README.md"), "cmake -S checker/proofs/checker"));
  const auto without = bundle_files({torus("a.json")}, some_facts());
  EXPECT_FALSE(has(text_named(without, "README.md"), "cmake"));
}

TEST(Bundle, says_what_it_is_to_archives) {
  const auto files = bundle_files({torus("a.json")}, some_facts());
  const auto zenodo = nlohmann::json::parse(text_named(files, ".zenodo.json"));
  EXPECT_EQ(zenodo.at("title"), "Tori & <others>");
  EXPECT_EQ(zenodo.at("creators").at(0).at("name"), "Doe, Jane");
  EXPECT_EQ(zenodo.at("license"), "CC-BY-4.0");
  const auto meta = nlohmann::json::parse(text_named(files, "codemeta.json"));
  EXPECT_EQ(meta.at("author").at(0).at("familyName"), "Doe");
  EXPECT_EQ(meta.at("author").at(1).at("name"), "The group");
  const auto crate = nlohmann::json::parse(text_named(files, "ro-crate-metadata.json"));
  std::size_t described = 0;
  for (const auto& entity : crate.at("@graph")) {
    if (entity.at("@type") != "File") continue;
    ++described;
    EXPECT_EQ(entity.at("contentSize"), std::to_string(text_named(files, entity.at("@id").get<std::string>()).size()));
  }
  // But for itself and for the sums.
  EXPECT_EQ(described, files.size() - 2);
  EXPECT_TRUE(has(text_named(files, "CITATION.cff"), "  - family-names: \"Doe\"\n    given-names: \"Jane\"\n"));
  EXPECT_TRUE(has(text_named(files, "CITATION.cff"), "  - name: \"The group\"\n"));
}

TEST(Bundle, states_no_license_that_was_not_given) {
  BundleFacts facts = some_facts();
  facts.license.clear();
  const auto files = bundle_files({torus("a.json")}, facts);
  EXPECT_FALSE(nlohmann::json::parse(text_named(files, ".zenodo.json")).contains("license"));
  EXPECT_FALSE(has(text_named(files, "CITATION.cff"), "license"));
  EXPECT_TRUE(has(text_named(files, "ro-crate-metadata.json"), "\"license\": \"No license is stated.\""));
}

TEST(Bundle, is_the_same_for_the_same_certificates) {
  EXPECT_EQ(zip_archive(bundle_files({torus("a.json")}, some_facts())),
            zip_archive(bundle_files({torus("a.json")}, some_facts())));
}

TEST(Bundle, refuses_what_it_cannot_hold) {
  EXPECT_TRUE(has(refusal({torus("a.json"), torus("a.json.zst")}, some_facts()), "a.json.zst: there is another"));
  for (const char* name : {"../a.json", "a b.json", "-rf.json", "$(x).json", ".json", ""})
    EXPECT_TRUE(has(refusal({torus(name)}, some_facts()), "the name of a certificate")) << name;
  BundledCertificate changed = torus("a.json");
  changed.certificate.sealed_bytes = std::string(64, '0');
  EXPECT_TRUE(has(refusal({changed}, some_facts()), "a.json: the seal is wrong"));
  EXPECT_TRUE(has(refusal({}, some_facts()), "needs a certificate"));
  EXPECT_TRUE(has(refusal({torus("a.json")}, {"", {"x"}, "", "2026-05-31"}), "needs a title"));
  EXPECT_TRUE(has(refusal({torus("a.json")}, {"x", {}, "", "2026-05-31"}), "needs an author"));
  for (const char* day : {"", "2026", "2026-5-31", "2026-06-31", "31.5.2026"})
    EXPECT_TRUE(has(refusal({torus("a.json")}, {"x", {"x"}, "", day}), "needs a day of publication")) << day;
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
