#include "proofs/checker/certificate/input.hpp"

#include <gtest/gtest.h>

namespace delcert::checker_tests {
namespace {

TEST(InputOfChecker, digests_of_a_text_and_of_its_beginning_are_those_of_each) {
  EXPECT_EQ(checker::sha256("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  const std::string text(200, 'x');
  for (const std::size_t length : {0U, 1U, 55U, 64U, 65U, 128U, 200U}) {
    checker::DigestOfBeginning beginning;
    EXPECT_EQ(checker::sha256(text, length, beginning), checker::sha256(text));
    EXPECT_EQ(beginning.length, length);
    EXPECT_EQ(beginning.digest, checker::sha256(text.substr(0, length)));
  }
}

}  // namespace
}  // namespace delcert::checker_tests
