#include "kernel/manifold/submanifold/singular_search.hpp"

#include "tests/kernel/manifold/submanifold/samples.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

/// All coordinates of the part are within this of these.
void expect_near(const std::optional<BoxPart>& part, const std::vector<double>& place, double distance) {
  ASSERT_TRUE(part);
  for (std::size_t axis = 0; axis < place.size(); ++axis) {
    EXPECT_LT(part->lower[axis], place[axis] + distance);
    EXPECT_GT(part->upper[axis], place[axis] - distance);
  }
}

TEST(SingularSearch, finds_none_on_manifolds) {
  for (const ZeroSet& manifold : {unit_sphere_in_space(), torus_of_revolution(), two_spheres(), clifford_torus()})
    EXPECT_FALSE(find_singular_part(manifold));
}

TEST(SingularSearch, finds_the_apex_of_a_cone) { expect_near(find_singular_part(cone()), {0, 0, 0}, 0.001); }

TEST(SingularSearch, finds_where_spheres_touch) {
  const ZeroSet touching =
      zero_set("touching", {"x", "y", "z"}, {"((x - 1/2)^2 + y^2 + z^2 - 1/4)*((x + 1/2)^2 + y^2 + z^2 - 1/4)"},
               {Rational(2), Rational(2), Rational(2)});
  expect_near(find_singular_part(touching), {0, 0, 0}, 0.01);
  // And not where there is a gap.
  const ZeroSet apart =
      zero_set("apart", {"x", "y", "z"}, {"((x - 11/20)^2 + y^2 + z^2 - 1/4)*((x + 11/20)^2 + y^2 + z^2 - 1/4)"},
               {Rational(2), Rational(2), Rational(2)});
  EXPECT_FALSE(find_singular_part(apart));
}

TEST(SingularSearch, finds_where_equations_depend_on_each_other) {
  const ZeroSet twice =
      zero_set("twice", {"x", "y", "z", "w"}, {"x^2 + y^2 + z^2 + w^2 - 1", "2*(x^2 + y^2 + z^2 + w^2) - 2"},
               std::vector<Rational>(4, Rational(2)));
  EXPECT_TRUE(find_singular_part(twice));
  EXPECT_FALSE(find_singular_part(twice, 100));
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
