#include "proofs/drawing/space_form_bounds.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "support/error.hpp"
#include "tests/proofs/drawing/drawn_certificates.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

using test::drawn_certificates;

TEST(SpaceFormBounds, notice_an_element_that_is_another) {
  CertificateSummary certificate = drawn_certificates().at("bolza-surface");
  const auto moved = std::find_if(certificate.simplices.begin(), certificate.simplices.end(),
                                  [](const std::vector<std::uint32_t>& row) { return row[3] != 0; });
  ASSERT_NE(moved, certificate.simplices.end());
  (*moved)[3] = 0;
  EXPECT_THROW((void)space_form_bounds(certificate), InputError);
}

TEST(SpaceFormBounds, are_not_of_a_group_that_is_none) {
  CertificateSummary certificate = drawn_certificates().at("bolza-surface");
  const std::size_t at = certificate.manifold_text.find("\"56\",\"40\"");
  ASSERT_NE(at, std::string::npos);
  certificate.manifold_text.replace(at, 4, "\"57\"");
  EXPECT_THROW((void)space_form_bounds(certificate), Rejection);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
