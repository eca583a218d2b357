#include "proofs/certificate/byte_sink.hpp"

#include <gtest/gtest.h>

#include <cstdlib>

#include "kernel/error.hpp"
#include "tests/proofs/certificate/small_run.hpp"

namespace delcert {
namespace {

// The SHA-256 of "abc" is the first example of FIPS 180-4.
constexpr const char* digest_of_abc = "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad";

TEST(ByteSink, HashesWhatIsWrittenHoweverItIsCut) {
  const TemporaryFolder folder;
  ByteSink sink(folder / "x");
  sink.write("a");
  EXPECT_NE(sink.digest(), digest_of_abc);
  sink.write("");
  sink.write("bc");
  EXPECT_EQ(sink.digest(), digest_of_abc);
  EXPECT_EQ(sink.digest(), digest_of_abc);
}

TEST(ByteSink, WritesPlainBytes) {
  const TemporaryFolder folder;
  ByteSink sink(folder / "x.json");
  sink.write("one\n");
  sink.write("two\n");
  sink.commit();
  EXPECT_EQ(bytes_of(folder / "x.json"), "one\ntwo\n");
}

TEST(ByteSink, CompressesByTheNameAndHashesThePlainBytes) {
  const TemporaryFolder folder;
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

TEST(ByteSink, LeavesNothingBehindUnlessCommitted) {
  const TemporaryFolder folder;
  for (const char* name : {"x", "x.zst"}) {
    ByteSink sink(folder / name);
    sink.write("half of it");
  }
  EXPECT_TRUE(folder.is_empty());
}

TEST(ByteSink, RefusesAFolderThatDoesNotExist) {
  const TemporaryFolder folder;
  EXPECT_THROW(ByteSink(folder / "none/x"), InputError);
}

}  // namespace
}  // namespace delcert
