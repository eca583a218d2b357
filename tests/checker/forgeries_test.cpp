#include "tests/checker/support/forgeries.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <map>
#include <regex>

#include "tests/checker/support/run_checker.hpp"

namespace delcert::checker_tests {
namespace {

std::vector<const Forgery*> all_forgeries() {
  std::vector<const Forgery*> all;
  for (const auto make : {form_forgeries, level_0_forgeries, star_forgeries, core_forgeries, configuration_forgeries,
                          space_form_forgeries, metric_field_forgeries, metric_field_delaunay_forgeries,
                          atlas_forgeries, submanifold_forgeries}) {
    for (const Forgery& forgery : made_once(make)) all.push_back(&forgery);
  }
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
    rules.merge(
        matches(file.path(),
                std::regex(R"re("((?:form|core|group|field|atlas|sub|mesh|[0-6][sfi]?)\.[a-z][a-z0-9-]*|seal)")re")));
  }
  return rules;
}

TEST(Forgeries, are_made_from_certificates_that_the_checker_accepts) {
  for (const auto& certificates :
       {valid_certificates(), valid_graded_certificates(), valid_space_form_certificates()}) {
    for (const auto& [name, bytes] : certificates) {
      const CheckerRun run = run_checker(bytes);
      EXPECT_EQ(run.status, 0) << name << "\n" << run.output;
      EXPECT_TRUE(run.rules.empty()) << name << "\n" << run.output;
    }
  }
}

TEST(Forgeries, are_rejected_each_by_its_rule_and_accepted_without_it) {
  std::cout << "rule               exit  without  forgery: message\n";
  for (const Forgery* made : all_forgeries()) {
    const Forgery& forgery = *made;
    SCOPED_TRACE(forgery.name);
    const CheckerRun run = run_checker(forgery.bytes);
    EXPECT_EQ(run.status, forgery.status) << run.output;
    std::set<std::string> expected = forgery.others;
    expected.insert(forgery.rule);
    EXPECT_EQ(run.rules, expected) << run.output;
    EXPECT_EQ(run.output.find("verified"), std::string::npos) << run.output;
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

/// Without these there is no document to look at.
const std::map<std::string, std::string> structural = {
    {"form.bytes", "malformed_test.cpp"},     {"form.version", "malformed_test.cpp"},
    {"form.keys", "malformed_test.cpp"},      {"form.types", "malformed_test.cpp"},
    {"form.numbers", "malformed_test.cpp"},   {"form.lengths", "malformed_test.cpp"},
    {"form.labels", "malformed_test.cpp"},    {"form.elements", "malformed_test.cpp"},
    {"form.loops", "malformed_test.cpp"},     {"form.field", "space_form_test.cpp"},
    {"form.charts", "metric_field_test.cpp"}, {"form.formula", "submanifold_test.cpp"}};

TEST(Forgeries, there_is_one_for_every_rule_that_only_this_rule_rejects) {
  std::set<std::string> tested;
  for (const Forgery* made : all_forgeries()) {
    const Forgery& forgery = *made;
    if (forgery.others.empty()) tested.insert(forgery.rule);
  }
  for (const auto& [rule, file] : structural) {
    EXPECT_FALSE(tested.contains(rule));
    EXPECT_TRUE(matches(DELCERT_SOURCE_DIR "/tests/checker/" + file, std::regex('(' + rule + ')')).contains(rule))
        << rule;
    tested.insert(rule);
  }
  EXPECT_EQ(tested, rules_of_the_checker());
}

std::string family_of(const Forgery& forgery) {
  const std::string key = "\"family\":\"";
  const std::size_t begin = forgery.bytes.find(key) + key.size();
  return forgery.bytes.substr(begin, forgery.bytes.find('"', begin) - begin);
}

/// Of each rule and family the forgeries that this rule alone rejects.
std::string table_of_forgeries() {
  std::map<std::pair<std::string, std::string>, std::string> rows;
  std::size_t number = 0, by_several = 0;
  for (const Forgery* made : all_forgeries()) {
    const Forgery& forgery = *made;
    if (!forgery.others.empty()) {
      ++by_several;
      continue;
    }
    std::string& names = rows[{forgery.rule, family_of(forgery)}];
    names += (names.empty() ? "" : "; ") + forgery.name;
    ++number;
  }
  for (const auto& [rule, file] : structural) rows[{rule, "all"}] = "documents of `tests/checker/" + file + "`";
  std::string text = "| rule | family | what it alone rejects |\n|---|---|---|\n";
  for (const auto& [key, names] : rows) text += "| " + key.first + " | " + key.second + " | " + names + " |\n";
  return text + "\n" + std::to_string(rules_of_the_checker().size()) + " rules; " + std::to_string(number) +
         " forgeries that one rule alone rejects, and " + std::to_string(by_several) + " that several do.\n";
}

/// With DELCERT_RENEW in the environment the table is written anew.
TEST(Forgeries, are_those_of_the_page) {
  const std::string page = DELCERT_SOURCE_DIR "/docs/forgeries.md";
  std::ifstream file(page);
  const std::string text((std::istreambuf_iterator<char>(file)), {});
  const std::string head = text.substr(0, text.find("| rule |")), renewed = head + table_of_forgeries();
  if (std::getenv("DELCERT_RENEW") != nullptr) std::ofstream(page) << renewed;
  EXPECT_EQ(text, renewed) << "DELCERT_RENEW=1 test_checker --gtest_filter=Forgeries.are_those_of_the_page";
}

/// The rules that the text of a page names: those of the form in a table, those of the levels anywhere.
std::set<std::string> rules_of_the_page() {
  const std::string page = DELCERT_SOURCE_DIR "/docs/certificate-format.md";
  std::set<std::string> rules = matches(
      page, std::regex(R"re((?:^|[^a-z0-9./])((?:core|group|field|atlas|sub|mesh|[0-6][sfi]?)\.[a-z][a-z0-9-]+))re"));
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
