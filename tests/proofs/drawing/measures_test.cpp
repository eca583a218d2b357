#include "proofs/drawing/measures.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "proofs/drawing/drawing.hpp"
#include "tests/proofs/drawing/drawn_certificates.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

double least_of(const std::vector<double>& values) { return *std::min_element(values.begin(), values.end()); }
double greatest_of(const std::vector<double>& values) { return *std::max_element(values.begin(), values.end()); }

constexpr double rounding = 1e-3;  ///< bounds have some ten binary digits

// The certificate's bounds come from intervals and rationals of the run, and are the worst over all simplices.
TEST(Measures, TheWorstAreTheBoundsOfLevel1) {
  for (const auto& [name, certificate] : test::drawn_certificates()) {
    const Drawing drawing = drawing_of(certificate, {});
    ASSERT_TRUE(drawing.bounds.protection && drawing.bounds.thickness && drawing.bounds.circumradius) << name;
    const double protection = least_of(drawing.measures.protection);
    EXPECT_GE(protection, *drawing.bounds.protection) << name;
    EXPECT_LE(protection, (1 + rounding) * *drawing.bounds.protection) << name;
    const double thickness = least_of(drawing.measures.thickness);
    EXPECT_GE(thickness, *drawing.bounds.thickness) << name;
    EXPECT_LE(thickness, (1 + rounding) * *drawing.bounds.thickness) << name;
    const double circumradius = greatest_of(drawing.measures.circumradius);
    EXPECT_LE(circumradius, *drawing.bounds.circumradius) << name;
    EXPECT_GE(circumradius, (1 - rounding) * *drawing.bounds.circumradius) << name;
  }
}

TEST(Measures, HingesAreDelaunayWhereLevel6SaysSo) {
  std::size_t bounded = 0;
  for (const auto& [name, certificate] : test::drawn_certificates()) {
    const Drawing drawing = drawing_of(certificate, {});
    if (!drawing.bounds.hinge) continue;
    ++bounded;
    EXPECT_GE(least_of(drawing.measures.hinge), *drawing.bounds.hinge) << name;
    EXPECT_LE(least_of(drawing.measures.hinge), (1 + rounding) * *drawing.bounds.hinge) << name;
  }
  EXPECT_GE(bounded, 2U);
}

TEST(Measures, OfATriangleAtTheBorderSeeAllPoints) {
  // The middle of the triangle 0 1 2 is (1, 3/4), its circumradius 5/4; label 3 at (-1, 2) is the nearest other.
  const CertificateSummary certificate = test::hexagon_certificate();
  const Drawing drawing = drawing_of(certificate, {});
  EXPECT_NEAR(drawing.measures.circumradius[0], 1.25 / 2, 1e-12);
  EXPECT_NEAR(drawing.measures.protection[0], (std::hypot(2, 1.25) - 1.25) / 2, 1e-12);
  EXPECT_TRUE(drawing.measures.hinge.empty());
}

TEST(Measures, APointThatIsMovedIsNoticed) {
  CertificateSummary certificate = test::torus_certificate();
  const double before = least_of(drawing_of(certificate, {}).measures.protection);
  certificate.points[5] = certificate.points[6];
  EXPECT_FALSE(least_of(drawing_of(certificate, {}).measures.protection) >= before);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
