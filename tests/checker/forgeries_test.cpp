#include "tests/checker/support/forgeries.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <map>
#include <regex>

#include "tests/checker/support/run_checker.hpp"

namespace delcert::checker_tests {
namespace {

std::vector<Forgery> all_forgeries() {
  std::vector<Forgery> all;
  for (const auto& part : {form_forgeries(), level_0_forgeries(), star_forgeries(), configuration_forgeries(),
                           space_form_forgeries(), metric_field_forgeries(), metric_field_delaunay_forgeries()})
    all.insert(all.end(), part.begin(), part.end());
  return all;
}

std::set<std::string> matches(const std::string& path, const std::regex& pattern) {
  std::ifstream file(path);
  const std::string text((std::istreambuf_iterator<char>(file)), {});
  std::set<std::string> found;
  for (std::sregex_iterator match(text.begin(), text.end(), pattern), end; match != end; ++match)
    found.insert((*match)[1]);
  return found;
}

/// The rules that the checker's sources name.
std::set<std::string> rules_of_the_checker() {
  std::set<std::string> rules;
  for (const auto& file : std::filesystem::recursive_directory_iterator(DELCERT_SOURCE_DIR "/proofs/checker")) {
    if (!file.is_regular_file()) continue;
    rules.merge(matches(file.path(), std::regex(R"re("((?:form|group|field|[0-6]s?)\.[a-z][a-z0-9-]*|seal)")re")));
  }
  return rules;
}

TEST(Forgeries, are_made_from_certificates_that_the_checker_accepts) {
  for (const auto& certificates : {valid_certificates(), valid_space_form_certificates()}) {
    for (const auto& [name, bytes] : certificates) {
      const CheckerRun run = run_checker(bytes);
      EXPECT_EQ(run.status, 0) << name << "\n" << run.output;
      EXPECT_TRUE(run.rules.empty()) << name << "\n" << run.output;
    }
  }
}

/// What the core has to say of a forgery: the rule itself, if it is one of those that it decides as well; one of its
/// own, if the complex is none; else nothing.
void expect_core(const Forgery& forgery, const CheckerRun& run) {
  static const std::map<std::string, std::string> complexes = {
      {"a point shifted by a generator of the lattice", "core.facets"},
      {"two labels exchanged", "core.facets"},
      {"a flip", "core.hinges"},
      {"both diagonals of a quadrilateral", "core.facets"},
      {"a simplex missing from all stars", "core.facets"},
      {"a tetrahedron missing from all stars", "core.facets"},
      {"an arc of the circle missing", "core.facets"},
      {"two vertices identified", "core.sign"},
      {"the union of two disjoint circles", "core.connected"},
      {"two points of the sphere exchanged", "core.facets"},
      {"a hole in the sphere", "core.facets"},
      {"a hole in the projective space", "core.facets"},
      {"a hole in the Klein bottle", "core.facets"}};
  static const std::set<std::string> shared = {"4.ball",      "4.empty",         "5.radius",
                                               "5.thickness", "6.self-delaunay", "6.bilipschitz"};
  const auto complex = complexes.find(forgery.name);
  if (complex != complexes.end()) {
    EXPECT_TRUE(run.core.contains(complex->second)) << run.output;
  } else if (shared.contains(forgery.rule)) {
    EXPECT_EQ(run.core, std::set{forgery.rule}) << run.output;
  } else {
    EXPECT_TRUE(run.core.empty()) << run.output;
  }
}

TEST(Forgeries, are_rejected_each_by_its_rule_and_accepted_without_it) {
  std::cout << "rule               exit  without  forgery: message\n";
  for (const Forgery& forgery : all_forgeries()) {
    SCOPED_TRACE(forgery.name);
    const CheckerRun run = run_checker(forgery.bytes);
    EXPECT_EQ(run.status, forgery.status) << run.output;
    std::set<std::string> expected = forgery.others;
    expected.insert(forgery.rule);
    EXPECT_EQ(run.rules, expected) << run.output;
    expect_core(forgery, run);
    EXPECT_EQ(run.output.find("verified"), std::string::npos) << run.output;
    EXPECT_LT(run.seconds, 10);
    EXPECT_LT(run.peak_kib, 1 << 20);
    const CheckerRun crippled = run_checker(forgery.bytes, forgery.rule);
    std::cout << forgery.rule << std::string(19 - forgery.rule.size(), ' ') << run.status << "     " << crippled.status
              << "        " << forgery.name << ": " << run.message << "\n";
    if (forgery.others.empty()) {
      EXPECT_EQ(crippled.status, 0) << crippled.output;
    } else {
      EXPECT_EQ(crippled.rules, forgery.others) << crippled.output;
    }
  }
}

TEST(Forgeries, there_is_one_for_every_rule_that_only_this_rule_rejects) {
  std::set<std::string> tested;
  for (const Forgery& forgery : all_forgeries()) {
    if (forgery.others.empty()) tested.insert(forgery.rule);
  }
  // Without these there is no document to look at; malformed_test.cpp has them, metric_field_test.cpp form.charts.
  for (const char* structural :
       {"form.bytes", "form.version", "form.keys", "form.types", "form.numbers", "form.lengths", "form.labels",
        "form.elements", "form.loops", "form.field", "form.charts"}) {
    EXPECT_FALSE(tested.contains(structural));
    tested.insert(structural);
  }
  EXPECT_EQ(tested, rules_of_the_checker());
}

/// The rules that the text of a page names: those of the form in a table, those of the levels anywhere.
std::set<std::string> rules_of_the_page() {
  const std::string page = DELCERT_SOURCE_DIR "/docs/certificate-format.md";
  std::set<std::string> rules =
      matches(page, std::regex(R"re((?:^|[^a-z0-9.])((?:group|field|[0-6]s?)\.[a-z][a-z0-9-]+))re"));
  rules.merge(matches(page, std::regex(R"re(\| (form\.[a-z][a-z0-9-]*|seal) \|)re")));
  return rules;
}

TEST(Forgeries, the_rules_of_the_checker_are_those_of_the_format_page) {
  const std::set<std::string> rules = rules_of_the_page();
  EXPECT_TRUE(rules.contains("form.interior"));
  EXPECT_TRUE(rules.contains("seal"));
  EXPECT_EQ(rules, rules_of_the_checker());
}

}  // namespace
}  // namespace delcert::checker_tests
