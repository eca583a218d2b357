#include "proofs/drawing/figure/picture.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <set>

#include "proofs/drawing/formats/cell_data.hpp"
#include "support/error.hpp"
#include "tests/proofs/drawing/drawn_certificates.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

std::size_t occurrences(const std::string& text, const std::string& what) {
  std::size_t count = 0;
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1)) ++count;
  return count;
}

TEST(Picture, DrawsEveryTriangleOnceAndTheFundamentalDomain) {
  for (const char* name : {"flat-torus", "klein-bottle", "bolza-surface", "metric-field", "atlas"}) {
    const Drawing drawing = drawing_of(test::drawn_certificates().at(name), {});
    const std::string svg = picture_svg(drawing);
    EXPECT_TRUE(svg.starts_with("<svg "));
    EXPECT_TRUE(svg.ends_with("</svg>\n"));
    EXPECT_EQ(occurrences(svg, "fill=\"rgb("), drawing.simplex_count()) << name;
    EXPECT_EQ(occurrences(svg, "fill=\"none\""), 1U) << name;
    EXPECT_EQ(occurrences(svg, "nan"), 0U);
  }
}

TEST(Picture, OfASurfaceInSpaceHasWhatIsSeen) {
  for (const char* name : {"sphere-2", "submanifold"}) {
    const Drawing drawing = drawing_of(test::drawn_certificates().at(name), {});
    const std::size_t seen = occurrences(picture_svg(drawing), "fill=\"rgb(");
    EXPECT_GT(seen, drawing.simplex_count() / 3) << name;
    EXPECT_LT(seen, 2 * drawing.simplex_count() / 3) << name;
  }
}

TEST(Picture, MarksTheWorstStar) {
  for (const char* name : {"flat-torus", "bolza-surface", "metric-field", "atlas"}) {
    const Drawing drawing = drawing_of(test::drawn_certificates().at(name), {});
    const auto worst = worst_simplex(drawing);
    ASSERT_TRUE(worst) << name;
    const auto& protection = drawing.measures.protection;
    for (const double other : protection) EXPECT_FALSE(other < protection[*worst]) << name;
    const Figure plain = picture_of(drawing, {});
    const Figure marked = picture_of(drawing, {true, false});
    ASSERT_EQ(marked.paths.size(), plain.paths.size() + 2) << name;
    EXPECT_GE(marked.paths.back().lines.size(), 3U) << name;
    EXPECT_EQ(plain.description.find("star"), std::string::npos);
    EXPECT_NE(marked.description.find("is marked"), std::string::npos);
  }
}

TEST(Picture, HasAScaleWhereLengthsAreTheSameEverywhere) {
  for (const auto& [name, has_scale] : std::map<std::string, bool>{{"flat-torus", true},
                                                                   {"sphere-2", true},
                                                                   {"submanifold", true},
                                                                   {"bolza-surface", false},
                                                                   {"metric-field", false},
                                                                   {"atlas", false}}) {
    const Figure figure = picture_of(drawing_of(test::drawn_certificates().at(name), {}), {false, true});
    EXPECT_EQ(figure.scale.has_value(), has_scale) << name;
  }
  EXPECT_FALSE(picture_of(drawing_of(test::torus_certificate(), {}), {}).scale);
}

TEST(Picture, KnowsNoWorstOfWhatWasNotMeasured) {
  Drawing drawing = drawing_of(test::torus_certificate(), {});
  const double nan = std::nan("");
  for (double& x : drawing.measures.protection) x = nan;
  EXPECT_TRUE(worst_simplex(drawing));
  for (double& x : drawing.measures.thickness) x = nan;
  EXPECT_FALSE(worst_simplex(drawing));
  EXPECT_EQ(picture_of(drawing, {true, false}).paths.size(), picture_of(drawing, {}).paths.size());
}

TEST(Picture, IsShadedByTheMeasureThatIsAskedFor) {
  const Drawing drawing = drawing_of(test::torus_certificate(), {});
  std::set<std::string> pictures;
  for (const NamedMeasure& one : named_measures(drawing)) {
    PictureOptions options;
    options.measure = one.name;
    const Figure figure = picture_of(drawing, options);
    EXPECT_NE(figure.description.find("shaded by " + options.measure), std::string::npos);
    EXPECT_TRUE(pictures.insert(svg_of(figure)).second) << options.measure;
  }
  EXPECT_GE(pictures.size(), 3U);
  EXPECT_EQ(pictures.count(picture_svg(drawing)), 1U);
  PictureOptions misspelt;
  misspelt.measure = "protecton";
  EXPECT_THROW((void)picture_of(drawing, misspelt), InputError);
}

/// A trefoil of chords, drawn from above.
Drawing trefoil(std::size_t count) {
  Drawing drawing;
  drawing.geometry = "space";
  drawing.dimension = 1;
  drawing.ambient_dimension = 3;
  for (std::uint32_t at = 0; at < count; ++at) {
    const double t = 2 * 3.14159265358979 * at / static_cast<double>(count);
    for (const double x : {std::sin(t) + 2 * std::sin(2 * t), std::cos(t) - 2 * std::cos(2 * t), -std::sin(3 * t)})
      drawing.coordinates.push_back(x);
    drawing.labels.push_back(at);
    for (const std::uint32_t vertex : {at, static_cast<std::uint32_t>((at + 1) % count)})
      drawing.simplices.push_back(vertex);
    drawing.positions.push_back(at);
  }
  drawing.is_oriented = true;
  drawing.measures.thickness.assign(count, 1);
  drawing.measures.protection.assign(count, 0.5);
  drawing.measures.protection[7] = 0.25;
  return drawing;
}

TEST(Picture, OfACurveInSpaceHasGapsWhereItPassesBehind) {
  const Figure figure = picture_of(trefoil(90), {true, true});
  ASSERT_EQ(figure.paths.size(), 2 * 90U + 2);
  EXPECT_EQ(figure.dots.size(), 90U);
  ASSERT_TRUE(figure.scale);
  EXPECT_NE(figure.description.find("90 edges; the star of label 7 is marked"), std::string::npos)
      << figure.description;
  // Each edge lies on a gap of its own, and above all edges that are farther from the eye.
  for (std::size_t at = 0; at < 180; at += 2) {
    EXPECT_EQ(figure.paths[at].lines, figure.paths[at + 1].lines);
    EXPECT_GT(figure.paths[at].width, 3 * figure.paths[at + 1].width);
    EXPECT_FALSE(figure.paths[at].is_closed);
  }
  EXPECT_EQ(figure.paths.back().lines.size(), 2U) << "the two edges at label 7";
}

TEST(Picture, OfACurveInThePlaneHasNoGaps) {
  Drawing drawing = trefoil(12);
  drawing.ambient_dimension = 2;
  for (std::size_t axis = drawing.coordinates.size(); axis-- > 0;) {
    if (axis % 3 == 2) drawing.coordinates.erase(drawing.coordinates.begin() + static_cast<std::ptrdiff_t>(axis));
  }
  const Figure figure = picture_of(drawing, {});
  EXPECT_EQ(figure.paths.size(), 12U);
  EXPECT_EQ(figure.dots.size(), 12U);
  EXPECT_EQ(figure.description, "12 edges");
}

TEST(Picture, IsOfDimensionsOneAndTwoOnly) {
  Drawing drawing = drawing_of(test::torus_certificate(), {});
  drawing.dimension = 3;
  EXPECT_THROW((void)picture_svg(drawing), InputError);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
