#include "proofs/certificate/picture.hpp"

#include <gtest/gtest.h>

#include "support/error.hpp"
#include "tests/proofs/certificate/small_run.hpp"
#include "tests/support/temporary_folder.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

std::size_t occurrences(const std::string& text, const std::string& what) {
  std::size_t count = 0;
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1)) ++count;
  return count;
}

CertificateSummary small_certificate() {
  const test::TemporaryFolder folder;
  small_run().write(folder / "c.json");
  return read_certificate(folder / "c.json");
}

TEST(Picture, DrawsEveryTriangleOnceAndTheUnitCell) {
  const std::string svg = picture_svg(small_certificate());
  EXPECT_TRUE(svg.starts_with("<svg "));
  EXPECT_TRUE(svg.ends_with("</svg>\n"));
  EXPECT_EQ(occurrences(svg, "fill=\"rgb("), small_run().run.complex.simplices().size());
  EXPECT_EQ(occurrences(svg, "fill=\"none\""), 1U);
  EXPECT_EQ(occurrences(svg, "nan"), 0U);
}

TEST(Picture, IsOfDimensionTwoOnly) {
  CertificateSummary certificate = small_certificate();
  certificate.manifold.dimension = Dimension(3);
  EXPECT_THROW((void)picture_svg(certificate), InputError);
}

TEST(Picture, IsOfFlatFamiliesOnly) {
  CertificateSummary certificate = small_certificate();
  EXPECT_EQ(certificate.family, "flat-torus");
  certificate.family = "spherical";
  EXPECT_THROW((void)picture_svg(certificate), InputError);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
