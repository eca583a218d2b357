#include "kernel/manifold/manifold_list.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace delcert::test {
namespace DELCERT_THIS_FILE {

TEST(ManifoldList, has_a_name_a_dimension_and_a_sentence_for_each) {
  std::set<std::string> names, kinds;
  for (const ListedManifold& one : builtin_manifold_list()) {
    EXPECT_TRUE(names.insert(one.name).second) << one.name << " stands twice";
    EXPECT_FALSE(one.about.empty()) << one.name;
    EXPECT_GE(one.dimension, 1) << one.name;
    EXPECT_LE(one.dimension, 4) << one.name;
    kinds.insert(one.kind);
  }
  EXPECT_GE(names.size(), 50U);
  EXPECT_EQ(kinds, (std::set<std::string>{"flat", "space form", "metric field", "atlas", "submanifold"}));
}

TEST(ManifoldList, knows_dimensions) {
  const auto list = builtin_manifold_list();
  const auto dimension = [&](const std::string& name) {
    return std::find_if(list.begin(), list.end(), [&](const auto& one) { return one.name == name; })->dimension;
  };
  EXPECT_EQ(dimension("torus-4"), 4);
  EXPECT_EQ(dimension("poincare-sphere"), 3);
  EXPECT_EQ(dimension("clifford-torus"), 2);
  EXPECT_EQ(dimension("sphere-3-stereographic"), 3);
}

TEST(ManifoldList, takes_the_first_sentence) {
  EXPECT_EQ(first_sentence("# A circle. And more.\nname = \"x\"\n"), "A circle");
  EXPECT_EQ(first_sentence("# A circle\n# of length 1.\nname = \"x\"\n# Not this."), "A circle of length 1");
  EXPECT_EQ(first_sentence("name = \"x\"\n# Too late.\n"), "");
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
