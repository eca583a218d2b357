#include "proofs/certificate/reader.hpp"

#include <gtest/gtest.h>

#include "support/error.hpp"
#include "tests/proofs/certificate/small_run.hpp"
#include "tests/support/temporary_folder.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

TEST(Reader, ReadsBackWhatWasWrittenBitForBit) {
  const test::TemporaryFolder folder;
  for (const char* name : {"c.json", "c.json.zst"}) {
    small_run().write(folder / name);
    const CertificateSummary read = read_certificate(folder / name);
    EXPECT_EQ(read.manifold.name, "torus-2");
    EXPECT_EQ(read.manifold.dimension, Dimension(2));
    ASSERT_EQ(read.points.size(), small_run().atlas.size());
    for (std::uint32_t index = 0; index < read.points.size(); ++index) {
      const auto& exact = small_run().run.points.exact(Label(index));
      EXPECT_TRUE(std::equal(read.points[index].begin(), read.points[index].end(), exact.begin(), exact.end()));
    }
    EXPECT_EQ(read.levels.size(), 8U);
    const std::pair<std::string, std::string> homology("homology", "Z, Z^2, Z");
    EXPECT_EQ(read.levels[2].second.back(), homology);
    EXPECT_EQ(read.net_simplices, small_run().density.simplices.size());
    const std::vector<std::vector<Rational>> net = read.net();
    ASSERT_EQ(net.size(), small_run().atlas.size());
    for (std::uint32_t index = 0; index < net.size(); ++index) {
      const auto& exact = small_run().atlas.net().exact(Label(index));
      EXPECT_TRUE(std::equal(net[index].begin(), net[index].end(), exact.begin(), exact.end()));
    }
    EXPECT_EQ(read.seal.size(), 64U);
    EXPECT_EQ(read.simplices.size(), small_run().run.complex.simplices().size());
    for (const auto& simplex : read.simplices) {
      ASSERT_EQ(simplex.size(), 5U);
      EXPECT_LE(std::max(simplex[3], simplex[4]), read.elements.size());
    }
  }
}

TEST(Reader, SaysOfANetThatIsNoListOfExactNumbersWhenItIsAskedForThat) {
  CertificateSummary certificate;
  for (const char* text : {"", "[[1]]", "[[\"0.5\"]]", "[[\"1\"]", "[\"1\"]"}) {
    certificate.net_text = text;
    EXPECT_THROW((void)certificate.net(), InputError) << text;
  }
  certificate.net_text = "[[\"1/2\"]]";
  EXPECT_EQ(certificate.net(), (std::vector<std::vector<Rational>>{{Rational(1) / Rational(2)}}));
}

TEST(Reader, SaysWhichFileCannotBeRead) {
  const test::TemporaryFolder folder;
  const auto message = [](const std::filesystem::path& path) -> std::string {
    try {
      (void)read_certificate(path);
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_NE(message(folder / "none.json").find("none.json: cannot be opened"), std::string::npos);

  small_run().write(folder / "c.json.zst");
  const std::string bytes = bytes_of(folder / "c.json.zst");
  std::ofstream(folder / "cut.zst", std::ios::binary) << bytes.substr(0, bytes.size() / 2);
  EXPECT_NE(message(folder / "cut.zst").find("cut.zst: zstd: the file ends too early"), std::string::npos);

  small_run().write(folder / "c.json");
  std::ofstream(folder / "cut.json", std::ios::binary) << bytes_of(folder / "c.json").substr(0, 5000);
  EXPECT_NE(message(folder / "cut.json").find("cut.json: "), std::string::npos);
  std::ofstream(folder / "other.json") << "{\"format\":1}\n";
  EXPECT_NE(message(folder / "other.json").find("software"), std::string::npos);
  std::ofstream(folder / "old.json") << "{\"format\":\"delcert-certificate\",\"version\":1}\n";
  EXPECT_NE(message(folder / "old.json").find("old.json: version 1 is read by delcert 0.1"), std::string::npos);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
