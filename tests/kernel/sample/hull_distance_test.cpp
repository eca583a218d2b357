#include "kernel/sample/hull_distance.hpp"

#include "tests/kernel/manifold/exhaustive.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

/// The squared distance of the origin from the hull, by descent over faces: the nearest point of an affinely
/// independent face counts if its barycentric coordinates are not negative. Cramer on the Gram matrix.
template <int m>
Rational squared_hull_distance(const ExactPoints<m>& points) {
  Rational best = pairing(points[0], points[0]);
  for (std::size_t mask = 1; mask < (std::size_t{1} << points.size()); ++mask) {
    ExactPoints<m> face;
    for (std::size_t i = 0; i < points.size(); ++i) {
      if ((mask >> i & 1U) != 0) face.push_back(points[i]);
    }
    const auto simplex = simplex_in<m>(cubic_torus<m>(), face);
    const GramElimination<Rational> elimination(simplex.gram());
    if (!is_proved(elimination.definite())) continue;
    // Minimise |v0 + Σ λ_i e_i|²: Gλ = −⟨e_i, v0⟩.
    std::vector<Rational> right_side;
    for (std::size_t i = 1; i < face.size(); ++i) {
      right_side.push_back(-pairing(difference(face[i], face[0]), face[0]));
    }
    const auto solution = elimination.solve(right_side);
    Rational first(1);
    auto nearest = face[0];
    bool inside = true;
    for (std::size_t i = 1; i < face.size(); ++i) {
      const Rational& weight = solution->x[i - 1];
      first -= weight;
      inside = inside && weight >= Rational(0);
      nearest = sum(nearest, scaled(weight, difference(face[i], face[0])));
    }
    if (inside && first >= Rational(0)) best = minimum(best, pairing(nearest, nearest));
  }
  return best;
}

template <int m>
void check_random() {
  std::mt19937_64 random(5);
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    const auto count = static_cast<std::size_t>(1 + random() % m);
    auto points = random_points<m>(count, seed, 4, Rational(-2), Rational(4));
    // Sometimes flat, sometimes on one side.
    if (count >= 2 && seed % 5 == 0) points[1] = points[0];
    if (count >= 3 && seed % 7 == 0) points[2] = scaled(ratio(1, 2), sum(points[0], points[1]));
    if (seed % 2 == 0) {
      for (auto& point : points) point[0] += Rational(3);
    }
    const Rational squared = squared_hull_distance<m>(points);
    const Rational below = square_root_lower(squared, 40);
    EXPECT_TRUE(hull_is_outside_ball<m>(points, below));
    EXPECT_FALSE(hull_is_outside_ball<m>(points, square_root_upper(squared, 40) + Rational::power_of_two(-40)));
  }
}

TEST(HullIsOutsideBall, agrees_with_the_distance_of_the_hull) {
  check_random<1>();
  check_random<2>();
  check_random<3>();
  check_random<4>();
}

TEST(HullIsOutsideBall, decides_a_touching_hull_exactly) {
  // The segment from (5/3, 0) to (0, 5/4) touches the unit ball at (3/5, 4/5).
  const ExactPoints<2> tangent{{ratio(5, 3), Rational(0)}, {Rational(0), ratio(5, 4)}};
  const Rational hair = Rational::power_of_two(-200);
  EXPECT_TRUE(hull_is_outside_ball<2>(tangent, Rational(1)));
  EXPECT_FALSE(hull_is_outside_ball<2>(tangent, Rational(1) + hair));
  EXPECT_TRUE(hull_is_outside_ball<2>({{ratio(5, 3) + hair, Rational(0)}, {Rational(0), ratio(5, 4)}}, Rational(1)));
  EXPECT_FALSE(hull_is_outside_ball<2>({{ratio(5, 3) - hair, Rational(0)}, {Rational(0), ratio(5, 4)}}, Rational(1)));
}

TEST(HullIsOutsideBall, looks_at_the_hull_and_not_at_its_points_or_its_plane) {
  // Far points, but the segment passes through the origin.
  EXPECT_FALSE(hull_is_outside_ball<2>({{Rational(5), Rational(0)}, {Rational(-5), Rational(0)}}, ratio(1, 100)));
  // The line passes through the origin, the segment does not come near.
  EXPECT_TRUE(hull_is_outside_ball<2>({{Rational(5), Rational(0)}, {Rational(3), Rational(0)}}, Rational(3)));
  // A triangle whose plane is far, and one whose plane is near but which is not.
  EXPECT_TRUE(hull_is_outside_ball<3>({{Rational(1), Rational(1), Rational(2)},
                                       {Rational(-1), Rational(1), Rational(2)},
                                       {Rational(0), Rational(-1), Rational(2)}},
                                      Rational(2)));
  EXPECT_TRUE(hull_is_outside_ball<3>({{Rational(4), Rational(1), Rational(0)},
                                       {Rational(4), Rational(-1), Rational(0)},
                                       {Rational(5), Rational(0), Rational(0)}},
                                      Rational(4)));
}

TEST(HullIsOutsideBall, is_true_of_every_hull_for_radius_0) {
  EXPECT_TRUE(hull_is_outside_ball<2>({{Rational(5), Rational(0)}, {Rational(-5), Rational(0)}}, Rational(0)));
  EXPECT_TRUE(hull_is_outside_ball<1>({{Rational(0)}}, Rational(0)));
  EXPECT_FALSE(hull_is_outside_ball<1>({{Rational(0)}}, Rational::power_of_two(-100)));
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
