#include "proofs/drawing/torus_bounds.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "tests/proofs/drawing/drawn_certificates.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

using test::drawn_certificates;

TEST(TorusBounds, follow_a_point_that_is_elsewhere) {
  CertificateSummary certificate = drawn_certificates().at("flat-torus");
  const SimplexBounds before = torus_bounds(certificate);
  certificate.points.at(0).at(0) = certificate.points.at(0).at(0) + Rational(1, 1000);
  const SimplexBounds after = torus_bounds(certificate);
  std::size_t apart = 0;
  for (std::size_t at = 0; at < before.thickness.lower.size(); ++at) {
    const bool has_moved = std::find(certificate.simplices[at].begin(), certificate.simplices[at].begin() + 3, 0U) !=
                           certificate.simplices[at].begin() + 3;
    const bool is_apart = after.thickness.upper[at] < before.thickness.lower[at] ||
                          before.thickness.upper[at] < after.thickness.lower[at];
    EXPECT_LE(is_apart, has_moved);
    apart += is_apart ? 1U : 0U;
  }
  EXPECT_GT(apart, 2U);
}

TEST(TorusBounds, of_what_may_be_degenerate_say_nothing) {
  CertificateSummary certificate = drawn_certificates().at("flat-torus");
  const auto& row = certificate.simplices.at(0);
  // All corners of a simplex at one point, in the same cell.
  for (std::size_t corner = 1; corner < 3; ++corner) certificate.points.at(row[corner]) = certificate.points.at(row[0]);
  for (auto& shift : certificate.elements) shift.assign(shift.size(), 0);
  const SimplexBounds bounds = torus_bounds(certificate);
  EXPECT_EQ(bounds.circumradius.lower.at(0), 0);
  EXPECT_EQ(bounds.circumradius.upper.at(0), std::numeric_limits<double>::infinity());
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
