#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
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

/// What the table of the page says of its parts, and the total of its text, "2 114 lines of code".
struct Page {
  int parts = 0;
  int total = 0;
};

Page page() {
  std::ifstream stream(DELCERT_SOURCE_DIR "/docs/decisions/size-of-the-checker.md");
  const std::string text((std::istreambuf_iterator<char>(stream)), {});
  const std::regex row(R"re(\| ([0-9]+) \|\n)re"), total(R"re(([0-9]+) ([0-9]{3}) lines of code)re");
  Page result;
  for (std::sregex_iterator match(text.begin(), text.end(), row), end; match != end; ++match)
    result.parts += std::stoi((*match)[1]);
  std::smatch match;
  if (std::regex_search(text, match, total)) result.total = std::stoi(match[1].str() + match[2].str());
  return result;
}

TEST(SizeOfTheChecker, is_what_docs_decisions_size_of_the_checker_says) {
  int lines = 0;
  for (const auto& file : std::filesystem::recursive_directory_iterator(DELCERT_SOURCE_DIR "/proofs/checker")) {
    const auto extension = file.path().extension();
    if (extension == ".cpp" || extension == ".hpp") lines += lines_of_code(file.path());
  }
  EXPECT_GT(lines, 1000);
  EXPECT_EQ(page().total, lines);
  EXPECT_EQ(page().parts, lines);
}

}  // namespace
}  // namespace delcert::checker_tests
