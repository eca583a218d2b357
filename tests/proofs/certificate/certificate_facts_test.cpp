#include "proofs/certificate/certificate_facts.hpp"

#include <gtest/gtest.h>

#include <fstream>

#include "support/error.hpp"
#include "tests/proofs/drawing/drawn_certificates.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

TEST(CertificateFacts, ASealThatIsWrongIsRefused) {
  const test::TemporaryFolder folder;
  small_run().write(folder / "c.json");
  EXPECT_NO_THROW(require_seal(read_certificate(folder / "c.json")));
  std::string bytes = bytes_of(folder / "c.json");
  const std::size_t at = bytes.find("torus-2");
  ASSERT_NE(at, std::string::npos);
  bytes[at + 6] = '3';
  std::ofstream(folder / "d.json", std::ios::binary) << bytes;
  EXPECT_THROW(require_seal(read_certificate(folder / "d.json")), InputError);
}

TEST(CertificateFacts, TheOriginIsOneLineOfAscii) {
  CertificateSummary certificate = test::hexagon_certificate();
  certificate.manifold.name = "a\nb\xe2\x80\xae</svg>" + std::string(10000, 'x');
  const std::string text = origin_text(certificate, Verification::not_asked);
  EXPECT_LT(text.size(), 400U);
  for (const char byte : text) EXPECT_TRUE(byte >= ' ' && byte < 0x7f);
  EXPECT_NE(text.find("(not verified)"), std::string::npos);
  EXPECT_EQ(origin_text(certificate, Verification::verified).find("not verified"), std::string::npos);
  EXPECT_NE(origin_text(certificate, Verification::rejected).find("not verified"), std::string::npos);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
