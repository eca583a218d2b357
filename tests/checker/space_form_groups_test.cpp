// The groups of all examples, written by the certificate's writer, verified by the checker; and wrong ones.

#include <gtest/gtest.h>

#include <cfenv>
#include <nlohmann/json.hpp>

#include "kernel/manifold/space_form/space_form_file.hpp"
#include "proofs/certificate/space_form_writer.hpp"
#include "proofs/checker/group.hpp"
#include "proofs/checker/self_test.hpp"

namespace delcert::checker_tests {
namespace {

struct Written {
  int curvature, dimension;
  std::string text;  // of the manifold block
  std::size_t order = 0;
};

const std::vector<Written>& all_written() {
  static const std::vector<Written> result = [] {
    std::vector<Written> all;
    for (const BuiltinManifold& file : builtin_space_forms()) {
      const SpaceForm form = verify_space_form(find_space_form(std::string(file.name)));
      all.push_back({sign_of(form.form().curvature()), form.form().dimension(), manifold_object(form),
                     form.finite ? form.finite->elements.size() : 0});
    }
    return all;
  }();
  return result;
}

/// The checker computes with upward rounding.
struct Upwards {
  Upwards() { EXPECT_EQ(checker::self_test(), ""); }
  ~Upwards() { std::fesetround(FE_TONEAREST); }
};

checker::SpaceForm read(const Written& written, const std::string& text) {
  checker::Cursor cursor(std::string_view(text).substr(text.find(",\"field\":")));
  return {written.curvature, written.dimension, cursor};
}

TEST(SpaceFormGroups, of_all_examples_are_verified) {
  const std::vector<Written>& all = all_written();
  ASSERT_GE(all.size(), 20U);
  const Upwards upwards;
  for (const Written& written : all) {
    const checker::SpaceForm form = read(written, written.text);
    checker::Report report;
    const checker::Rational reach = checker::Rational(1) / checker::Rational(10);
    const checker::Group group = check_group(form, reach, reach, report);
    for (const checker::Finding& finding : report.findings) ADD_FAILURE() << written.text.substr(0, 60) << finding.what;
    EXPECT_TRUE(!group.elements.empty()) << written.text;
    if (written.curvature > 0) {
      EXPECT_EQ(group.elements.size(), written.order);
    }
  }
}

/// A seventh more in one entry of a generator, for the first entries of each.
TEST(SpaceFormGroups, with_one_wrong_entry_are_rejected) {
  const std::vector<Written>& all = all_written();
  const Upwards upwards;
  int refused = 0;
  for (const Written& written : all) {
    const auto json = nlohmann::ordered_json::parse(written.text);
    for (std::size_t row = 0; row < json["generators"].size() && row < 3; ++row) {
      auto wrong = json;
      auto& entry = wrong["generators"][0][row][1];
      entry = entry == nlohmann::ordered_json::array({"1/7"}) ? nlohmann::ordered_json::array({"2/7"})
                                                              : nlohmann::ordered_json::array({"1/7"});
      const std::string text = wrong.dump();
      const checker::SpaceForm form = read(written, text);
      checker::Report report;
      (void)check_group(form, checker::Rational(1), checker::Rational(1), report);
      ASSERT_EQ(report.findings.size(), 1U) << text;
      EXPECT_EQ(report.findings[0].rule, "group.generator");
      ++refused;
    }
  }
  EXPECT_GE(refused, 20);
}

}  // namespace
}  // namespace delcert::checker_tests
