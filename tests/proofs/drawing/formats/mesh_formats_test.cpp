#include "proofs/drawing/formats/mesh_formats.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/proofs/drawing/drawn_certificates.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

std::string text_of(const CertificateSummary& certificate, const char* name) {
  const Drawing drawing = drawing_of(certificate, {});
  ExportContent content{certificate};
  content.drawing = &drawing;
  return export_format(name).text(content);
}

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

// What programs read of them is in tests/receivers.
TEST(MeshFormats, SayThatTheyAreApproximateAndWhereTheyComeFrom) {
  const CertificateSummary certificate = test::torus_certificate();
  for (const char* name : {"vtu", "medit", "gmsh", "csv"}) {
    const std::string text = text_of(certificate, name);
    EXPECT_TRUE(contains(text, "approximate")) << name;
    EXPECT_TRUE(contains(text, certificate.seal)) << name;
    EXPECT_TRUE(contains(text, "not verified")) << name;
    EXPECT_TRUE(contains(text, "protection") != (std::string_view(name) == "medit")) << name;
  }
}

TEST(MeshFormats, ACommentOfXmlHasNoTwoHyphens) {
  CertificateSummary certificate = test::hexagon_certificate();
  certificate.manifold.name = "a--->b";
  const std::string text = text_of(certificate, "vtu");
  const std::size_t begin = text.find("<!--") + 4;
  const std::size_t end = text.find("-->", begin);
  EXPECT_EQ(text.substr(begin, end - begin).find("--"), std::string::npos);
  EXPECT_TRUE(contains(text.substr(end), "<VTKFile"));
  EXPECT_TRUE(contains(text.substr(begin, end - begin), "sha256"));
}

TEST(MeshFormats, HaveEverySimplexOnce) {
  const std::string medit = text_of(test::hexagon_certificate(), "medit");
  EXPECT_TRUE(contains(medit, "Vertices\n7\n0 0 0 0\n2 0 0 1\n"));
  EXPECT_TRUE(contains(medit, "Triangles\n6\n1 2 3 0\n"));
  const std::string gmsh = text_of(test::hexagon_certificate(), "gmsh");
  EXPECT_TRUE(contains(gmsh, "$Elements\n6\n1 2 2 1 1 1 2 3\n"));
  const std::string csv = text_of(test::hexagon_certificate(), "csv");
  EXPECT_TRUE(contains(
      csv, "position,label_0,label_1,label_2,lift_0,lift_1,lift_2,protection,thickness,circumradius\n0,0,1,2,,,,"));
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
