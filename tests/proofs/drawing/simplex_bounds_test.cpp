#include "proofs/drawing/simplex_bounds.hpp"

#include <gtest/gtest.h>

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

TEST(SimplexBounds, enclose_what_is_measured_in_another_way) {
  const CertificateSummary& certificate = drawn_certificates().at("flat-torus");
  const SimplexBounds bounds = simplex_bounds(certificate);
  const Drawing drawing = drawing_of(certificate, {});
  for (const auto& [measured, own] : {std::pair{&drawing.measures.protection, &bounds.protection},
                                      std::pair{&drawing.measures.thickness, &bounds.thickness},
                                      std::pair{&drawing.measures.circumradius, &bounds.circumradius}}) {
    ASSERT_EQ(measured->size(), own->lower.size());
    EXPECT_EQ(outside(*measured, *own), 0U);
    for (std::size_t at = 0; at < own->lower.size(); ++at) {
      EXPECT_LT(own->lower[at], own->upper[at]);
      EXPECT_LT(own->upper[at] - own->lower[at], slack);
    }
  }
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

TEST(SimplexBounds, are_of_flat_tori_only_and_leave_the_rounding_as_it_was) {
  EXPECT_THROW((void)simplex_bounds(drawn_certificates().at("sphere-2")), InputError);
  CertificateSummary certificate = drawn_certificates().at("flat-torus");
  certificate.simplices.at(0).at(0) = 1000000;
  EXPECT_THROW((void)simplex_bounds(certificate), InputError);
  certificate.manifold_text = "{}";
  EXPECT_THROW((void)simplex_bounds(certificate), InputError);
  EXPECT_EQ(std::fegetround(), FE_TONEAREST);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
