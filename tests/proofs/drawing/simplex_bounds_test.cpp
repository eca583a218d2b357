#include "proofs/drawing/simplex_bounds.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cfenv>

#include "proofs/drawing/drawing.hpp"
#include "support/error.hpp"
#include "tests/proofs/drawing/drawn_certificates.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

using test::drawn_certificates;

constexpr double slack = 1e-9;

/// How many of the measures, computed in doubles, are outside of their bounds.
std::size_t outside(const std::vector<double>& measured, const MeasureEnclosures& bounds) {
  std::size_t result = 0;
  for (std::size_t at = 0; at < measured.size(); ++at)
    result += measured[at] < bounds.lower.at(at) - slack || measured[at] > bounds.upper.at(at) + slack ? 1U : 0U;
  return result;
}

/// The measures of a drawing, and their bounds.
std::vector<std::pair<const std::vector<double>*, const MeasureEnclosures*>> pairs_of(const Drawing& drawing,
                                                                                      const SimplexBounds& bounds) {
  return {{&drawing.measures.protection, &bounds.protection},
          {&drawing.measures.thickness, &bounds.thickness},
          {&drawing.measures.circumradius, &bounds.circumradius}};
}

TEST(SimplexBounds, enclose_what_is_measured_in_another_way) {
  for (const char* name : {"flat-torus", "sphere-2", "projective-plane", "klein-bottle", "bolza-surface"}) {
    const CertificateSummary& certificate = drawn_certificates().at(name);
    const SimplexBounds bounds = simplex_bounds(certificate);
    const Drawing drawing = drawing_of(certificate, {});
    for (const auto& [measured, own] : pairs_of(drawing, bounds)) {
      ASSERT_EQ(measured->size(), own->lower.size());
      EXPECT_EQ(outside(*measured, *own), 0U) << name;
      for (std::size_t at = 0; at < own->lower.size(); ++at) {
        EXPECT_LT(own->lower[at], own->upper[at]) << name;
        EXPECT_LT(own->upper[at] - own->lower[at], slack) << name;
      }
    }
  }
}

/// The bounds of level 1 are of all simplices, so they follow from those of each.
TEST(SimplexBounds, imply_the_margins_of_level_1) {
  for (const char* name : {"sphere-2", "projective-plane", "klein-bottle", "bolza-surface"}) {
    const CertificateSummary& certificate = drawn_certificates().at(name);
    const SimplexBounds bounds = simplex_bounds(certificate);
    const double epsilon = approximate_double(certificate.parameter("sampling_radius"));
    const auto margin = [&](const char* key) { return approximate_double(certificate.margin("1", key).value()); };
    EXPECT_GE(std::ranges::min(bounds.protection.lower), margin("protection") / epsilon) << name;
    EXPECT_GE(std::ranges::min(bounds.thickness.lower), margin("thickness")) << name;
    EXPECT_LE(std::ranges::max(bounds.circumradius.upper), margin("circumradius") / epsilon) << name;
    // Twin: half a per cent more is too much of all of them.
    EXPECT_LT(std::ranges::min(bounds.thickness.lower), margin("thickness") * 1.005) << name;
    EXPECT_LT(std::ranges::min(bounds.protection.lower), margin("protection") / epsilon * 1.005) << name;
    EXPECT_GT(std::ranges::max(bounds.circumradius.upper), margin("circumradius") / epsilon / 1.005) << name;
  }
}

TEST(SimplexBounds, notice_an_element_that_is_another) {
  CertificateSummary certificate = drawn_certificates().at("bolza-surface");
  const auto moved = std::find_if(certificate.simplices.begin(), certificate.simplices.end(),
                                  [](const std::vector<std::uint32_t>& row) { return row[3] != 0; });
  ASSERT_NE(moved, certificate.simplices.end());
  (*moved)[3] = 0;
  EXPECT_THROW((void)simplex_bounds(certificate), InputError);
}

TEST(SimplexBounds, are_not_of_a_group_that_is_none) {
  CertificateSummary certificate = drawn_certificates().at("bolza-surface");
  const std::size_t at = certificate.manifold_text.find("\"56\",\"40\"");
  ASSERT_NE(at, std::string::npos);
  certificate.manifold_text.replace(at, 4, "\"57\"");
  EXPECT_THROW((void)simplex_bounds(certificate), Rejection);
}

TEST(SimplexBounds, notice_a_point_that_is_elsewhere) {
  CertificateSummary certificate = drawn_certificates().at("flat-torus");
  const Drawing drawing = drawing_of(certificate, {});
  certificate.points.at(0).at(0) = certificate.points.at(0).at(0) + Rational(1, 1000);
  const SimplexBounds bounds = simplex_bounds(certificate);
  EXPECT_GT(outside(drawing.measures.thickness, bounds.thickness), 0U);
  EXPECT_GT(outside(drawing.measures.circumradius, bounds.circumradius), 0U);
}

TEST(SimplexBounds, of_what_may_be_degenerate_say_nothing) {
  CertificateSummary certificate = drawn_certificates().at("flat-torus");
  const auto& row = certificate.simplices.at(0);
  // All corners of a simplex at one point, in the same cell.
  for (std::size_t corner = 1; corner < 3; ++corner) certificate.points.at(row[corner]) = certificate.points.at(row[0]);
  for (auto& shift : certificate.elements) shift.assign(shift.size(), 0);
  const SimplexBounds bounds = simplex_bounds(certificate);
  EXPECT_EQ(bounds.circumradius.lower.at(0), 0);
  EXPECT_EQ(bounds.circumradius.upper.at(0), std::numeric_limits<double>::infinity());
}

TEST(SimplexBounds, are_of_constant_curvature_only_and_leave_the_rounding_as_it_was) {
  EXPECT_THROW((void)simplex_bounds(drawn_certificates().at("submanifold")), InputError);
  CertificateSummary certificate = drawn_certificates().at("flat-torus");
  certificate.simplices.at(0).at(0) = 1000000;
  EXPECT_THROW((void)simplex_bounds(certificate), InputError);
  certificate.manifold_text = "{}";
  EXPECT_THROW((void)simplex_bounds(certificate), InputError);
  EXPECT_EQ(std::fegetround(), FE_TONEAREST);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
