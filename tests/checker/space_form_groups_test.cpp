// The groups of all examples, written by the certificate's writer, verified by the checker; and wrong ones.

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "kernel/manifold/space_form_file.hpp"
#include "kernel/number/exact_text.hpp"
#include "proofs/certificate/content.hpp"
#include "proofs/checker/space_forms/group.hpp"
#include "tests/checker/support/space_form_samples.hpp"
#include "tests/checker/upwards.hpp"

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

checker::SpaceForm read(const Written& written, const std::string& text) {
  checker::Cursor cursor(std::string_view(text).substr(text.find(",\"field\":")));
  return {written.curvature, written.dimension, cursor};
}

TEST(SpaceFormGroups, of_all_examples_are_verified) {
  const std::vector<Written>& all = all_written();
  ASSERT_GE(all.size(), 20U);
  const test::Upwards upwards;
  for (const Written& written : all) {
    const checker::SpaceForm form = read(written, written.text);
    checker::Report report;
    const checker::Group group = check_group(form, report);
    for (const checker::Finding& finding : report.findings) ADD_FAILURE() << written.text.substr(0, 60) << finding.what;
    EXPECT_FALSE(group.size.empty()) << written.text;
    if (written.curvature > 0) {
      EXPECT_EQ(group.size, "order " + std::to_string(written.order));
    }
  }
}

/// A seventh more in one entry of a generator, for the first entries of each.
TEST(SpaceFormGroups, with_one_wrong_entry_are_rejected) {
  const std::vector<Written>& all = all_written();
  const test::Upwards upwards;
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
      (void)check_group(form, report);
      ASSERT_EQ(report.findings.size(), 1U) << text;
      EXPECT_EQ(report.findings[0].rule, "group.generator");
      ++refused;
    }
  }
  EXPECT_GE(refused, 20);
}

/// The stated injectivity radius, made greater by a thousandth.
TEST(SpaceFormGroups, that_move_points_by_less_than_stated_are_rejected) {
  const std::vector<Written>& all = all_written();
  const test::Upwards upwards;
  for (const Written& written : all) {
    auto wrong = nlohmann::ordered_json::parse(written.text);
    const Rational stated = parse_exact(wrong["injectivity_radius"].get<std::string>());
    wrong["injectivity_radius"] = exact_text(stated * Rational(1001) / Rational(1000));
    const std::string text = wrong.dump();
    const checker::SpaceForm form = read(written, text);
    checker::Report report;
    (void)check_group(form, report);
    ASSERT_FALSE(report.findings.empty()) << text.substr(0, 60);
    EXPECT_EQ(report.findings[0].rule, "group.injectivity") << text.substr(0, 60);
  }
}

/// The manifold block of a group over the rational numbers.
std::string rational_group(int curvature, const std::string& generators, const std::string& injectivity_radius) {
  return R"(,"field":["0","1"],"root":["-1","1"],"time":[")" + std::to_string(curvature) +
         R"("],"gram":[[["1"],["0"]],[["0"],["1"]]],"generators":)" + generators + R"(,"injectivity_radius":")" +
         injectivity_radius + "\"}";
}

std::string rule_against(int curvature, const std::string& generators,
                         const std::string& injectivity_radius = "1/100") {
  const checker::SpaceForm form = read({curvature, 2, {}}, rational_group(curvature, generators, injectivity_radius));
  checker::Report report;
  (void)check_group(form, report);
  return report.findings.empty() ? "" : report.findings[0].rule + ": " + report.findings[0].what;
}

std::string matrix(const std::vector<std::string>& entries) {
  std::string text;
  for (std::size_t k = 0; k < 9; ++k)
    text += (k % 3 == 0 ? (k == 0 ? "[[" : "],[") : ",") + ("[\"" + entries[k] + "\"]");
  return text + "]]";
}

TEST(SpaceFormGroups, with_fixed_points_are_rejected) {
  const test::Upwards upwards;
  const std::string opposite = matrix({"-1", "0", "0", "0", "-1", "0", "0", "0", "-1"}),
                    half_turn = matrix({"1", "0", "0", "0", "-1", "0", "0", "0", "-1"}),
                    reflection = matrix({"1", "0", "0", "0", "1", "0", "0", "0", "-1"}),
                    glide = matrix({"1", "0", "0", "1/2", "1", "0", "0", "0", "-1"}),
                    other_glide = matrix({"1", "0", "0", "0", "-1", "0", "1/2", "0", "1"}),
                    eighth = matrix({"1", "0", "0", "1/8", "1", "0", "0", "0", "-1"}),
                    quarter_turn = matrix({"1", "0", "0", "1/2", "0", "-1", "0", "1", "0"});
  EXPECT_EQ(rule_against(1, "[" + opposite + "]"), "");
  EXPECT_EQ(rule_against(1, "[" + half_turn + "]").substr(0, 18), "group.injectivity:");
  EXPECT_EQ(rule_against(1, "[" + reflection + "]").substr(0, 18), "group.injectivity:");
  EXPECT_EQ(rule_against(1, "[" + opposite + "," + half_turn + "]").substr(0, 18), "group.injectivity:");
  EXPECT_EQ(rule_against(0, "[" + glide + "]", "1/4"), "");
  EXPECT_EQ(rule_against(0, "[" + glide + "]", "26/100").substr(0, 18), "group.injectivity:");
  EXPECT_EQ(rule_against(0, "[" + reflection + "]").substr(0, 18), "group.injectivity:");
  EXPECT_EQ(rule_against(0, "[" + half_turn + "]").substr(0, 18), "group.injectivity:");
  // Each glide is free, their product is a half-turn; a quarter turn has a fixed point somewhere.
  EXPECT_EQ(rule_against(0, "[" + other_glide + "]", "1/4"), "");
  EXPECT_EQ(rule_against(0, "[" + glide + "," + other_glide + "]").substr(0, 18), "group.injectivity:");
  EXPECT_EQ(rule_against(0, "[" + quarter_turn + "]").substr(0, 18), "group.injectivity:");
  // Translations outside of the lattice count.
  EXPECT_EQ(rule_against(0, "[" + eighth + "]", "1/16"), "");
  EXPECT_EQ(rule_against(0, "[" + eighth + "]", "1/10").substr(0, 18), "group.injectivity:");
}

/// The surface with a crosscap far from o, in the basis o, e + skew f, skew e + (1 + skew^2) f.
std::string rule_against_crosscap(const Integer& skew, const std::string& injectivity_radius) {
  Json block = surface_with_far_crosscap();
  const auto number = [](const Json& entry) { return parse_exact(entry[0].get<std::string>()); };
  const auto changed = [](Json& entry, const Rational& x) { entry = Json::array({exact_text(x)}); };
  const Rational s(skew);
  const Rational basis[2][2] = {{1, s}, {s, 1 + s * s}};
  const Rational inverse[2][2] = {{1 + s * s, -s}, {-s, 1}};
  for (std::size_t i = 0; i < 2; ++i) {
    for (std::size_t k = 0; k < 2; ++k)
      changed(block["gram"][i][k], basis[0][i] * basis[0][k] + basis[1][i] * basis[1][k]);
  }
  for (Json& g : block["generators"]) {
    for (Json& row : g) {
      const Rational x = number(row[1]), y = number(row[2]);
      for (std::size_t k = 0; k < 2; ++k) changed(row[k + 1], x * basis[0][k] + y * basis[1][k]);
    }
    for (std::size_t column = 0; column < 3; ++column) {
      const Rational x = number(g[1][column]), y = number(g[2][column]);
      for (std::size_t i = 0; i < 2; ++i) changed(g[i + 1][column], inverse[i][0] * x + inverse[i][1] * y);
    }
  }
  block["injectivity_radius"] = injectivity_radius;
  const std::string text = block.dump();
  const checker::SpaceForm form = read({-1, 2, {}}, text);
  checker::Report report;
  (void)check_group(form, report);
  return report.findings.empty() ? "" : report.findings[0].rule;
}

/// What moves a point by log 4 is no side, and three tiles away from o.
TEST(SpaceFormGroups, that_move_points_far_from_o_by_less_than_stated_are_rejected) {
  const test::Upwards upwards;
  EXPECT_EQ(rule_against_crosscap(0, "69/100"), "");
  EXPECT_EQ(rule_against_crosscap(0, "7/10"), "group.injectivity");
}

/// Entries are some 2^80 times as large as in an orthonormal basis, and what they sum up to is not: an interval of
/// doubles does not tell how far away any tile is.
TEST(SpaceFormGroups, in_a_skew_basis_are_walked_by_exact_centres) {
  const test::Upwards upwards;
  const Integer skew = (Integer(1) << 40) + 1;
  EXPECT_EQ(rule_against_crosscap(skew, "69/100"), "");
  EXPECT_EQ(rule_against_crosscap(skew, "7/10"), "group.injectivity");
}

/// The Bolza surface without some of its generators, or with one replaced by its product with another.
TEST(SpaceFormGroups, without_a_compact_polyhedron_that_closes_up_are_rejected) {
  const Written* bolza = nullptr;
  for (const Written& written : all_written()) {
    if (written.text.find("\"bolza-surface\"") != std::string::npos) bolza = &written;
  }
  ASSERT_NE(bolza, nullptr);
  const test::Upwards upwards;
  const auto fault = [&](const nlohmann::ordered_json& json) {
    const std::string text = json.dump();
    const checker::SpaceForm form = read(*bolza, text);
    checker::Report report;
    (void)check_group(form, report);
    return report.findings.empty() ? "" : report.findings[0].rule;
  };
  const auto json = nlohmann::ordered_json::parse(bolza->text);
  EXPECT_EQ(fault(json), "");
  for (std::size_t left_out = 0; left_out < 4; ++left_out) {
    auto fewer = json;
    fewer["generators"].erase(left_out);
    EXPECT_EQ(fault(fewer), "group.polyhedron");
  }
  auto one = json;
  one["generators"] = nlohmann::ordered_json::array({json["generators"][0]});
  EXPECT_EQ(fault(one), "group.polyhedron");
  auto none = json;
  none["generators"] = nlohmann::ordered_json::array();
  EXPECT_EQ(fault(none), "group.polyhedron");
}

}  // namespace
}  // namespace delcert::checker_tests
