// docs/submanifolds.md has a table of what is compared with what: the tests that it names exist.

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <set>
#include <string>

namespace delcert::test {
namespace DELCERT_THIS_FILE {

std::string text_of(const std::filesystem::path& path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// Suites, and tests as SUITE.NAME, of all sources below tests/.
std::set<std::string> tests_that_exist() {
  const std::regex pattern(R"re(\bTEST(?:_F|_P)?\((\w+),\s*(\w+)\))re");
  std::set<std::string> result;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(DELCERT_SOURCE_DIR "/tests")) {
    if (!entry.path().string().ends_with("_test.cpp")) continue;
    const std::string text = text_of(entry.path());
    for (std::sregex_iterator match(text.begin(), text.end(), pattern), end; match != end; ++match) {
      result.insert((*match)[1]);
      result.insert((*match)[1].str() + "." + (*match)[2].str());
    }
  }
  return result;
}

/// What stands between backticks in the last two columns of a table: names that begin with a capital.
std::set<std::string> tests_that_are_named(const std::string& page) {
  const std::string table = page.substr(page.find("| claim | other source | test | twin |"));
  const std::regex pattern(R"re(`([A-Z]\w+(?:\.\w+)?)`)re");
  std::set<std::string> result;
  for (std::sregex_iterator match(table.begin(), table.end(), pattern), end; match != end; ++match)
    result.insert((*match)[1]);
  return result;
}

std::set<std::string> missing(const std::string& page) {
  const std::set<std::string> existing = tests_that_exist();
  std::set<std::string> result;
  for (const std::string& name : tests_that_are_named(page)) {
    if (!existing.contains(name)) result.insert(name);
  }
  return result;
}

TEST(OracleTable, names_tests_that_exist) {
  const std::string page = text_of(DELCERT_SOURCE_DIR "/docs/submanifolds.md");
  EXPECT_GE(tests_that_are_named(page).size(), 10U);
  EXPECT_EQ(missing(page), std::set<std::string>{});
  // The twin.
  EXPECT_EQ(missing(page + "| a | b | `Trefoil.is_a_figure_eight` | `NoSuchSuite` |"),
            (std::set<std::string>{"Trefoil.is_a_figure_eight", "NoSuchSuite"}));
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
