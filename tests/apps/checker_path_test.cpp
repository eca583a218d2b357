#include "apps/checker_path.hpp"

#include <gtest/gtest.h>
#include <stdlib.h>

#include <fstream>
#include <string>

namespace delcert {
namespace {

namespace fs = std::filesystem;

TEST(CheckerPath, is_beside_the_program_then_in_the_build_tree_then_in_the_search_path) {
  const std::vector<fs::path> expected{"/build/apps/delcert-check", "/build/proofs/checker/delcert-check",
                                       "/usr/bin/delcert-check", "/bin/delcert-check"};
  EXPECT_EQ(checker_candidates("/build/apps/delcert", "/usr/bin::/bin"), expected);
  EXPECT_EQ(checker_candidates("/build/apps/delcert", "").size(), 2U);
}

TEST(CheckerPath, is_the_first_that_can_be_executed) {
  std::string name = (fs::temp_directory_path() / "delcert-checker-path-XXXXXX").string();
  ASSERT_NE(mkdtemp(name.data()), nullptr);
  const fs::path folder = name;
  const fs::path plain = folder / "plain";
  const fs::path executable = folder / "executable";
  std::ofstream(plain) << "";
  std::ofstream(executable) << "";
  fs::permissions(executable, fs::perms::owner_all);
  EXPECT_EQ(first_executable({folder / "missing", folder, plain, executable}), executable);
  EXPECT_EQ(first_executable({folder / "missing", folder, plain}), fs::path());
  fs::remove_all(folder);
}

}  // namespace
}  // namespace delcert
