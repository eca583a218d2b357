#include "kernel/manifold/space_form/abelian_group.hpp"

#include <gtest/gtest.h>

namespace delcert::test {
namespace {

std::string quotient(std::size_t generators, const std::vector<std::vector<std::int64_t>>& relations) {
  return name_of(abelian_group(generators, relations));
}

TEST(AbelianGroup, by_its_relations) {
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

}  // namespace
}  // namespace delcert::test
