#include "proofs/drawing/layout.hpp"

#include <gtest/gtest.h>

#include <set>

#include "proofs/drawing/facet_table.hpp"
#include "tests/proofs/drawing/drawn_certificates.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

std::size_t open_facets(const Drawing& drawing) {
  const FacetTable facets(drawing.simplices, drawing.dimension + 1);
  std::size_t open = 0;
  for (std::size_t at = 0; at < facets.sides().size(); ++at) {
    if (facets.is_same_as_before(at)) {
      --open;
    } else {
      ++open;
    }
  }
  return open;
}

Drawing drawn(const CertificateSummary& certificate, DrawingCopies copies) {
  DrawingOptions options;
  options.copies = copies;
  return drawing_of(certificate, options);
}

TEST(Layout, TheQuotientIsTheClosedComplex) {
  for (const auto& [name, certificate] : test::drawn_certificates()) {
    const Drawing drawing = drawn(certificate, DrawingCopies::quotient);
    EXPECT_EQ(drawing.vertex_count(), certificate.points.size()) << name;
    EXPECT_EQ(drawing.simplex_count(), certificate.simplices.size()) << name;
    EXPECT_EQ(open_facets(drawing), 0U) << name;
    EXPECT_TRUE(drawing.matching_faces.empty()) << name;
    EXPECT_EQ(drawing.is_oriented, name != "klein-bottle" && name != "projective-plane") << name;
  }
}

TEST(Layout, TheFacesOfACellMatchInPairs) {
  for (const auto& [name, certificate] : test::drawn_certificates()) {
    const Drawing drawing = drawn(certificate, DrawingCopies::cell);
    EXPECT_EQ(drawing.simplex_count(), certificate.simplices.size()) << name;
    EXPECT_EQ(open_facets(drawing), 2 * drawing.matching_faces.size()) << name;
    const bool is_cut = name != "sphere-2" && name != "submanifold";
    EXPECT_EQ(!drawing.matching_faces.empty(), is_cut) << name;
    EXPECT_TRUE(drawing.is_oriented) << name;
    for (const MatchingFaces& pair : drawing.matching_faces) {
      EXPECT_NE(pair.first, pair.second) << name;
      for (std::size_t k = 0; k < 2; ++k) EXPECT_EQ(drawing.labels[pair.first[k]], drawing.labels[pair.second[k]]);
      EXPECT_FALSE(pair.step.empty()) << name;
    }
  }
}

TEST(Layout, OppositeFacesOfATorusDifferByTheStep) {
  const Drawing drawing = drawn(test::torus_certificate(), DrawingCopies::cell);
  for (const MatchingFaces& pair : drawing.matching_faces) {
    const double x = drawing.coordinates[2 * pair.second[0]] - drawing.coordinates[2 * pair.first[0]];
    const double y = drawing.coordinates[2 * pair.second[0] + 1] - drawing.coordinates[2 * pair.first[0] + 1];
    EXPECT_EQ(pair.step, std::to_string(std::lround(x)) + " " + std::to_string(std::lround(y)));
    EXPECT_NEAR(x, std::round(x), 1e-12);
  }
}

TEST(Layout, StarsAreWholeWhereTheCellIsGluedToItsNeighbours) {
  for (const auto& [name, certificate] : test::drawn_certificates()) {
    if (name == "atlas") continue;  // a chart shows what it shows
    const Drawing cell = drawn(certificate, DrawingCopies::cell);
    const Drawing glued = drawn(certificate, DrawingCopies::glued);
    EXPECT_GE(glued.simplex_count(), cell.simplex_count()) << name;
    // Degrees of labels, and the most simplices at any one of their copies.
    std::vector<std::size_t> degree(certificate.points.size());
    for (const auto& row : certificate.simplices) {
      for (std::size_t k = 0; k < 3; ++k) ++degree[row[k]];
    }
    std::vector<std::size_t> at_copy(glued.vertex_count());
    for (const std::uint32_t vertex : glued.simplices) ++at_copy[vertex];
    std::vector<std::size_t> most(degree.size());
    for (std::size_t copy = 0; copy < at_copy.size(); ++copy)
      most[glued.labels[copy]] = std::max(most[glued.labels[copy]], at_copy[copy]);
    EXPECT_EQ(most, degree) << name;
  }
}

TEST(Layout, TwoLabelsExchangedInOneTriangleOpenTheComplex) {
  CertificateSummary certificate = test::torus_certificate();
  ASSERT_LT(certificate.simplices[7][2], certificate.points.size() - 1);
  certificate.simplices[7][2] += 1;
  EXPECT_NE(open_facets(drawn(certificate, DrawingCopies::quotient)), 0U);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
