// Rules that flat tori have too, under the same names, are rules of other code on space forms: each needs a forgery of
// its own there. That these are rejected, each by its rule alone, is in forgeries_test.cpp.

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <regex>

#include "tests/checker/support/forgeries.hpp"

namespace delcert::checker_tests {
namespace {

/// The rules that one of the checker's sources names.
std::set<std::string> rules_in(const std::filesystem::path& source) {
  std::ifstream file(source);
  const std::string text((std::istreambuf_iterator<char>(file)), {});
  const std::regex rule(R"re("((?:group|[0-6]s?)\.[a-z][a-z0-9-]*)")re");
  std::set<std::string> found;
  for (std::sregex_iterator match(text.begin(), text.end(), rule), end; match != end; ++match)
    found.insert((*match)[1]);
  return found;
}

std::set<std::string> rules_of_space_forms() {
  std::set<std::string> rules{"1.facets"};  // check_facets, in level_1.cpp
  for (const auto& file : std::filesystem::directory_iterator(DELCERT_SOURCE_DIR "/proofs/checker")) {
    const std::string name = file.path().filename().string();
    if (std::regex_match(name, std::regex(R"re((space_form|group|dirichlet|lifts|chart).*\.cpp)re")))
      rules.merge(rules_in(file));
  }
  // Level 2 is that of all families, but for 2s.patch of flat ones, which space_form_stars.cpp has too.
  rules.merge(rules_in(DELCERT_SOURCE_DIR "/proofs/checker/level_2.cpp"));
  return rules;
}

TEST(SpaceFormForgeries, there_is_one_of_a_space_form_for_every_rule_that_only_this_rule_rejects) {
  std::set<std::string> tested;
  for (const Forgery& forgery : space_form_forgeries()) {
    if (forgery.others.empty() && !forgery.rule.starts_with("form.")) tested.insert(forgery.rule);
  }
  const std::set<std::string> rules = rules_of_space_forms();
  EXPECT_GE(rules.size(), 27U);
  EXPECT_TRUE(rules.contains("0.metric-distortion"));
  EXPECT_EQ(tested, rules);
}

TEST(SpaceFormForgeries, are_those_of_the_format_page) {
  std::map<std::string, std::string> names;
  for (const Forgery& forgery : space_form_forgeries()) {
    if (forgery.rule.starts_with("form.")) continue;
    std::string& of_rule = names[forgery.rule];
    of_rule += (of_rule.empty() ? "" : "; ") + forgery.name;
  }
  std::ifstream file(DELCERT_SOURCE_DIR "/docs/certificate-format.md");
  std::string page((std::istreambuf_iterator<char>(file)), {});
  page = page.substr(page.find("### Forgeries of space forms"));
  page = page.substr(0, page.find("\n## "));
  EXPECT_EQ(static_cast<std::size_t>(std::count(page.begin(), page.end(), '\n')), names.size() + 8);
  for (const auto& [rule, forged] : names)
    EXPECT_NE(page.find("\n| " + rule + " | " + forged + " |\n"), std::string::npos) << rule << ": " << forged;
}

}  // namespace
}  // namespace delcert::checker_tests
