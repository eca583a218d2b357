#include "kernel/manifold/submanifold/facet_tree.hpp"

#include <gtest/gtest.h>

#include <set>

#include "kernel/random/counter_random.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

TEST(FacetTree, finds_what_a_search_through_all_finds) {
  CounterRandom random(1, RandomPurpose::instances, 0, 0);
  std::vector<SpaceBox> boxes;
  for (int k = 0; k < 500; ++k) {
    SpaceBox& box = boxes.emplace_back();
    for (std::size_t axis = 0; axis < 3; ++axis) {
      box.lower[axis] = random.next_unit();
      box.upper[axis] = box.lower[axis] + 0.1 * random.next_unit();
    }
  }
  const FacetTree tree(boxes);
  std::size_t found_in_all = 0;
  std::size_t asked_in_all = 0;
  for (int query = 0; query < 100; ++query) {
    const std::array<double, 3> x{random.next_unit(), random.next_unit(), random.next_unit()};
    const auto contains = [&](const SpaceBox& box) {
      ++asked_in_all;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        if (x[axis] < box.lower[axis] || x[axis] > box.upper[axis]) return false;
      }
      return true;
    };
    std::set<std::uint32_t> found;
    tree.visit(contains, [&](std::uint32_t box) { EXPECT_TRUE(found.insert(box).second); });
    found_in_all += found.size();
    for (std::uint32_t box = 0; box < boxes.size(); ++box) {
      bool is_in = true;
      for (std::size_t axis = 0; axis < 3; ++axis)
        is_in = is_in && x[axis] >= boxes[box].lower[axis] && x[axis] <= boxes[box].upper[axis];
      EXPECT_EQ(found.contains(box), is_in);
    }
  }
  EXPECT_GE(found_in_all, 3U);
  // Not all boxes are looked at.
  EXPECT_LE(asked_in_all, 100U * 150);
}

TEST(FacetTree, of_nothing_has_nothing) {
  FacetTree({}).visit([](const SpaceBox&) { return true; }, [](std::uint32_t) { FAIL(); });
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
