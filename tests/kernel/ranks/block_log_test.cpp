#include "kernel/ranks/block_log.hpp"

#include <gtest/gtest.h>

#include "support/error.hpp"
#include "tests/support/temporary_folder.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

TEST(BlockLogs, have_the_pieces_that_were_written_to_their_ends) {
  const TemporaryFolder folder;
  const auto path = folder / "log";
  {
    BlockLog log(path, "this run");
    EXPECT_TRUE(log.pieces().empty());
    log.add("one");
    log.add("");
    log.add("three");
  }
  const auto size = std::filesystem::file_size(path);
  // However much of the last piece is missing, it is not there, and another one takes its place.
  for (std::uintmax_t cut = 0; cut < 21; ++cut) {
    std::filesystem::resize_file(path, size - cut);
    BlockLog log(path, "this run");
    ASSERT_EQ(log.pieces().size(), cut == 0 ? 3U : 2U) << cut;
    EXPECT_EQ(log.pieces()[0], "one");
    EXPECT_EQ(log.pieces()[1], "");
    log.keep(2);
    log.add("three");
  }
  BlockLog log(path, "this run");
  EXPECT_EQ(log.pieces(), (std::vector<Message>{"one", "", "three"}));
  log.keep(1);
  log.add("other");
  EXPECT_EQ(BlockLog(path, "this run").pieces(), (std::vector<Message>{"one", "other"}));
}

TEST(BlockLogs, of_another_run_or_with_an_altered_byte_are_noticed) {
  const TemporaryFolder folder;
  const auto path = folder / "log";
  BlockLog(path, "this run").add("a piece");
  EXPECT_THROW(BlockLog(path, "another run"), InputError);
  {
    std::fstream file(path, std::ios::binary | std::ios::in | std::ios::out);
    file.seekp(-10, std::ios::end);
    file.put('A');
  }
  EXPECT_TRUE(BlockLog(path, "this run").pieces().empty());
  // Cut off within what it is of: as if it were new.
  std::filesystem::resize_file(path, 5);
  EXPECT_TRUE(BlockLog(path, "another run").pieces().empty());
  EXPECT_THROW(BlockLog(folder / "no folder/log", "this run"), InputError);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
