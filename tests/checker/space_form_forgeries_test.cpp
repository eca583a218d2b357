// Rules that flat tori have too, under the same names, are rules of other code on space forms: each needs a forgery of
// its own there. That these are rejected, each by its rule alone, is in forgeries_test.cpp.

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
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
  std::set<std::string> rules;
  const std::filesystem::path sources = DELCERT_SOURCE_DIR "/proofs/checker";
  // The core's are those of margins, of which flat tori have none.
  for (const char* folder : {"space_forms", "charts", "core"}) {
    for (const auto& file : std::filesystem::directory_iterator(sources / folder)) rules.merge(rules_in(file));
  }
  // Level 2 is that of all families, but for 2s.patch of flat ones, which space_form_stars.cpp has too.
  rules.merge(rules_in(sources / "levels/level_2.cpp"));
  return rules;
}

TEST(SpaceFormForgeries, there_is_one_of_a_space_form_for_every_rule_that_only_this_rule_rejects) {
  std::set<std::string> tested;
  for (const Forgery& forgery : made_once(space_form_forgeries)) {
    const bool elsewhere = forgery.rule.starts_with("form.") || forgery.rule.starts_with("core.");
    if (forgery.others.empty() && !elsewhere) tested.insert(forgery.rule);
  }
  const std::set<std::string> rules = rules_of_space_forms();
  EXPECT_GE(rules.size(), 25U);
  EXPECT_TRUE(rules.contains("0.metric-distortion"));
  EXPECT_TRUE(rules.contains("4.empty"));
  EXPECT_EQ(tested, rules);
}

}  // namespace
}  // namespace delcert::checker_tests
