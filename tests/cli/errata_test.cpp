#include <gtest/gtest.h>
#include <sys/wait.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "proofs/errata/errata_text.hpp"

namespace delcert {
namespace {

struct CommandRun {
  int status = -1;
  std::string output;
};

/// Runs a command of a shell at the root of the sources, where `delcert` is the program that was just built.
CommandRun run(const std::string& command) {
  const std::string shell_command =
      "cd '" DELCERT_SOURCE_DIR "' && delcert() { '" DELCERT_PROGRAM "' \"$@\"; }; { " + command + "; } 2>&1";
  std::FILE* pipe = popen(shell_command.c_str(), "r");
  if (pipe == nullptr) return {-1, "cannot run a shell"};
  CommandRun result;
  std::array<char, 4096> buffer{};
  for (std::size_t count = 0; (count = std::fread(buffer.data(), 1, buffer.size(), pipe)) != 0;)
    result.output.append(buffer.data(), count);
  const int status = pclose(pipe);
  result.status = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  return result;
}

TEST(Errata, page_is_what_the_program_prints) {
  std::ifstream stream(DELCERT_SOURCE_DIR "/docs/errata.md");
  const std::string page((std::istreambuf_iterator<char>(stream)), {});
  const CommandRun printed = run("delcert errata");
  EXPECT_EQ(printed.status, 0);
  EXPECT_EQ(page, printed.output) << "docs/errata.md is not up to date: delcert errata > docs/errata.md";
  EXPECT_EQ(printed.output, errata_markdown(builtin_errata_list()));
}

/// What the next test rests on: a claim that holds is told from one that is refuted, and from a command that fails.
TEST(Errata, commands_end_with_one_only_where_something_is_refuted) {
  const std::string replay =
      "delcert attack --replay proofs/claims/witnesses/circumcentres-under-distortion.circumcentre.json";
  EXPECT_EQ(run(replay).status, 1);
  EXPECT_NE(run(replay + " circumcentres-under-distortion-mended").status, 1);
  EXPECT_EQ(run("delcert attack --replay no-such-file.json").status, 3);
  EXPECT_EQ(run("delcert --no-such-option").status, 64);
}

/// The parameter is the name of a file of proofs/errata, without its ending.
class DecidableErrata : public ::testing::TestWithParam<std::string> {};

TEST_P(DecidableErrata, are_reproduced_by_their_command) {
  const Erratum erratum = read_erratum(DELCERT_SOURCE_DIR "/proofs/errata/" + GetParam() + ".toml");
  const CommandRun result = run(erratum.command);
  EXPECT_EQ(result.status, 1) << erratum.command << "\n" << result.output;
}

std::vector<std::string> decidable_errata() {
  std::vector<std::string> names;
  for (const Erratum& erratum : builtin_errata_list())
    if (erratum.decidable) names.push_back(std::filesystem::path(erratum.file).stem());
  return names;
}

std::string name_of_case(const ::testing::TestParamInfo<std::string>& info) {
  std::string name = info.param;
  std::replace_if(
      name.begin(), name.end(), [](unsigned char c) { return std::isalnum(c) == 0; }, '_');
  return name;
}

INSTANTIATE_TEST_SUITE_P(Errata, DecidableErrata, ::testing::ValuesIn(decidable_errata()), name_of_case);

}  // namespace
}  // namespace delcert
