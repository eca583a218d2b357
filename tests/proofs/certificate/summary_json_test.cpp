#include "proofs/certificate/summary_json.hpp"

#include <gtest/gtest.h>

#include "tests/proofs/certificate/small_run.hpp"
#include "tests/support/temporary_folder.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

TEST(SummaryJson, HasWhatTheCertificateSays) {
  const test::TemporaryFolder folder;
  small_run().write(folder / "c.json");
  const CertificateSummary certificate = read_certificate(folder / "c.json");
  const nlohmann::ordered_json json = summary_json(certificate);
  EXPECT_EQ(json.at("manifold"), "torus-2");
  EXPECT_EQ(json.at("points"), certificate.points.size());
  EXPECT_EQ(json.at("levels_claimed").at("2").at("homology"), "Z, Z^2, Z");
  EXPECT_EQ(json.at("sha256"), certificate.seal);
  EXPECT_EQ(json.at("parameters").at("seed"), "0");
}

TEST(SummaryJson, IsAsciiWhateverTheName) {
  CertificateSummary certificate;
  certificate.manifold.name =
      "a\xe2\x80\xae"
      "b\x1b[2J\xff";
  const std::string text = ascii_text(summary_json(certificate), 2);
  EXPECT_NE(text.find("a\\u202eb\\u001b[2J\\ufffd"), std::string::npos);
  for (const char byte : text) EXPECT_TRUE(byte == '\n' || (byte >= ' ' && byte < 0x7f));
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
