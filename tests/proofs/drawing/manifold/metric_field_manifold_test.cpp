#include "proofs/drawing/manifold/metric_field_manifold.hpp"

#include <gtest/gtest.h>

#include "support/error.hpp"
#include "tests/proofs/drawing/drawn_certificates.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

using test::drawn_certificates;

TEST(MetricFieldManifold, ItsOwnChartShowsAPointWhereTheCertificateHasIt) {
  const CertificateSummary& certificate = drawn_certificates().at("metric-field");
  const MetricFieldManifold manifold(certificate);
  for (std::uint32_t label = 0; label < certificate.points.size(); ++label) {
    const auto own = manifold.in_chart(label, label, 0);
    ASSERT_TRUE(own.has_value());
    for (std::size_t axis = 0; axis < manifold.dimension(); ++axis)
      EXPECT_NEAR((*own)[axis], approximate_double(certificate.points[label][axis]), 1e-12);
  }
  EXPECT_FALSE(manifold.has_isometric_charts());
  EXPECT_FALSE(manifold.squared_edges({0, {0, 1, 2}, {0, 0, 0}}).has_value());
}

TEST(MetricFieldManifold, WithoutAChartIsRefused) {
  CertificateSummary certificate = drawn_certificates().at("metric-field");
  certificate.charts.pop_back();
  EXPECT_THROW(MetricFieldManifold{certificate}, InputError);
  certificate = drawn_certificates().at("metric-field");
  certificate.net_text = "[]";
  EXPECT_THROW(MetricFieldManifold{certificate}, InputError);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
