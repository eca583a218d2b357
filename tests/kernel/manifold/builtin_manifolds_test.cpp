#include "kernel/manifold/builtin_manifolds.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace delcert {
namespace DELCERT_THIS_FILE {

TEST(BuiltinManifolds, are_ordered_by_name_without_repetition) {
  const auto& manifolds = builtin_manifolds();
  ASSERT_FALSE(manifolds.empty());
  const auto not_before = [](const auto& a, const auto& b) { return a.name >= b.name; };
  EXPECT_EQ(std::adjacent_find(manifolds.begin(), manifolds.end(), not_before), manifolds.end());
}

TEST(BuiltinManifolds, hold_the_text_of_their_files) {
  const auto& manifolds = builtin_manifolds();
  const auto torus =
      std::find_if(manifolds.begin(), manifolds.end(), [](const auto& manifold) { return manifold.name == "torus-2"; });
  ASSERT_NE(torus, manifolds.end());
  EXPECT_EQ(torus->text,
            "# The square torus ℝ²/ℤ².\nname = \"torus-2\"\nfamily = \"flat-torus\"\ndimension = 2\n"
            "gram = [[\"1\", \"0\"],\n        [\"0\", \"1\"]]\n");
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
