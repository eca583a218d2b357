#include "proofs/checker/geometry/simplex.hpp"

#include <gtest/gtest.h>

#include <random>

#include "proofs/checker/arithmetic/exact_number.hpp"
#include "tests/checker/support/exact_double.hpp"
#include "tests/checker/upwards.hpp"

namespace delcert::checker_tests {
namespace {

using namespace checker;

template <class N>
Vector<N> vector_of(std::initializer_list<int> entries) {
  Vector<N> x{};
  std::size_t k = 0;
  for (const int entry : entries) x[k++] = N(entry);
  return x;
}

class Simplices : public testing::Test {
 protected:
  const test::Upwards upwards;
  Metric plane_{2, {}}, space_{3, {}}, hexagonal_{2, {Rational(2), Rational(-1), Rational(-1), Rational(2)}};
};

TEST_F(Simplices, of_known_shapes_have_their_known_circumcentres) {
  const Simplex<Rational> right(
      plane_, {vector_of<Rational>({1, 1}), vector_of<Rational>({4, 1}), vector_of<Rational>({1, 5})});
  ASSERT_EQ(right.complete, Verdict::proved);
  EXPECT_EQ(right.radius_squared, Rational(25) / Rational(4));
  EXPECT_EQ(right.centre[0], Rational(3) / Rational(2));
  EXPECT_EQ(right.centre[1], Rational(2));
  EXPECT_EQ(right.power(vector_of<Rational>({3, 4})), Rational(0)) << "the fourth corner of the rectangle";

  const Simplex<Rational> triangle(
      space_, {vector_of<Rational>({1, 0, 0}), vector_of<Rational>({0, 1, 0}), vector_of<Rational>({0, 0, 1})});
  EXPECT_EQ(triangle.radius_squared, Rational(2) / Rational(3));
  const Vector<Rational> normal = triangle.perpendicular(vector_of<Rational>({-1, 0, 0}));  // towards the origin
  EXPECT_EQ(space_.squared_length(normal), Rational(1) / Rational(3));

  // In the hexagonal metric the triangle of the two basis vectors' sum is equilateral with side sqrt(2).
  const Simplex<Rational> equilateral(
      hexagonal_, {vector_of<Rational>({0, 0}), vector_of<Rational>({1, 0}), vector_of<Rational>({1, 1})});
  EXPECT_EQ(equilateral.radius_squared, Rational(2) / Rational(3));
}

TEST_F(Simplices, that_are_degenerate_are_refuted_exactly_and_undecided_in_the_filter) {
  const auto flat = [&]<class N>(In<N>) {
    const N third = N(1) / N(3);
    Vector<N> a{}, b{}, c{};
    b[0] = third;
    b[1] = third * third;
    c[0] = third + third;
    c[1] = b[1] + b[1];
    return Simplex<N>(plane_, {a, b, c}).complete;
  };
  EXPECT_EQ(flat(In<Rational>{}), Verdict::refuted);
  EXPECT_EQ(flat(In<Interval>{}), Verdict::undecided);
  EXPECT_EQ(Simplex<Rational>(plane_, {vector_of<Rational>({1, 2}), vector_of<Rational>({1, 2})}).complete,
            Verdict::refuted);
}

TEST_F(Simplices, thickness_of_known_shapes_is_decided_at_its_exact_value) {
  // Right triangle with legs 3 and 4: altitude 12/5, longest edge 5, thickness 12/50.
  const std::vector<Vector<Rational>> right = {vector_of<Rational>({0, 0}), vector_of<Rational>({3, 0}),
                                               vector_of<Rational>({0, 4})};
  const Rational exact_thickness = exact_value("144/2500"), above = exact_thickness + exact_value("0x1p-200");
  EXPECT_EQ(is_thick(plane_, right, exact_thickness), Verdict::proved);
  EXPECT_EQ(is_thick(plane_, right, above), Verdict::refuted);
  const std::vector<Vector<Rational>> edge = {vector_of<Rational>({0, 0}), vector_of<Rational>({3, 1})};
  EXPECT_EQ(is_thick(plane_, edge, Rational(1)), Verdict::proved);
  EXPECT_EQ(is_thick(plane_, edge, exact_value("1000001/1000000")), Verdict::refuted);
}

TEST_F(Simplices, of_known_shapes_are_clear_of_points_beyond_the_protection_only) {
  // The circumcircle has the centre (3/2, 2) and the radius 5/2; the point is at 3 from the centre.
  const Simplex<Rational> right(
      plane_, {vector_of<Rational>({0, 0}), vector_of<Rational>({3, 0}), vector_of<Rational>({0, 4})});
  Vector<Rational> point{};
  point[0] = exact_value("9/2");
  point[1] = Rational(2);
  const Rational little = exact_value("0x1p-200");
  EXPECT_EQ(is_clear(right, point, exact_value("1/2")), Verdict::refuted);
  EXPECT_EQ(is_clear(right, point, exact_value("1/2") + little), Verdict::refuted);
  EXPECT_EQ(is_clear(right, point, exact_value("1/2") - little), Verdict::proved);
  EXPECT_EQ(is_clear(right, right.centre, little), Verdict::refuted);
}

TEST_F(Simplices, of_known_shapes_are_within_the_ball_that_their_own_touches) {
  const Rational quarter = exact_value("25/4"), little = exact_value("0x1p-200");
  EXPECT_EQ(is_ball_within(quarter, quarter, Rational(5)), Verdict::proved);
  EXPECT_EQ(is_ball_within(quarter, quarter, Rational(5) - little), Verdict::refuted);
  EXPECT_EQ(is_ball_within(quarter, quarter, Rational(1)), Verdict::refuted);
}

TEST_F(Simplices, of_random_points_have_all_vertices_on_the_sphere_and_filter_encloses_exact) {
  std::mt19937_64 random(1);
  for (int k = 0; k < 2000; ++k) {
    std::vector<Vector<Rational>> exact_corners;
    std::vector<Vector<Interval>> corners;
    const std::size_t size = 2 + random() % 3;
    for (std::size_t v = 0; v < size; ++v) {
      Vector<Rational> x{};
      Vector<Interval> y{};
      for (std::size_t a = 0; a < 3; ++a) {
        x[a] = Rational(static_cast<int>(random() % 2001) - 1000) / Rational(1 + static_cast<int>(random() % 1000));
        y[a] = enclosure(x[a]);
      }
      exact_corners.push_back(x);
      corners.push_back(y);
    }
    const Simplex<Rational> simplex(space_, exact_corners);
    const Simplex<Interval> filter(space_, corners);
    if (simplex.complete != Verdict::proved) continue;
    for (const Vector<Rational>& corner : exact_corners)
      EXPECT_EQ(simplex.power(corner - exact_corners[0]), Rational(0));
    EXPECT_EQ(simplex.radius_squared, space_.squared_length(simplex.centre));
    if (filter.complete != Verdict::proved) continue;
    EXPECT_TRUE(contains(filter.radius_squared, simplex.radius_squared));
    EXPECT_TRUE(contains(Simplex<Interval>(simplex).radius_squared, simplex.radius_squared));
    for (std::size_t a = 0; a < 3; ++a) EXPECT_TRUE(contains(filter.centre[a], simplex.centre[a]));
    const Vector<Rational> x = exact_corners[1] - exact_corners[0],
                           normal = simplex.perpendicular(vector_of<Rational>({1, 2, 3}));
    EXPECT_EQ(space_.product(x, normal), Rational(0));
  }
}

}  // namespace
}  // namespace delcert::checker_tests
