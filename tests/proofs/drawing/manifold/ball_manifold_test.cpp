#include "proofs/drawing/manifold/ball_manifold.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/proofs/drawing/drawn_certificates.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

TEST(BallManifold, ChartsShowWhatIsWithinNineSamplingRadii) {
  CertificateSummary certificate = test::hexagon_certificate();
  EXPECT_TRUE(BallManifold(certificate).in_chart(1, 4, 0).has_value());
  // The points 1 and 4 are 4 apart.
  certificate.parameters.at(1).second = "4/9";
  EXPECT_FALSE(BallManifold(certificate).in_chart(1, 4, 0).has_value());
  EXPECT_TRUE(BallManifold(certificate).in_chart(0, 4, 0).has_value());
}

TEST(BallManifold, ItsDomainIsItsBoundary) {
  BallManifold manifold(test::hexagon_certificate());
  const auto wires = manifold.domain();
  ASSERT_FALSE(wires.empty());
  for (const auto& [from, to] : wires) EXPECT_NEAR(std::hypot(from[1], from[2]), 8, 1e-12);
  EXPECT_FALSE(manifold.is_closed());
  EXPECT_EQ(manifold.sheet_text(0), "");
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
