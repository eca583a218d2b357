#include "apps/checker_process.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <system_error>

#include "tests/support/temporary_folder.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

namespace fs = std::filesystem;

/// What a program of this content, in place of delcert-check, says of "-odd name.json".
CheckerRun run_of(const std::string& script) {
  const TemporaryFolder folder;
  std::ofstream(folder / "checker") << "#!/bin/sh\n" << script << "\n";
  fs::permissions(folder / "checker", fs::perms::owner_all);
  return run_checker_on(folder / "checker", "-odd name.json");
}

TEST(CheckerProcess, tells_what_was_printed_and_the_status) {
  const CheckerRun run = run_of("echo \"$1 $2 $3\"; exit 3");
  EXPECT_EQ(run.output, "--json -- -odd name.json\n");
  EXPECT_EQ(run.status, 3);
}

TEST(CheckerProcess, passes_other_arguments_on) {
  const TemporaryFolder folder;
  std::ofstream(folder / "checker") << "#!/bin/sh\necho \"$#: $1\"\n";
  fs::permissions(folder / "checker", fs::perms::owner_all);
  EXPECT_EQ(run_checker_with(folder / "checker", {"--version"}).output, "1: --version\n");
  EXPECT_EQ(run_checker_with(folder / "checker", {}).output, "0: \n");
}

TEST(CheckerProcess, reads_more_than_a_pipe_holds) {
  const CheckerRun run =
      run_of("i=0; while [ $i -lt 3000 ]; do echo 0123456789012345678901234567890123456789; i=$((i+1)); done");
  EXPECT_EQ(run.output.size(), 3000U * 41);
  EXPECT_EQ(run.status, 0);
}

TEST(CheckerProcess, tells_the_signal_that_ended_it) { EXPECT_EQ(run_of("kill -9 $$").status, 128 + 9); }

TEST(CheckerProcess, that_cannot_be_started_is_an_error) {
  EXPECT_THROW((void)run_checker_on("/no/such/program", "x"), std::system_error);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
