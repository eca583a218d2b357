#include "properties/attack/identity.hpp"

#include <gtest/gtest.h>

#include <set>

#include "tests/properties/attack/small_claims.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

TEST(Identity, changes_with_whatever_an_attack_depends_on) {
  const Claim claim = test::right_claim();
  std::set<std::string> contents{contents_of(claim, {2, 2}), contents_of(claim, {2, 3}), contents_of(claim, {1, 2})};
  for (const Claim& changed : test::changes_of_right_claim()) contents.insert(contents_of(changed, {2, 2}));
  EXPECT_EQ(contents.size(), 10U);
  EXPECT_EQ(contents_of(claim, {2, 2}), contents_of(test::right_claim(), {2, 2}));
}

TEST(Identity, is_of_the_contents_and_the_seed) {
  EXPECT_EQ(identity_of("a", 1), identity_of("a", 1));
  EXPECT_NE(identity_of("a", 1), identity_of("b", 1));
  EXPECT_NE(identity_of("a", 1), identity_of("a", 2));
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
