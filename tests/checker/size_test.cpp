#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <regex>
#include <sstream>
#include <string>

namespace delcert::checker_tests {
namespace {

/// Lines that are neither empty nor only a comment.
int lines_of_code(const std::filesystem::path& file) {
  const std::regex no_code(R"re(\s*(//.*)?)re");
  std::ifstream stream(file);
  int lines = 0;
  for (std::string line; std::getline(stream, line);) lines += std::regex_match(line, no_code) ? 0 : 1;
  return lines;
}

const std::filesystem::path page = DELCERT_SOURCE_DIR "/docs/decisions/size-of-the-checker.md";

std::string text_of_page() {
  std::ifstream stream(page);
  return {(std::istreambuf_iterator<char>(stream)), {}};
}

/// Of each folder, `levels`, and of what is in none, `run`, the lines of its files.
/// Also the lines of the longest file.
std::map<std::string, int> lines_by_part(int& longest) {
  const std::filesystem::path folder = DELCERT_SOURCE_DIR "/proofs/checker";
  std::map<std::string, int> lines;
  for (const auto& file : std::filesystem::recursive_directory_iterator(folder)) {
    const auto extension = file.path().extension();
    if (extension != ".cpp" && extension != ".hpp") continue;
    const auto part = *std::filesystem::relative(file.path(), folder).begin();
    const int here = lines_of_code(file.path());
    lines[part.stem().string()] += here;
    longest = std::max(longest, here);
  }
  return lines;
}

/// With DELCERT_RENEW in the environment the numbers of the table and the total are written anew.
TEST(SizeOfTheChecker, is_what_docs_decisions_size_of_the_checker_says) {
  int longest = 0;
  std::map<std::string, int> lines = lines_by_part(longest);
  int total = 0;
  for (const auto& [part, number] : lines) total += number;
  EXPECT_GT(total, 1000);

  const std::regex row(R"re(^(\| `([a-z_]+)` \|.*\| )([0-9]+)( \|)$)re");
  std::istringstream page_lines(text_of_page());
  std::string renewed;
  for (std::string line; std::getline(page_lines, line);) {
    std::smatch match;
    if (std::regex_match(line, match, row)) {
      const auto found = lines.find(match[2]);
      if (found == lines.end()) {
        ADD_FAILURE() << match[2] << " is no part of the checker, or stands twice";
      } else {
        EXPECT_EQ(std::stoi(match[3]), found->second) << line;
        line = match[1].str() + std::to_string(found->second) + match[4].str();
        lines.erase(found);
      }
    }
    renewed += line + "\n";
  }
  for (const auto& [left, number] : lines) ADD_FAILURE() << left << " is in no row";
  const std::string thousands = std::to_string(total / 1000) + " " + std::to_string(1000 + total % 1000).substr(1);
  renewed = std::regex_replace(renewed, std::regex("[0-9]+ [0-9]{3} lines of code"), thousands + " lines of code");
  renewed = std::regex_replace(renewed, std::regex("in files of at most [0-9]+ lines"),
                               "in files of at most " + std::to_string(longest) + " lines");
  if (std::getenv("DELCERT_RENEW") != nullptr) std::ofstream(page) << renewed;
  EXPECT_EQ(text_of_page(), renewed) << "DELCERT_RENEW=1 test_checker --gtest_filter=SizeOf*";
}

}  // namespace
}  // namespace delcert::checker_tests
