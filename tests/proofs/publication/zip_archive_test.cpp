#include "proofs/publication/zip_archive.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

namespace delcert {
namespace DELCERT_THIS_FILE {

TEST(ZipArchive, holds_the_files_as_they_are_in_their_order) {
  const std::string bytes = zip_archive({{"b/x.txt", "first file"}, {"a.txt", "second"}});
  EXPECT_EQ(bytes.rfind("PK\x03\x04", 0), 0U);
  const std::size_t first = bytes.find("b/x.txtfirst file");
  const std::size_t second = bytes.find("a.txtsecond");
  ASSERT_NE(first, std::string::npos);
  ASSERT_NE(second, std::string::npos);
  EXPECT_LT(first, second);
}

TEST(ZipArchive, is_the_same_for_the_same_files_only) {
  const std::vector<ArchiveFile> files{{"a", std::string(100000, 'x')}, {"b", ""}};
  EXPECT_EQ(zip_archive(files), zip_archive(files));
  EXPECT_NE(zip_archive(files), zip_archive({{"a", std::string(100000, 'y')}, {"b", ""}}));
}

TEST(ZipArchive, has_no_name_twice) {
  EXPECT_THROW((void)zip_archive({{"a", "1"}, {"a", "2"}}), std::invalid_argument);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
