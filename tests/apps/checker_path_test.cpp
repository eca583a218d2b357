#include "apps/checker_path.hpp"

#include <gtest/gtest.h>
#include <stdlib.h>

#include <fstream>
#include <string>

#include "tests/support/temporary_folder.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

namespace fs = std::filesystem;

TEST(CheckerPath, is_beside_the_program_then_in_the_build_tree_then_in_the_search_path) {
  const std::vector<fs::path> expected{"/build/apps/delcert-check", "/build/proofs/checker/delcert-check",
                                       "/usr/bin/delcert-check", "/bin/delcert-check"};
  EXPECT_EQ(checker_candidates("/build/apps/delcert", "/usr/bin::/bin"), expected);
  EXPECT_EQ(checker_candidates("/build/apps/delcert", "").size(), 2U);
}

TEST(CheckerPath, is_the_first_that_can_be_executed) {
  const test::TemporaryFolder folder;
  const fs::path plain = folder / "plain";
  const fs::path executable = folder / "executable";
  std::ofstream(plain) << "";
  std::ofstream(executable) << "";
  fs::permissions(executable, fs::perms::owner_all);
  EXPECT_EQ(first_executable({folder / "missing", folder.path(), plain, executable}), executable);
  EXPECT_EQ(first_executable({folder / "missing", folder.path(), plain}), fs::path());
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
