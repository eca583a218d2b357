#include "proofs/certificate/file_text.hpp"

#include <gtest/gtest.h>

#include <fstream>

#include "proofs/certificate/byte_sink.hpp"
#include "support/error.hpp"
#include "tests/support/message_of.hpp"
#include "tests/support/temporary_folder.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

TEST(FileText, is_what_was_written_plain_or_compressed) {
  const TemporaryFolder folder;
  std::string text;
  for (int line = 0; line < 100000; ++line) text += std::to_string(line) + '\n';
  for (const char* name : {"text", "text.zst"}) {
    ByteSink sink(folder / name);
    sink.write(text);
    sink.commit();
    EXPECT_EQ(read_text(folder / name), text);
  }
  EXPECT_LT(std::filesystem::file_size(folder / "text.zst"), std::filesystem::file_size(folder / "text"));
}

TEST(FileText, of_a_file_that_ends_too_early_is_an_error) {
  const TemporaryFolder folder;
  ByteSink sink(folder / "text.zst");
  sink.write(std::string(1000, 'x'));
  sink.commit();
  std::filesystem::resize_file(folder / "text.zst", std::filesystem::file_size(folder / "text.zst") - 1);
  EXPECT_TRUE(mentions(message_of<InputError>([&] { (void)read_text(folder / "text.zst"); }), "ends too early"));
  EXPECT_TRUE(mentions(message_of<InputError>([&] { (void)read_text(folder / "none"); }), "none: cannot be opened"));
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
