#include "kernel/stars/approximate_delaunay.hpp"

#include "kernel/simplex/faces.hpp"
#include "tests/kernel/manifold/exhaustive.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

/// The determinant of a simplex of some of the points, in size.
template <int m>
Rational content(const ExactPoints<m>& points, const IndexSimplex<m>& simplex) {
  ExactPoints<m> vertices;
  for (const auto index : simplex) vertices.push_back(points[index]);
  return absolute(edge_determinant<m>(vertices));
}

/// All sets of m + 1 points whose open circumball holds no point.
template <int m>
std::vector<IndexSimplex<m>> empty_simplices(const ExactPoints<m>& points) {
  const auto space = ball_of<m>(Rational(1000));
  std::vector<IndexSimplex<m>> result;
  for (Faces faces(points.size(), m + 1); faces.has_face(); faces.advance()) {
    ExactPoints<m> vertices;
    IndexSimplex<m> simplex;
    for (std::size_t corner = 0; corner <= m; ++corner) {
      vertices.push_back(points[faces.vertices()[corner]]);
      simplex[corner] = static_cast<std::uint32_t>(faces.vertices()[corner]);
    }
    const auto ball = ball_of_simplex<m>(space, vertices);
    if (ball && is_empty<m>(space, points, *ball)) result.push_back(simplex);
  }
  std::sort(result.begin(), result.end());
  return result;
}

template <int m>
void check_random(std::size_t count, int trials) {
  for (int trial = 0; trial < trials; ++trial) {
    const auto points = random_points<m>(count, static_cast<std::uint64_t>(trial) + 1, 30, Rational(-1), Rational(2));
    const auto simplices = approximate_delaunay<m>(approximate_all<m>(points));
    EXPECT_FALSE(simplices.empty());
    EXPECT_EQ(simplices, empty_simplices<m>(points));
  }
}

TEST(ApproximateDelaunay, has_the_simplices_with_empty_balls) {
  check_random<1>(12, 10);
  check_random<2>(14, 10);
  check_random<3>(11, 5);
  check_random<4>(9, 5);
}

/// The grid {0 … side − 1}ᵐ: every cube is cospherical.
template <int m>
ExactPoints<m> cube_grid(std::int32_t side) {
  ExactPoints<m> points;
  Shift<m> last;
  last.fill(side - 1);
  for_each_shift<m>(Shift<m>{}, last,
                    [&](const Shift<m>& shift) { points.push_back(moved<m>(Vector<Rational, m>{}, shift)); });
  return points;
}

template <int m>
void check_degenerate(std::int32_t side) {
  const auto points = cube_grid<m>(side);
  const auto simplices = approximate_delaunay<m>(approximate_all<m>(points));
  Rational total(0);
  for (const auto& simplex : simplices) total += content<m>(points, simplex);
  EXPECT_EQ(total, Rational(factorial(m)) * power(Rational(side - 1), m));
}

TEST(ApproximateDelaunay, triangulates_cospherical_points_in_some_way) {
  check_degenerate<1>(5);
  check_degenerate<2>(4);
  check_degenerate<3>(3);
  check_degenerate<4>(3);
}

template <int m>
void check_order() {
  const auto simplices = approximate_delaunay<m>(approximate_all<m>(random_points<m>(15, 3)));
  EXPECT_TRUE(std::is_sorted(simplices.begin(), simplices.end()));
  for (const auto& simplex : simplices) EXPECT_TRUE(std::is_sorted(simplex.begin(), simplex.end()));
  EXPECT_EQ(std::adjacent_find(simplices.begin(), simplices.end()), simplices.end());
}

TEST(ApproximateDelaunay, is_sorted) {
  check_order<1>();
  check_order<2>();
  check_order<3>();
  check_order<4>();
}

/// A corner of a cube with one of its points given twice: one simplex, with one of the two.
template <int m>
void check_doubled_and_flat() {
  ExactPoints<m> corner{Vector<Rational, m>{}};
  for (std::size_t axis = 0; axis < m; ++axis) {
    corner.emplace_back();
    corner.back()[axis] = Rational(1);
  }
  EXPECT_EQ(approximate_delaunay<m>(approximate_all<m>(corner)).size(), 1U);
  corner.push_back(corner[1]);
  const auto simplices = approximate_delaunay<m>(approximate_all<m>(corner));
  ASSERT_EQ(simplices.size(), 1U);
  EXPECT_EQ(content<m>(corner, simplices[0]), Rational(1));
  // Without the origin the rest lies in a hyperplane.
  corner.erase(corner.begin());
  EXPECT_TRUE(approximate_delaunay<m>(approximate_all<m>(corner)).empty());
  EXPECT_TRUE(approximate_delaunay<m>({}).empty());
}

TEST(ApproximateDelaunay, uses_coinciding_points_once_and_finds_nothing_in_a_hyperplane) {
  check_doubled_and_flat<1>();
  check_doubled_and_flat<2>();
  check_doubled_and_flat<3>();
  check_doubled_and_flat<4>();
}

/// Of points that come in three portions.
template <int m>
void check_growth(const ExactPoints<m>& exact) {
  const auto points = approximate_all<m>(exact);
  GrowingDelaunay<m> growing;
  std::vector<Vector<double, m>> known;
  for (const std::size_t end : {points.size() / 2, points.size() / 2 + 1, points.size()}) {
    const std::vector<Vector<double, m>> portion(points.begin() + static_cast<std::ptrdiff_t>(known.size()),
                                                 points.begin() + static_cast<std::ptrdiff_t>(end));
    growing.add(portion);
    known.insert(known.end(), portion.begin(), portion.end());
    auto simplices = growing.simplices();
    for (auto& simplex : simplices) std::sort(simplex.begin(), simplex.end());
    std::sort(simplices.begin(), simplices.end());
    EXPECT_EQ(simplices, approximate_delaunay<m>(known));
  }
}

TEST(GrowingDelaunay, has_the_simplices_of_all_points_so_far) {
  check_growth<1>(random_points<1>(30, 1, 30));
  check_growth<2>(random_points<2>(200, 2, 30));
  check_growth<3>(random_points<3>(200, 3, 30));
  check_growth<4>(random_points<4>(20, 4, 30));
}

TEST(GrowingDelaunay, breaks_ties_as_if_all_points_had_been_there) {
  check_growth<2>(cube_grid<2>(6));
  check_growth<3>(cube_grid<3>(5));
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
