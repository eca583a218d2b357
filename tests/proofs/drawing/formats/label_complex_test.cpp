#include "proofs/drawing/formats/label_complex.hpp"

#include <gtest/gtest.h>

#include "support/error.hpp"
#include "tests/proofs/drawing/drawn_certificates.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

TEST(LabelComplex, IsClosedOnClosedManifolds) {
  for (const auto& [name, certificate] : test::drawn_certificates()) {
    const LabelComplex complex = label_complex(certificate);
    EXPECT_TRUE(complex.is_closed) << name;
    EXPECT_EQ(complex.labels.size(), certificate.points.size()) << name;
    EXPECT_EQ(complex.simplex_count(), certificate.simplices.size()) << name;
  }
  EXPECT_FALSE(label_complex(test::hexagon_certificate()).is_closed);
}

TEST(LabelComplex, IsSimplifiedWithItsHomology) {
  for (const auto& [name, certificate] : test::drawn_certificates()) {
    const Simplification less = simplified(certificate, label_complex(certificate));
    EXPECT_LT(less.complex.simplex_count(), 60U) << name;
    EXPECT_GT(less.contractions, 100U) << name;
    std::string claimed;
    for (const auto& [level, margins] : certificate.levels) {
      for (const auto& [key, value] : margins) claimed += level == "2" && key == "homology" ? value : "";
    }
    std::string found;
    for (const std::string& group : less.homology) found += (found.empty() ? "" : ", ") + group;
    EXPECT_EQ(found, claimed) << name;
    for (const std::uint32_t label : less.complex.labels) EXPECT_LT(label, certificate.points.size());
  }
}

TEST(LabelComplex, OfNoManifoldIsNotSimplified) {
  const CertificateSummary hexagon = test::hexagon_certificate();
  EXPECT_THROW((void)simplified(hexagon, label_complex(hexagon)), InputError);
  CertificateSummary certificate = test::torus_certificate();
  const LabelComplex complex = label_complex(certificate);
  std::erase_if(certificate.levels, [](const auto& level) { return level.first == "2"; });
  EXPECT_THROW((void)simplified(certificate, complex), InputError);
}

TEST(LabelComplex, OfBrokenRowsIsRefused) {
  CertificateSummary certificate = test::torus_certificate();
  certificate.simplices.push_back(certificate.simplices.front());
  certificate.simplices.back()[2] = certificate.simplices.back()[1];
  EXPECT_THROW((void)label_complex(certificate), InputError);
  certificate.simplices.back() = {0, 1, 99999, 0, 0};
  EXPECT_THROW((void)label_complex(certificate), InputError);
  certificate.simplices.clear();
  EXPECT_THROW((void)label_complex(certificate), InputError);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
