#include "kernel/stars/approximate_sphere.hpp"

#include "tests/kernel/manifold/exhaustive.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

template <int m>
void check_against_exact(const FlatSpace<m>& space) {
  const auto plain = space.metric.template on<PlainDouble>();
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    for (std::size_t count = 1; count <= m + 1; ++count) {
      const auto vertices = random_points<m>(count, seed, 10, Rational(-2), Rational(4));
      const auto ball = ball_of_simplex<m>(space, vertices);
      const auto sphere = approximate_sphere<m>(plain, approximate_all<m>(vertices));
      if (!ball || ball->squared_radius > Rational(100)) continue;
      EXPECT_NEAR(sphere.squared_radius, approximate_double(ball->squared_radius), 1e-6);
      for (std::size_t axis = 0; axis < m; ++axis) {
        EXPECT_NEAR(sphere.centre[axis], approximate_double(ball->centre[axis]), 1e-6);
      }
    }
  }
}

TEST(ApproximateSphere, is_near_the_diametric_sphere_for_every_number_of_vertices) {
  check_against_exact<1>(cubic_torus<1>());
  check_against_exact<2>(hexagonal_torus());
  check_against_exact<3>(skewed_torus());
  check_against_exact<3>(cubic_torus<3>());
  check_against_exact<4>(cubic_torus<4>());
}

TEST(ApproximateSphere, of_a_point_is_the_point) {
  const auto plain = cubic_torus<2>().metric.on<PlainDouble>();
  const auto sphere = approximate_sphere<2>(plain, std::vector<Vector<double, 2>>{{3, -4}});
  EXPECT_EQ(sphere.squared_radius, 0);
  EXPECT_EQ(sphere.centre, (Vector<double, 2>{3, -4}));
}

TEST(ApproximateSphere, of_a_degenerate_simplex_is_infinite) {
  const auto plain = cubic_torus<2>().metric.on<PlainDouble>();
  EXPECT_TRUE(
      std::isinf(approximate_sphere<2>(plain, std::vector<Vector<double, 2>>{{0, 0}, {1, 1}, {3, 3}}).squared_radius));
  EXPECT_TRUE(std::isinf(approximate_sphere<2>(plain, std::vector<Vector<double, 2>>{{1, 2}, {1, 2}}).squared_radius));
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
