#include "proofs/drawing/manifold/space_form_json.hpp"

#include <gtest/gtest.h>

#include "support/error.hpp"
#include "tests/proofs/drawing/drawn_certificates.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

using test::drawn_certificates;

TEST(SpaceFormJson, has_the_group_that_the_run_had) {
  for (const char* name : {"sphere-2", "projective-plane", "klein-bottle", "bolza-surface"}) {
    const SpaceFormDescription built_in = find_space_form(name);
    const SpaceFormDescription read = space_form_of(drawn_certificates().at(name));
    EXPECT_EQ(read.name, name);
    EXPECT_EQ(read.form.curvature(), built_in.form.curvature());
    ASSERT_EQ(read.generators.size(), built_in.generators.size()) << name;
    for (std::size_t at = 0; at < read.generators.size(); ++at) {
      for (std::size_t row = 0; row < 3; ++row) {
        for (std::size_t column = 0; column < 3; ++column)
          EXPECT_EQ(read.generators[at](row, column).text(), built_in.generators[at](row, column).text());
      }
    }
  }
}

TEST(SpaceFormJson, elements_are_isometries_and_no_two_are_the_same) {
  for (const char* name : {"projective-plane", "klein-bottle", "bolza-surface"}) {
    const CertificateSummary& certificate = drawn_certificates().at(name);
    const SpaceFormDescription group = space_form_of(certificate);
    const std::vector<FieldMatrix> elements = elements_of(certificate, group);
    ASSERT_EQ(elements.size(), certificate.elements.size() + 1);
    for (std::size_t at = 0; at < elements.size(); ++at) {
      EXPECT_FALSE(group.form.why_no_isometry(elements[at]));
      for (std::size_t other = 0; other < at; ++other) EXPECT_FALSE(elements[at] == elements[other]) << name;
    }
  }
}

TEST(SpaceFormJson, refuses_what_is_not_as_the_format_says) {
  CertificateSummary certificate = drawn_certificates().at("bolza-surface");
  const SpaceFormDescription group = space_form_of(certificate);
  const auto elements = certificate.elements;
  for (const std::vector<std::int32_t>& wrong : {std::vector<std::int32_t>{0, 0}, {0, 5}, {0, -5}, {1, 1}, {-1, 1}}) {
    certificate.elements = elements;
    certificate.elements.front() = wrong;
    EXPECT_THROW((void)elements_of(certificate, group), InputError) << wrong[0] << " " << wrong[1];
  }
  certificate.manifold_text.replace(certificate.manifold_text.find("[\"-2\""), 5, "[\"-4\"");
  EXPECT_THROW((void)space_form_of(certificate), InputError);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
