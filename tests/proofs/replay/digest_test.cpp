#include "proofs/replay/digest.hpp"

#include <gtest/gtest.h>

#include "proofs/certificate/sha256.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

// FIPS 180-2, appendix B.
TEST(ReplayDigest, is_that_of_the_standard) {
  EXPECT_EQ(replay::sha256_of("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(replay::sha256_of(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
}

TEST(ReplayDigest, is_that_of_the_writer) {
  const std::string text(1000, '\n');
  Sha256 hash;
  hash.update(text);
  EXPECT_EQ(replay::sha256_of(text), hash.digest());
  EXPECT_NE(replay::sha256_of(text + " "), hash.digest());
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
