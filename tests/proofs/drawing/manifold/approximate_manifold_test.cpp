#include "proofs/drawing/manifold/approximate_manifold.hpp"

#include <gtest/gtest.h>

#include "support/error.hpp"
#include "tests/proofs/drawing/drawn_certificates.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

TEST(ApproximateManifold, IsThereForEachFamily) {
  for (const auto& [name, certificate] : test::drawn_certificates()) {
    const auto manifold = approximate_manifold(certificate);
    EXPECT_EQ(manifold->dimension(), 2U) << name;
    EXPECT_FALSE(manifold->models().empty()) << name;
    EXPECT_NEAR(manifold->unit(0), approximate_double(certificate.parameter("sampling_radius")), 1e-15) << name;
  }
  EXPECT_FALSE(approximate_manifold(test::hexagon_certificate())->is_closed());
}

TEST(ApproximateManifold, OfNoFamilyIsRefused) {
  CertificateSummary certificate = test::hexagon_certificate();
  certificate.family = "fractal";
  EXPECT_THROW((void)approximate_manifold(certificate), InputError);
  certificate.family = "atlas";
  EXPECT_THROW((void)approximate_manifold(certificate), InputError);
  certificate.family = "flat-torus";
  EXPECT_THROW((void)approximate_manifold(certificate), InputError);
}

TEST(ApproximateManifold, ModelsHaveTheirNames) {
  EXPECT_EQ(name_of(DrawingModel::unit), "unit");
  EXPECT_EQ(name_of(DrawingModel::space), "space");
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
