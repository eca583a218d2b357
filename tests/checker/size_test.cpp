#include <gtest/gtest.h>

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

/// Of each stem, `level_1` or `core/reader`, the lines of its files.
std::map<std::string, int> lines_by_stem() {
  const std::filesystem::path folder = DELCERT_SOURCE_DIR "/proofs/checker";
  std::map<std::string, int> lines;
  for (const auto& file : std::filesystem::recursive_directory_iterator(folder)) {
    const auto extension = file.path().extension();
    if (extension != ".cpp" && extension != ".hpp") continue;
    lines[std::filesystem::relative(file.path(), folder).replace_extension().string()] += lines_of_code(file.path());
  }
  return lines;
}

/// With DELCERT_RENEW in the environment the numbers of the table and the total are written anew.
TEST(SizeOfTheChecker, is_what_docs_decisions_size_of_the_checker_says) {
  std::map<std::string, int> lines = lines_by_stem();
  int total = 0;
  for (const auto& [stem, number] : lines) total += number;
  EXPECT_GT(total, 1000);

  const std::regex row(R"re(^(\|[^|]*\|((?: ?`[a-z0-9_/]+`,?)+) \| )([0-9]+)( \|)$)re"), stem(R"re(`([a-z0-9_/]+)`)re");
  std::istringstream page_lines(text_of_page());
  std::string renewed;
  for (std::string line; std::getline(page_lines, line);) {
    std::smatch match;
    if (std::regex_match(line, match, row)) {
      const std::string stems = match[2];
      int number = 0;
      for (std::sregex_iterator one(stems.begin(), stems.end(), stem), end; one != end; ++one) {
        const auto found = lines.find((*one)[1]);
        if (found == lines.end()) {
          ADD_FAILURE() << (*one)[1] << " is no file of the checker, or stands twice";
          continue;
        }
        number += found->second;
        lines.erase(found);
      }
      EXPECT_EQ(std::stoi(match[3]), number) << line;
      line = match[1].str() + std::to_string(number) + match[4].str();
    }
    renewed += line + "\n";
  }
  for (const auto& [left, number] : lines) ADD_FAILURE() << left << " is in no row";
  const std::string thousands = std::to_string(total / 1000) + " " + std::to_string(1000 + total % 1000).substr(1);
  renewed = std::regex_replace(renewed, std::regex("[0-9]+ [0-9]{3} lines of code"), thousands + " lines of code");
  if (std::getenv("DELCERT_RENEW") != nullptr) std::ofstream(page) << renewed;
  EXPECT_EQ(text_of_page(), renewed) << "DELCERT_RENEW=1 test_checker --gtest_filter=SizeOf*";
}

}  // namespace
}  // namespace delcert::checker_tests
