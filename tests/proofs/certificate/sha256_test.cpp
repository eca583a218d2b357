#include "proofs/certificate/sha256.hpp"

#include <gtest/gtest.h>

namespace delcert {
namespace DELCERT_THIS_FILE {

// FIPS 180-4, the examples of the standard.
TEST(Sha256, IsThatOfTheStandard) {
  EXPECT_EQ(Sha256().digest(), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  Sha256 hash;
  hash.update("a");
  hash.update("bc");
  EXPECT_EQ(hash.digest(), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  hash.update("d");
  EXPECT_NE(hash.digest(), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
