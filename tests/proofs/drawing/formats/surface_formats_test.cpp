#include "proofs/drawing/formats/surface_formats.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

#include "tests/proofs/drawing/drawn_certificates.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

std::string text_of(const char* name, const Drawing& drawing) {
  const CertificateSummary certificate = test::hexagon_certificate();
  ExportContent content{certificate};
  content.drawing = &drawing;
  return export_format(name).text(content);
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

TEST(SurfaceFormats, AreAsTheirReadersWantThem) {
  const Drawing drawing = drawing_of(test::hexagon_certificate(), {});
  const auto off = lines_of(text_of("off", drawing));
  ASSERT_EQ(off.size(), 3U + 7 + 6);
  EXPECT_EQ(off[0], "OFF");
  EXPECT_TRUE(off[1].starts_with("# delcert "));
  EXPECT_NE(off[1].find("not verified"), std::string::npos);
  EXPECT_EQ(off[2], "7 6 0");
  EXPECT_EQ(off[4], "2 0 0");
  EXPECT_EQ(off[10], "3 0 1 2");
  const auto obj = lines_of(text_of("obj", drawing));
  ASSERT_EQ(obj.size(), 1U + 7 + 6);
  EXPECT_EQ(obj[2], "v 2 0 0");
  EXPECT_EQ(obj[8], "f 1 2 3");
  const auto ply = lines_of(text_of("ply", drawing));
  EXPECT_EQ(ply[0], "ply");
  EXPECT_NE(std::find(ply.begin(), ply.end(), "property double protection"), ply.end());
  EXPECT_EQ(ply[ply.size() - 6].substr(0, 8), "3 0 1 2 ");
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
