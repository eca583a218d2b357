#include "proofs/drawing/figure/figure.hpp"

#include <gtest/gtest.h>

namespace delcert {
namespace DELCERT_THIS_FILE {

Figure square() {
  Figure figure;
  figure.paths.push_back({{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}}, true, Figure::Colour{1, 2, 3}});
  figure.paths.push_back({{{{0, 0}, {1, 1}}}, false, std::nullopt});
  figure.paths.push_back({{{{1, 0}, {0, 1}}}, false, std::nullopt, {}, 1, true});
  figure.dots.push_back({{1, 0}, 3, {4, 5, 6}});
  figure.names.push_back({{0, 1}, "a_0 & b", {7, 8, 9}});
  figure.circles.push_back({{0.5, 0.5}, 0.25, {9, 8, 7}});
  figure.scale = Figure::Scale{0.2, "0.2"};
  figure.description = "a <square> of 100%";
  return figure;
}

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

TEST(Figure, is_svg_with_the_ordinate_upwards) {
  const std::string svg = svg_of(square());
  EXPECT_TRUE(has(svg, "viewBox=\"0 0 720 764\"")) << svg;
  EXPECT_TRUE(has(svg, "<title>a &lt;square&gt; of 100%</title>")) << svg;
  EXPECT_TRUE(has(svg, "d=\"M12.00 708.00L708.00 708.00L708.00 12.00L12.00 12.00Z\" fill=\"rgb(1 2 3)\"")) << svg;
  EXPECT_TRUE(has(svg, "d=\"M12.00 708.00L708.00 12.00\" fill=\"none\"")) << svg;
  EXPECT_TRUE(has(svg, "<circle cx=\"360.00\" cy=\"360.00\" r=\"174.00\"")) << svg;
  EXPECT_TRUE(has(svg, ">0.2</text>")) << svg;
  EXPECT_TRUE(has(
      svg,
      "d=\"M708.00 708.00L12.00 12.00\" fill=\"none\" stroke=\"rgb(0 0 0)\" stroke-width=\"1.00\" stroke-dasharray"));
  EXPECT_TRUE(has(svg, "<circle cx=\"708.00\" cy=\"708.00\" r=\"3.00\" fill=\"rgb(4 5 6)\"/>")) << svg;
  EXPECT_TRUE(has(svg, "<text x=\"18.00\" y=\"6.00\"")) << svg;
  EXPECT_TRUE(has(svg, "fill=\"rgb(7 8 9)\">a_0 &amp; b</text>")) << svg;
}

TEST(Figure, is_a_tikzpicture_of_twelve_centimetres) {
  const std::string tikz = tikz_of(square());
  EXPECT_EQ(tikz.rfind("% a <square> of 100\\%\n\\begin{tikzpicture}[x=0.016667cm,y=-0.016667cm,", 0), 0U) << tikz;
  EXPECT_TRUE(has(tikz, " (12.00,708.00)--(708.00,708.00)--(708.00,12.00)--(12.00,12.00)--cycle;")) << tikz;
  EXPECT_TRUE(has(tikz, "fill={rgb,255:red,1;green,2;blue,3}")) << tikz;
  EXPECT_TRUE(has(tikz, "circle[radius=174.00]")) << tikz;
  EXPECT_TRUE(has(tikz, ",dashed] (708.00,708.00)--(12.00,12.00);")) << tikz;
  EXPECT_TRUE(has(tikz, "\\path[fill={rgb,255:red,4;green,5;blue,6}] (708.00,708.00) circle[radius=3.00];")) << tikz;
  EXPECT_TRUE(has(tikz, "text={rgb,255:red,7;green,8;blue,9}] at (12.00,12.00) {a\\_0 \\& b};")) << tikz;
}

TEST(Figure, without_anything_in_it_has_no_nan) {
  EXPECT_FALSE(has(svg_of(Figure{}), "nan"));
  EXPECT_FALSE(has(svg_of(Figure{}), "inf"));
  EXPECT_FALSE(has(svg_of(Figure{}), "dash"));
}

TEST(Figure, has_scales_of_round_lengths) {
  EXPECT_EQ(round_scale(0.3).text, "0.2");
  EXPECT_EQ(round_scale(0.07).text, "0.05");
  EXPECT_EQ(round_scale(1.9).text, "1");
  EXPECT_EQ(round_scale(30).text, "20");
  EXPECT_EQ(round_scale(1).text, "1");
  EXPECT_DOUBLE_EQ(round_scale(0.0123).length, 0.01);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
