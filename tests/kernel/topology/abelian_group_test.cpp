#include "kernel/topology/abelian_group.hpp"

#include <gtest/gtest.h>

namespace delcert::test {
namespace {

TEST(AbelianGroup, has_one_text) {
  EXPECT_EQ(group_text(AbelianGroup{}), "0");
  EXPECT_EQ(group_text({1, {}}), "Z");
  EXPECT_EQ(group_text({4, {}}), "Z^4");
  EXPECT_EQ(group_text({0, {7}}), "Z/7");
  EXPECT_EQ(group_text({1, {2}}), "Z + Z/2");
  EXPECT_EQ(group_text({0, {5, 5, 5}}), "(Z/5)^3");
  EXPECT_EQ(group_text({2, {2, 4, 4}}), "Z^2 + Z/2 + (Z/4)^2");
  EXPECT_EQ(group_text({0, {Integer(1) << 100}}), "Z/1267650600228229401496703205376");
}

TEST(AbelianGroup, is_equal_only_to_the_same_group) {
  EXPECT_EQ((AbelianGroup{1, {2, 4}}), (AbelianGroup{1, {2, 4}}));
  EXPECT_NE((AbelianGroup{1, {2, 4}}), (AbelianGroup{1, {8}}));
  EXPECT_NE((AbelianGroup{1, {2}}), (AbelianGroup{2, {2}}));
}

}  // namespace
}  // namespace delcert::test
