#include "kernel/sample/lattice_net.hpp"

#include <set>

#include "support/error.hpp"
#include "tests/kernel/manifold/exhaustive.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

template <int m>
std::set<Vector<Rational, m>> as_set(const ExactPoints<m>& points) {
  return {points.begin(), points.end()};
}

LatticeNet lattice_of(std::uint32_t divisions, bool centred = false) {
  LatticeNet lattice;
  lattice.divisions = divisions;
  lattice.centred = centred;
  return lattice;
}

TEST(LatticeNet, of_a_torus_is_the_multiples_in_the_unit_cell) {
  const auto points = lattice_net<2>(hexagonal_torus(), lattice_of(7));
  std::set<Vector<Rational, 2>> expected;
  for (long a = 0; a < 7; ++a) {
    for (long b = 0; b < 7; ++b) expected.insert({ratio(a, 7), ratio(b, 7)});
  }
  EXPECT_EQ(points.size(), 49U);
  EXPECT_EQ(as_set<2>(points), expected);
}

TEST(LatticeNet, has_the_centres_of_the_cells_too_when_asked) {
  const auto points = lattice_net<3>(cubic_torus<3>(), lattice_of(3, true));
  std::set<Vector<Rational, 3>> expected;
  for (long a = 0; a < 3; ++a) {
    for (long b = 0; b < 3; ++b) {
      for (long c = 0; c < 3; ++c) {
        expected.insert({ratio(a, 3), ratio(b, 3), ratio(c, 3)});
        expected.insert({ratio(2 * a + 1, 6), ratio(2 * b + 1, 6), ratio(2 * c + 1, 6)});
      }
    }
  }
  EXPECT_EQ(points.size(), 54U);
  EXPECT_EQ(as_set<3>(points), expected);
}

TEST(LatticeNet, has_the_right_number_of_points_in_every_dimension) {
  EXPECT_EQ(lattice_net<1>(cubic_torus<1>(), lattice_of(100)).size(), 100U);
  EXPECT_EQ(lattice_net<1>(cubic_torus<1>(), lattice_of(1)).size(), 1U);
  EXPECT_EQ(lattice_net<4>(cubic_torus<4>(), lattice_of(5)).size(), 625U);
  EXPECT_EQ(lattice_net<4>(cubic_torus<4>(), lattice_of(5, true)).size(), 1250U);
}

TEST(LatticeNet, of_a_ball_fills_the_cube_about_it_with_four_cells_to_spare) {
  // Radius 6/5 at a third: 18/5 cells, rounded up, and 4 more.
  const auto points = lattice_net<2>(ball_of<2>(ratio(6, 5)), lattice_of(3));
  std::set<Vector<Rational, 2>> expected;
  for (long a = -8; a <= 8; ++a) {
    for (long b = -8; b <= 8; ++b) expected.insert({ratio(a, 3), ratio(b, 3)});
  }
  EXPECT_EQ(as_set<2>(points), expected);
  EXPECT_EQ(points.size(), expected.size());
  EXPECT_EQ(lattice_net<3>(ball_of<3>(Rational(1)), lattice_of(1, true)).size(), 2U * 11 * 11 * 11);
}

TEST(LatticeNet, is_displaced_by_the_same_step_up_or_down_in_every_coordinate) {
  LatticeNet displaced = lattice_of(6, true);
  displaced.displacement_exponent = 60;
  displaced.seed = 4;
  const auto points = lattice_net<2>(cubic_torus<2>(), displaced);
  const Rational step = Rational::power_of_two(-60);
  std::set<Vector<Rational, 2>> nearest;
  std::array<int, 4> signs{};
  for (const auto& point : points) {
    Vector<Rational, 2> lattice_point;
    std::size_t pattern = 0;
    for (std::size_t axis = 0; axis < 2; ++axis) {
      lattice_point[axis] = Rational(floor_of(point[axis] * Rational(12) + ratio(1, 2))) / Rational(12);
      const Rational offset = point[axis] - lattice_point[axis];
      EXPECT_EQ(absolute(offset), step);
      pattern = 2 * pattern + (offset > Rational(0) ? 1 : 0);
    }
    ++signs[pattern];
    nearest.insert(lattice_point);
  }
  EXPECT_EQ(nearest, as_set<2>(lattice_net<2>(cubic_torus<2>(), lattice_of(6, true))));
  for (const int count : signs) EXPECT_GT(count, 5);

  EXPECT_EQ(lattice_net<2>(cubic_torus<2>(), displaced), points);
  displaced.seed = 5;
  EXPECT_NE(as_set<2>(lattice_net<2>(cubic_torus<2>(), displaced)), as_set<2>(points));
}

TEST(LatticeNet, is_ordered_along_a_curve_that_stays_near) {
  const auto points = lattice_net<2>(cubic_torus<2>(), lattice_of(16));
  double longest = 0;
  double total = 0;
  for (std::size_t at = 1; at < points.size(); ++at) {
    const auto step = approximate<2>(difference(points[at], points[at - 1]));
    longest = std::max(longest, std::sqrt(pairing(step, step)));
    total += std::sqrt(pairing(step, step));
  }
  EXPECT_LT(total / static_cast<double>(points.size()), 2.0 / 16);
  EXPECT_LT(longest, 1.2);
}

TEST(LatticeNet, refuses_none_and_too_many) {
  const auto refusal = [](std::uint32_t divisions, bool centred) {
    return message_of<InputError>([&] { (void)lattice_net<3>(cubic_torus<3>(), lattice_of(divisions, centred)); });
  };
  EXPECT_TRUE(mentions(refusal(0, false), "at least one"));
  EXPECT_TRUE(mentions(refusal(159, false), "4000000"));
  EXPECT_TRUE(mentions(refusal(126, true), "4000000"));
  EXPECT_TRUE(mentions(refusal(4294967295, true), "4000000"));
  EXPECT_THROW((void)lattice_net<2>(ball_of<2>(Rational(1000)), lattice_of(1000)), InputError);
}

// Defect: a displacement of 2^-2000000000 took all memory.
TEST(LatticeNet, refuses_displacements_that_are_too_fine) {
  LatticeNet displaced = lattice_of(2);
  displaced.displacement_exponent = 1024;
  EXPECT_EQ(lattice_net<2>(cubic_torus<2>(), displaced).size(), 4U);
  displaced.displacement_exponent = 1025;
  const auto refusal = message_of<InputError>([&] { (void)lattice_net<2>(cubic_torus<2>(), displaced); });
  EXPECT_TRUE(mentions(refusal, "2^-1025: at most 2^-1024"));
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
