#include "proofs/certificate/byte_sink.hpp"

#include <gtest/gtest.h>
#include <zstd.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <random>

#include "support/error.hpp"
#include "tests/proofs/certificate/small_run.hpp"
#include "tests/support/temporary_folder.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

// The SHA-256 of "abc" is the first example of FIPS 180-4.
constexpr const char* digest_of_abc = "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad";

TEST(ByteSink, HashesWhatIsWrittenHoweverItIsCut) {
  const test::TemporaryFolder folder;
  ByteSink sink(folder / "x");
  sink.write("a");
  EXPECT_NE(sink.digest(), digest_of_abc);
  sink.write("");
  sink.write("bc");
  EXPECT_EQ(sink.digest(), digest_of_abc);
  EXPECT_EQ(sink.digest(), digest_of_abc);
}

TEST(ByteSink, WritesPlainBytes) {
  const test::TemporaryFolder folder;
  ByteSink sink(folder / "x.json");
  sink.write("one\n");
  sink.write("two\n");
  sink.commit();
  EXPECT_EQ(bytes_of(folder / "x.json"), "one\ntwo\n");
}

TEST(ByteSink, CompressesByTheNameAndHashesThePlainBytes) {
  const test::TemporaryFolder folder;
  const std::string text(1000000, 'q');
  ByteSink plain(folder / "x");
  ByteSink packed(folder / "x.zst");
  plain.write(text);
  packed.write(text);
  EXPECT_EQ(plain.digest(), packed.digest());
  packed.commit();
  const std::string bytes = bytes_of(folder / "x.zst");
  EXPECT_LT(bytes.size(), text.size() / 100);
  EXPECT_EQ(bytes.substr(0, 4), "\x28\xB5\x2F\xFD");
}

/// Bytes that compress a little, longer than every buffer.
std::string long_text() {
  std::mt19937_64 random(1);
  std::string result;
  while (result.size() < 1500000) result += std::to_string(random() % 100000) + ",";
  return result + std::string("\0\xff end", 6);
}

/// Fails if that is more than 2 MB.
std::string decompressed(const std::string& bytes) {
  std::string result(std::size_t{2} << 20U, '\0');
  const std::size_t size = ZSTD_decompress(result.data(), result.size(), bytes.data(), bytes.size());
  EXPECT_EQ(ZSTD_isError(size), 0U) << ZSTD_getErrorName(size);
  result.resize(ZSTD_isError(size) != 0 ? 0 : size);
  return result;
}

TEST(ByteSink, HasTheDigestOfSha256sum) {
  const test::TemporaryFolder folder;
  const std::string text = long_text();
  ByteSink sink(folder / "text");
  for (std::size_t at = 0; at < text.size(); at += 777) sink.write(std::string_view(text).substr(at, 777));
  sink.commit();
  EXPECT_EQ(bytes_of(folder / "text"), text);
  const std::string command = "sha256sum '" + (folder / "text").string() + "'";
  FILE* pipe = popen(command.c_str(), "r");
  ASSERT_NE(pipe, nullptr);
  std::array<char, 65> line{};
  EXPECT_EQ(std::fread(line.data(), 1, 64, pipe), 64U);
  EXPECT_EQ(pclose(pipe), 0);
  EXPECT_EQ(sink.digest(), line.data());
}

TEST(ByteSink, CompressesToOneFrameOfTheSameBytes) {
  const test::TemporaryFolder folder;
  const std::string text = long_text();
  ByteSink sink(folder / "text.zst");
  for (std::size_t at = 0; at < text.size(); at += 300001) sink.write(std::string_view(text).substr(at, 300001));
  sink.commit();
  const std::string bytes = bytes_of(folder / "text.zst");
  EXPECT_EQ(decompressed(bytes), text);
  EXPECT_EQ(ZSTD_findFrameCompressedSize(bytes.data(), bytes.size()), bytes.size());
  ByteSink empty(folder / "empty.zst");
  empty.commit();
  EXPECT_FALSE(bytes_of(folder / "empty.zst").empty());
  EXPECT_EQ(decompressed(bytes_of(folder / "empty.zst")), "");
}

TEST(ByteSink, LeavesNothingBehindUnlessCommitted) {
  const test::TemporaryFolder folder;
  for (const char* name : {"x", "x.zst"}) {
    ByteSink sink(folder / name);
    sink.write(long_text());
  }
  EXPECT_TRUE(folder.is_empty());
}

TEST(ByteSink, RefusesAFolderThatDoesNotExist) {
  const test::TemporaryFolder folder;
  EXPECT_THROW(ByteSink(folder / "none/x"), InputError);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
