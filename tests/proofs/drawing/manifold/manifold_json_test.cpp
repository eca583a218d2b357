#include "proofs/drawing/manifold/manifold_json.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "support/error.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

TEST(ManifoldJson, RootsAreTheOnesBetween) {
  EXPECT_NEAR(root_of({-2, 0, 1}, 1, 2), std::sqrt(2), 1e-15);
  EXPECT_NEAR(root_of({-2, 0, 1}, -2, -1), -std::sqrt(2), 1e-15);
  EXPECT_EQ(root_of({0, 1}, -1, 1), 0);
  EXPECT_NEAR(value_of({1, 2, 3}, 0.5), 2.75, 1e-15);
}

TEST(ManifoldJson, ReadsExactNumbers) {
  EXPECT_EQ(numbers_of(nlohmann::ordered_json::parse(R"(["1/4","-3","0x3p-1"])")),
            (std::vector<double>{0.25, -3, 1.5}));
  EXPECT_THROW((void)numbers_of(nlohmann::ordered_json::parse(R"(["0.25"])")), InputError);
}

TEST(ManifoldJson, OfWhatIsNoneIsRefused) {
  CertificateSummary certificate;
  certificate.manifold_text = "{\"name\":";
  EXPECT_THROW((void)manifold_json(certificate), InputError);
  certificate.manifold_text = "{\"name\":\"x\"}";
  EXPECT_EQ(manifold_json(certificate).at("name"), "x");
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
