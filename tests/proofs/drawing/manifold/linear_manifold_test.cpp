#include "proofs/drawing/manifold/linear_manifold.hpp"

#include <gtest/gtest.h>

#include "support/error.hpp"
#include "tests/proofs/drawing/drawn_certificates.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

using test::drawn_certificates;

TEST(LinearManifold, SheetsAreGroupElements) {
  for (const char* name : {"flat-torus", "klein-bottle", "bolza-surface", "projective-plane", "metric-field"}) {
    const CertificateSummary& certificate = drawn_certificates().at(name);
    const auto manifold = approximate_manifold(certificate);
    const auto last = static_cast<std::uint32_t>(certificate.elements.size());
    ASSERT_GT(last, 0U) << name;
    const std::uint32_t sheet = manifold->vertex_sheet(0, last);
    EXPECT_NE(sheet, 0U);
    EXPECT_EQ(manifold->simplex_sheet(sheet, last), 0U);
    EXPECT_EQ(manifold->vertex_sheet(sheet, 0), sheet);
    EXPECT_EQ(manifold->relative_element(last, last), 0U);
    EXPECT_NE(manifold->sheet_text(sheet), manifold->sheet_text(0));
    EXPECT_EQ(manifold->step_text(0, sheet), manifold->sheet_text(sheet));
  }
}

TEST(LinearManifold, WithoutItsDimensionIsRefused) {
  CertificateSummary certificate = drawn_certificates().at("flat-torus");
  certificate.manifold.dimension = Dimension(5);
  EXPECT_THROW((void)approximate_manifold(certificate), InputError);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
