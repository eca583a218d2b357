#include "kernel/manifold/flat_space.hpp"

#include "kernel/manifold/any_manifold.hpp"
#include "kernel/manifold/builtin_manifolds.hpp"
#include "tests/kernel/manifold/exhaustive.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

TEST(FlatSpaceOf, a_torus_has_its_gram_matrix_and_no_radius) {
  const auto space = flat_space_of<3>(find_manifold("torus-3-bcc"));
  EXPECT_TRUE(space.is_torus());
  EXPECT_EQ(space.metric.gram(), bcc_torus().metric.gram());
  EXPECT_EQ(flat_space_of<3>(find_manifold("torus-3-skewed")).metric.gram(), skewed_torus().metric.gram());
}

TEST(FlatSpaceOf, a_ball_is_cartesian_with_its_radius) {
  const auto space = flat_space_of<2>(
      parse_manifold("name = \"b\"\nfamily = \"euclidean-ball\"\ndimension = 2\nradius = \"7/3\"\n", "here"));
  EXPECT_FALSE(space.is_torus());
  EXPECT_EQ(*space.ball_radius, ratio(7, 3));
  EXPECT_TRUE(space.metric.is_cartesian());
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
