#include "proofs/drawing/figure/figure_pdf.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <sstream>
#include <vector>

#include "proofs/drawing/figure/figure_page.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

Figure square() {
  Figure figure;
  figure.paths.push_back({{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}}, true, Figure::Colour{255, 0, 51}});
  figure.paths.push_back({{{{1, 0}, {0, 1}}}, false, std::nullopt, {}, 1, true});
  figure.circles.push_back({{0.5, 0.5}, 0.25, {0, 255, 0}});
  figure.dots.push_back({{1, 0}, 3, {0, 0, 255}});
  figure.names.push_back({{0, 1}, "a (\\) \u211d", {0, 0, 0}});
  figure.scale = Figure::Scale{0.25, "0.25"};
  figure.description = "\u211d \U0001F600";
  return figure;
}

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

/// Whether each entry of the table of places is that of the object with its number, and `startxref` that of the table.
bool has_right_places(const std::string& pdf) {
  const std::size_t table = pdf.rfind("\nxref\n") + 1;
  if (pdf.substr(pdf.rfind("startxref\n") + 10) != std::to_string(table) + "\n%%EOF\n") return false;
  std::istringstream in(pdf.substr(table));
  std::string word;
  std::size_t first = 1;
  std::size_t count = 0;
  in >> word >> first >> count;
  std::getline(in, word);
  for (std::size_t at = 0; at < count; ++at) {
    std::string line;
    std::getline(in, line);
    if (line.size() != 19) return false;
    const std::string head = std::to_string(at) + " 0 obj\n";
    if (at > 0 && pdf.compare(std::stoul(line), head.size(), head) != 0) return false;
  }
  return first == 0 && count > 1;
}

/// What is between `stream` and `endstream`, if its length is what the object says.
std::string content(const std::string& pdf) {
  const std::size_t begin = pdf.find("stream\n") + 7;
  const std::string text = pdf.substr(begin, pdf.find("endstream") - begin);
  EXPECT_TRUE(has(pdf, "/Length " + std::to_string(text.size()) + " >>"));
  return text;
}

TEST(FigurePdf, knows_where_its_objects_are) {
  const std::string pdf = pdf_of(square());
  EXPECT_TRUE(has_right_places(pdf)) << pdf;
  EXPECT_EQ(pdf.rfind("%PDF-1.4\n", 0), 0U);
  std::string moved = pdf;
  moved.insert(pdf.find("3 0 obj"), "\n");
  EXPECT_FALSE(has_right_places(moved));
}

TEST(FigurePdf, is_a_page_of_twelve_centimetres) {
  const std::string pdf = pdf_of(square());
  EXPECT_TRUE(has(pdf, "/MediaBox [0 0 340.16 360.94]")) << pdf;
  EXPECT_TRUE(has(content(pdf), "0.472441 0 0 0.472441 0 0 cm\n")) << pdf;
  EXPECT_NEAR(720 * 0.472441 / 72 * 2.54, figure_centimetres, 1e-4);
}

TEST(FigurePdf, has_paths_with_the_ordinate_upwards) {
  const std::string text = content(pdf_of(square()));
  EXPECT_TRUE(has(text, "1.0000 0.0000 0.2000 rg\n")) << text;
  EXPECT_TRUE(has(text, "12.00 56.00 m\n708.00 56.00 l\n708.00 752.00 l\n12.00 752.00 l\nh\nB\n")) << text;
  EXPECT_TRUE(has(text, "[6 4] 0 d\n708.00 56.00 m\n12.00 752.00 l\nS\n[] 0 d\n")) << text;
  EXPECT_TRUE(has(text, "3 w\n12.00 28.00 m\n186.00 28.00 l\nS\n")) << text;
}

TEST(FigurePdf, has_circles_that_are_round) {
  const std::string text = content(pdf_of(square()));
  std::istringstream in(text.substr(text.find("0.0000 1.0000 0.0000 RG")));
  std::string line;
  for (int skipped = 0; skipped < 3; ++skipped) std::getline(in, line);
  ASSERT_EQ(line, "534.00 404.00 m");
  std::array<double, 2> from{534, 404};
  for (int quarter = 0; quarter < 4; ++quarter) {
    std::array<double, 6> own{};
    for (double& number : own) in >> number;
    in >> line;
    ASSERT_EQ(line, "c");
    for (double t = 0.125; t <= 1; t += 0.125) {
      const auto at = [&](std::size_t axis) {
        const double s = 1 - t;
        return s * s * s * from[axis] + 3 * s * s * t * own[axis] + 3 * s * t * t * own[2 + axis] +
               t * t * t * own[4 + axis];
      };
      EXPECT_NEAR(std::hypot(at(0) - 360, at(1) - 404), 174, 0.06);
    }
    from = {own[4], own[5]};
  }
  EXPECT_NEAR(from[0], 534, 1e-9);
  in >> line;
  EXPECT_EQ(line, "h");
}

TEST(FigurePdf, has_names_in_ascii_and_a_title_in_unicode) {
  const std::string pdf = pdf_of(square());
  EXPECT_TRUE(has(content(pdf), "18.00 758.00 Td (a \\(\\\\\\) ?) Tj ET\n")) << pdf;
  EXPECT_TRUE(has(content(pdf), "194.00 22.00 Td (0.25) Tj ET\n")) << pdf;
  EXPECT_TRUE(has(pdf, "/Title <FEFF211D0020D83DDE00>")) << pdf;
}

TEST(FigurePdf, of_nothing_is_a_page) {
  Figure empty;
  empty.paths.emplace_back();
  const std::string pdf = pdf_of(empty);
  EXPECT_TRUE(has_right_places(pdf));
  EXPECT_FALSE(has(content(pdf), "S\n"));
  EXPECT_FALSE(has(pdf, "nan") || has(pdf, "inf"));
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
