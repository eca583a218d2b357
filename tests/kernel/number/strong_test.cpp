#include "kernel/number/strong.hpp"

#include <gtest/gtest.h>

#include <set>
#include <type_traits>
#include <unordered_set>

namespace delcert {
namespace DELCERT_THIS_FILE {

template <class A, class B>
concept Addable = requires(A a, B b) {
  a + b;
};
template <class A, class B>
concept EqualityComparable = requires(A a, B b) {
  a == b;
};

static_assert(!Addable<Label, Label> && !Addable<Label, int>);
static_assert(!EqualityComparable<Label, Dimension> && !EqualityComparable<Label, int>);
static_assert(!std::is_convertible_v<int, Label> && !std::is_convertible_v<Label, int>);
static_assert(!std::is_constructible_v<Label, Dimension> && !std::is_constructible_v<Label, double>);
static_assert(std::is_trivially_copyable_v<Label> && sizeof(Label) == 4);

TEST(Strong, values_of_one_kind_are_ordered_like_their_integers) {
  EXPECT_LT(Label(2), Label(10));
  EXPECT_EQ(Label(7), Label(7U));
  EXPECT_LT(Dimension(-1), Dimension(0));
  EXPECT_EQ(Label().value, 0U);
  const std::set<Label> sorted = {Label(3), Label(1), Label(2)};
  EXPECT_EQ(sorted.begin()->value, 1U);
  EXPECT_EQ(sorted.rbegin()->value, 3U);
}

TEST(Strong, hashes_follow_equality) {
  const std::unordered_set<Label> labels = {Label(5), Label(5), Label(6)};
  EXPECT_EQ(labels.size(), 2U);
  EXPECT_TRUE(labels.contains(Label(6)));
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
