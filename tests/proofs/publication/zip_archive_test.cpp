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

TEST(ZipArchive, states_the_checksum_of_a_file_twice_and_ends_with_the_directory) {
  // The CRC-32 of these nine digits is known: 0xcbf43926.
  const std::string bytes = zip_archive({{"digits", "123456789"}});
  const std::string checksum = "\x26\x39\xf4\xcb";
  EXPECT_EQ(bytes.find(checksum), 14U);
  EXPECT_EQ(bytes.rfind(checksum), 30 + 6 + 9 + 16U);
  EXPECT_EQ(bytes.rfind("PK\x05\x06"), bytes.size() - 22);
}

TEST(ZipArchive, of_nothing_is_an_empty_directory) { EXPECT_EQ(zip_archive({}), "PK\x05\x06" + std::string(18, '\0')); }

TEST(ZipArchive, says_of_a_name_that_is_not_ascii_that_it_is_utf_8) {
  EXPECT_EQ(zip_archive({{"plain", ""}})[7], '\0');
  EXPECT_EQ(zip_archive({{"Poincar\u00e9", ""}})[7], '\x08');
}

TEST(ZipArchive, refuses_what_the_format_cannot_hold) {
  EXPECT_THROW((void)zip_archive({{std::string(65535, 'n'), ""}}), std::length_error);
  EXPECT_EQ(zip_archive({{std::string(65534, 'n'), ""}}).size(), 30 + 46 + 2 * 65534 + 22U);
}

TEST(ZipArchive, has_no_name_twice) {
  EXPECT_THROW((void)zip_archive({{"a", "1"}, {"a", "2"}}), std::invalid_argument);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
