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
