#include "kernel/topology/abelian_group.hpp"

#include <gtest/gtest.h>

namespace delcert::test {
namespace DELCERT_THIS_FILE {

std::string quotient(std::size_t generators, const std::vector<std::vector<std::int64_t>>& relations) {
  return group_text(abelian_group(generators, relations));
}

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

TEST(AbelianGroup, is_told_from_other_texts) {
  for (const char* text : {"0", "Z", "Z^4", "Z + Z/2", "(Z/5)^3", "Z^2 + Z/2 + (Z/4)^2"})
    EXPECT_TRUE(is_group_text(text)) << text;
  for (const char* text : {"",      "1",    "Y",       "Z^1",       "Z^0",           "Z + Z",   "Z/1",
                           "Z/0",   "Z/02", "Z/2 + Z", "Z/4 + Z/2", "Z/2 + Z/3",     "(Z/2)^1", "Z/2 + Z/2",
                           "Z + 0", " Z",   "Z +Z/2",  "Z + ",      "Z^99999999999", "Z/2 + "})
    EXPECT_FALSE(is_group_text(text)) << text;
  EXPECT_FALSE(is_group_text(std::string(2000, 'Z')));
}

TEST(AbelianGroup, is_equal_only_to_the_same_group) {
  EXPECT_EQ((AbelianGroup{1, {2, 4}}), (AbelianGroup{1, {2, 4}}));
  EXPECT_NE((AbelianGroup{1, {2, 4}}), (AbelianGroup{1, {8}}));
  EXPECT_NE((AbelianGroup{1, {2}}), (AbelianGroup{2, {2}}));
}

TEST(AbelianGroup, is_given_by_relations) {
  EXPECT_EQ(quotient(0, {}), "0");
  EXPECT_EQ(quotient(3, {}), "Z^3");
  EXPECT_EQ(quotient(1, {{1}}), "0");
  EXPECT_EQ(quotient(1, {{6}, {4}}), "Z/2");
  EXPECT_EQ(quotient(2, {{2, 0}, {0, 3}}), "Z/6");
  EXPECT_EQ(quotient(2, {{2, 0}, {0, 2}}), "(Z/2)^2");
  EXPECT_EQ(quotient(3, {{2, 0, 0}, {0, 4, 0}}), "Z + Z/2 + Z/4");
  EXPECT_EQ(quotient(2, {{1, 1}}), "Z");
  EXPECT_EQ(quotient(2, {{4, 6}}), "Z + Z/2");
  EXPECT_EQ(quotient(2, {{0, 0}}), "Z^2");
}

TEST(AbelianGroup, does_not_depend_on_the_order_of_relations_or_generators) {
  EXPECT_EQ(quotient(3, {{2, 4, 4}, {-6, 6, 12}, {10, 4, 16}}), "(Z/2)^2 + Z/156");
  EXPECT_EQ(quotient(3, {{4, 10, 16}, {4, 2, 4}, {6, -6, 12}}), "(Z/2)^2 + Z/156");
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
