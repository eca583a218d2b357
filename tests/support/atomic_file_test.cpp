#include "support/atomic_file.hpp"

#include <gtest/gtest.h>
#include <stdlib.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <system_error>

#include "support/error.hpp"
#include "tests/support/temporary_folder.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

namespace fs = std::filesystem;

class AtomicFileTest : public ::testing::Test {
 protected:
  [[nodiscard]] static std::string content_of(const fs::path& path) {
    std::ifstream stream(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
  }
  [[nodiscard]] std::ptrdiff_t files_in_folder() const {
    return std::distance(fs::directory_iterator(folder.path()), fs::directory_iterator());
  }

  test::TemporaryFolder folder;
};

TEST_F(AtomicFileTest, appears_when_committed_and_not_before) {
  const fs::path path = folder / "result";
  {
    AtomicFile file(path);
    file.write("first ");
    file.write("second");
    EXPECT_FALSE(fs::exists(path));
    file.commit();
    EXPECT_TRUE(fs::exists(path));
  }
  EXPECT_EQ(content_of(path), "first second");
  EXPECT_EQ(files_in_folder(), 1);
}

TEST_F(AtomicFileTest, leaves_nothing_behind_when_not_committed) {
  {
    AtomicFile file(folder / "result");
    file.write("half");
  }
  EXPECT_EQ(files_in_folder(), 0);
}

TEST_F(AtomicFileTest, keeps_the_old_file_until_the_new_one_is_whole) {
  const fs::path path = folder / "result";
  write_file_atomically(path, "old");
  {
    AtomicFile file(path);
    file.write("new");
    EXPECT_EQ(content_of(path), "old");
  }
  EXPECT_EQ(content_of(path), "old");
  write_file_atomically(path, "new");
  EXPECT_EQ(content_of(path), "new");
}

TEST_F(AtomicFileTest, keeps_every_byte) {
  const std::string bytes("zero\0and\xffhigh\r\n", 15);
  write_file_atomically(folder / "result", bytes);
  EXPECT_EQ(content_of(folder / "result"), bytes);
}

TEST_F(AtomicFileTest, has_the_permissions_of_an_ordinary_file) {
  write_file_atomically(folder / "result", "");
  std::ofstream(folder / "ordinary") << "";
  EXPECT_EQ(fs::status(folder / "result").permissions(), fs::status(folder / "ordinary").permissions());
}

TEST_F(AtomicFileTest, names_the_path_that_cannot_be_written) {
  const fs::path missing = folder / "no-such-folder/result";
  try {
    const AtomicFile file(missing);
    FAIL() << "created " << missing;
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find(missing.string()), std::string::npos) << error.what();
    EXPECT_NE(std::string(error.what()).find("No such file or directory"), std::string::npos) << error.what();
  }
  EXPECT_THROW(AtomicFile{folder.path()}, InputError);
  EXPECT_THROW(AtomicFile{fs::path(folder.path().string() + "/")}, InputError);
  EXPECT_EQ(files_in_folder(), 0);
}

TEST_F(AtomicFileTest, reports_a_failing_rename_and_removes_the_temporary_file) {
  const fs::path path = folder / "result";
  {
    AtomicFile file(path);
    file.write("bytes");
    fs::create_directory(path);
    EXPECT_THROW(file.commit(), std::system_error);
  }
  EXPECT_EQ(files_in_folder(), 1);
  EXPECT_TRUE(fs::is_directory(path));
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
