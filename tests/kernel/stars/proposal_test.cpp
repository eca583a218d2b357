#include "kernel/stars/proposal.hpp"

#include "kernel/parallel/threads.hpp"
#include "support/error.hpp"
#include "tests/kernel/stars/witness.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

/// Calls `visit` for all simplices with vertex (i, 0) and others of larger label among the lifts within `reach`.
template <int m, class Visit>
void for_each_simplex_at(const FlatSpace<m>& space, const ExactPoints<m>& points, std::uint32_t i,
                         const Rational& reach, const Visit& visit) {
  const auto near = lifts_within<m>(space, points, points[i], reach);
  std::vector<Lift<m>> simplex{{i, {}}};
  const auto extend = [&](const auto& self, std::size_t from) -> void {
    if (simplex.size() == m + 1) {
      visit(simplex);
      return;
    }
    for (std::size_t next = from; next < near.size(); ++next) {
      if (!(simplex.front() < near[next]) || near[next].index == i) continue;
      simplex.push_back(near[next]);
      self(self, next + 1);
      simplex.pop_back();
    }
  };
  extend(extend, 0);
}

/// The simplices with an empty ball of radius at most half the reach, in canonical form, by looking at all.
template <int m>
std::vector<LiftedSimplex<m>> empty_simplices(const FlatSpace<m>& space, const ExactPoints<m>& points,
                                              const Rational& reach) {
  std::vector<LiftedSimplex<m>> result;
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    for_each_simplex_at<m>(space, points, i, reach, [&](const std::vector<Lift<m>>& lifts) {
      const auto ball = ball_of_simplex<m>(space, all_at<m>(points, std::span<const Lift<m>>(lifts)));
      if (!ball || Rational(4) * ball->squared_radius > square(reach) || !is_empty<m>(space, points, *ball)) return;
      LiftedSimplex<m> simplex;
      std::copy(lifts.begin(), lifts.end(), simplex.begin());
      result.push_back(simplex);
    });
  }
  std::sort(result.begin(), result.end());
  return result;
}

template <int m>
std::vector<LiftedSimplex<m>> proposed(const FlatSpace<m>& space, const ExactPoints<m>& points, double radius) {
  return propose_delaunay<m>(space, approximate_all<m>(points), radius);
}

/// Every simplex is in canonical form and has an empty ball, and together they have the volume of the torus: then they
/// are all the Delaunay simplices. (Points in general position, so that all cells are simplices.)
template <int m>
void check_torus(const FlatSpace<m>& space, const ExactPoints<m>& points, double radius) {
  const auto simplices = proposed<m>(space, points, radius);
  EXPECT_TRUE(std::is_sorted(simplices.begin(), simplices.end()));
  EXPECT_EQ(std::adjacent_find(simplices.begin(), simplices.end()), simplices.end());
  Rational total(0);
  for (const auto& simplex : simplices) {
    EXPECT_EQ(canonical<m>(simplex), simplex);
    EXPECT_EQ(simplex[0].shift, (Shift<m>{}));
    const auto vertices = all_at<m>(points, std::span<const Lift<m>>(simplex));
    const auto ball = ball_of_simplex<m>(space, vertices);
    ASSERT_TRUE(ball.has_value());
    EXPECT_TRUE(is_empty<m>(space, points, *ball));
    total += absolute(edge_determinant<m>(vertices));
  }
  EXPECT_EQ(total, Rational(factorial(m)));
}

TEST(ProposeDelaunay, has_empty_balls_that_fill_the_torus) {
  check_torus<1>(cubic_torus<1>(), random_points<1>(20, 1, 30, Rational(-2), Rational(4)), 0.1);
  check_torus<2>(cubic_torus<2>(), random_points<2>(60, 2, 30, Rational(-2), Rational(4)), 0.1);
  check_torus<2>(hexagonal_torus(), random_points<2>(60, 3, 30), 0.1);
  check_torus<2>(square_torus_in_a_long_basis(), random_points<2>(60, 4, 30), 0.1);
  check_torus<3>(skewed_torus(), random_points<3>(60, 5, 30), 0.3);
  check_torus<3>(bcc_torus(), random_points<3>(40, 6, 30), 0.3);
}

TEST(ProposeDelaunay, needs_no_good_guess_of_the_circumradius) {
  const auto points = random_points<2>(50, 7, 30);
  const auto usual = proposed<2>(hexagonal_torus(), points, 0.1);
  EXPECT_EQ(proposed<2>(hexagonal_torus(), points, 0.001), usual);
  EXPECT_EQ(proposed<2>(hexagonal_torus(), points, 0.5), usual);
}

TEST(ProposeDelaunay, agrees_with_the_empty_ball_test_over_all_simplices) {
  const auto circle = random_points<1>(7, 1, 20);
  EXPECT_EQ(proposed<1>(cubic_torus<1>(), circle, 0.1), empty_simplices<1>(cubic_torus<1>(), circle, Rational(1)));
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    const auto points = random_points<2>(16, seed, 12);
    for (const auto& space : {cubic_torus<2>(), hexagonal_torus()}) {
      const auto simplices = proposed<2>(space, points, 0.2);
      EXPECT_EQ(simplices, empty_simplices<2>(space, points, Rational(1)));
      EXPECT_EQ(simplices.size(), 32U);
    }
  }
}

TEST(ProposeDelaunay, does_not_depend_on_the_lifts_that_the_points_are_given_at) {
  const auto points = random_points<2>(40, 8, 20);
  auto lifted = points;
  std::mt19937_64 random(9);
  std::vector<Shift<2>> shifts;
  for (auto& point : lifted) {
    shifts.push_back({static_cast<std::int32_t>(random() % 7) - 3, static_cast<std::int32_t>(random() % 7) - 3});
    point = moved<2>(point, shifts.back());
  }
  auto simplices = proposed<2>(hexagonal_torus(), lifted, 0.1);
  for (auto& simplex : simplices) {
    for (auto& vertex : simplex) vertex.shift = sum_of<2>(vertex.shift, shifts[vertex.index]);
    simplex = canonical<2>(simplex);
  }
  std::sort(simplices.begin(), simplices.end());
  EXPECT_EQ(simplices, proposed<2>(hexagonal_torus(), points, 0.1));
}

TEST(ProposeDelaunay, of_a_ball_is_the_triangulation_of_its_points) {
  const auto points = random_points<3>(40, 10, 20, Rational(-1), Rational(2));
  const auto simplices = proposed<3>(ball_of<3>(Rational(1)), points, 0.1);
  std::vector<IndexSimplex<3>> indices;
  for (const auto& simplex : simplices) {
    for (const auto& vertex : simplex) EXPECT_EQ(vertex.shift, (Shift<3>{}));
    indices.push_back({simplex[0].index, simplex[1].index, simplex[2].index, simplex[3].index});
  }
  EXPECT_EQ(indices, approximate_delaunay<3>(approximate_all<3>(points)));
}

TEST(ProposeDelaunay, works_in_dimension_4) {
  const auto points = random_points<4>(24, 11, 20, Rational(-1), Rational(2));
  EXPECT_EQ(proposed<4>(ball_of<4>(Rational(1)), points, 0.1).size(),
            approximate_delaunay<4>(approximate_all<4>(points)).size());
  check_torus<4>(cubic_torus<4>(), random_points<4>(24, 12, 20), 0.3);
}

/// Of one triangulation of all lifts about the unit cell, the simplices that have a vertex in it, in canonical form.
template <int m>
std::vector<LiftedSimplex<m>> simplices_at_unit_cell(const FlatSpace<m>& space,
                                                     const std::vector<Vector<double, m>>& points, double margin) {
  std::vector<Lift<m>> lifts;
  std::vector<Vector<double, m>> cartesian;
  Shift<m> low;
  Shift<m> high;
  low.fill(-1);
  high.fill(1);
  for_each_shift<m>(low, high, [&](const Shift<m>& shift) {
    for (std::uint32_t index = 0; index < points.size(); ++index) {
      Vector<double, m> x = points[index];
      bool is_near = true;
      for (std::size_t axis = 0; axis < m; ++axis) {
        x[axis] += shift[axis];
        is_near = is_near && x[axis] > -margin && x[axis] < 1 + margin;
      }
      if (!is_near) continue;
      lifts.push_back({index, shift});
      cartesian.push_back(space.metric.approximate_cartesian(x));
    }
  });
  std::vector<LiftedSimplex<m>> result;
  for (const IndexSimplex<m>& indices : approximate_delaunay<m>(cartesian)) {
    LiftedSimplex<m> simplex;
    for (std::size_t corner = 0; corner <= m; ++corner) simplex[corner] = lifts[indices[corner]];
    if (std::any_of(simplex.begin(), simplex.end(), [](const auto& vertex) { return vertex.is_unmoved(); }))
      result.push_back(canonical<m>(simplex));
  }
  std::sort(result.begin(), result.end());
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

/// So many points that the unit cell is divided, for any number of threads.
template <int m>
void check_division(const FlatSpace<m>& space, const std::vector<Vector<double, m>>& points, double radius,
                    double margin) {
  const auto expected = simplices_at_unit_cell<m>(space, points, margin);
  for (const unsigned threads : {1U, 2U, 4U}) {
    const ThreadLimit limit(threads);
    EXPECT_EQ(propose_delaunay<m>(space, points, radius), expected);
  }
}

TEST(ProposeDelaunay, by_boxes_has_the_simplices_of_one_triangulation) {
  check_division<2>(cubic_torus<2>(), approximate_all<2>(random_points<2>(6000, 13, 30)), 0.02, 0.3);
  check_division<2>(hexagonal_torus(), approximate_all<2>(random_points<2>(6000, 14, 30)), 0.02, 0.3);
  check_division<3>(cubic_torus<3>(), approximate_all<3>(random_points<3>(4000, 15, 30)), 0.05, 0.5);
}

TEST(ProposeDelaunay, by_boxes_breaks_ties_as_one_triangulation_does) {
  // Circumcentres on the borders of boxes, too.
  std::vector<Vector<double, 2>> square;
  for (int x = 0; x < 64; ++x) {
    for (int y = 0; y < 64; ++y) square.push_back({x / 64.0, y / 64.0});
  }
  check_division<2>(cubic_torus<2>(), square, 0.02, 0.3);
  EXPECT_EQ(propose_delaunay<2>(cubic_torus<2>(), square, 0.02).size(), 2 * square.size());
}

TEST(ProposeDelaunay, refuses_too_few_points) {
  EXPECT_TRUE(mentions(message_of<Rejection>([] { (void)proposed<2>(cubic_torus<2>(), {}, 0.1); }), "too few"));
  EXPECT_TRUE(mentions(
      message_of<Rejection>([] {
        (void)proposed<2>(ball_of<2>(Rational(1)), {{Rational(0), Rational(0)}, {Rational(1), Rational(1)}}, 0.1);
      }),
      "no simplex of dimension 2"));
  EXPECT_THROW((void)proposed<2>(cubic_torus<2>(), random_points<2>(40, 1), 1000), Rejection);
  // Defect: coordinates that overflowed the integers of shifts.
  EXPECT_THROW((void)proposed<1>(cubic_torus<1>(), {{Rational(0)}, {Rational::power_of_two(31)}}, 0.1), InputError);
}

TEST(ProposeDelaunay, says_that_a_basis_is_too_skewed_and_gives_a_reduced_one) {
  const auto in_steps = [](long step) {
    return torus_of<2>({{{Rational(1), Rational(step)}, {Rational(step), Rational(step * step + 1)}}});
  };
  const auto points = random_points<2>(60, 3);
  EXPECT_FALSE(proposed<2>(in_steps(4), points, 0.1).empty());
  EXPECT_TRUE(mentions(message_of<InputError>([&] { (void)proposed<2>(in_steps(1000), points, 0.1); }),
                       "too skewed for a Delaunay triangulation of the torus: describe the same torus by a reduced "
                       "basis, gram = [[\"1\", \"0\"], [\"0\", \"1\"]]"));
}

TEST(Canonical, sorts_and_moves_the_first_vertex_home) {
  const LiftedSimplex<2> simplex{{{5, {1, 2}}, {3, {-1, 4}}, {9, {0, 0}}}};
  const LiftedSimplex<2> expected{{{3, {0, 0}}, {5, {2, -2}}, {9, {1, -4}}}};
  EXPECT_EQ(canonical<2>(simplex), expected);
  LiftedSimplex<2> translated = simplex;
  for (auto& vertex : translated) vertex.shift = sum_of<2>(vertex.shift, {-7, 11});
  EXPECT_EQ(canonical<2>(translated), expected);
  // Two lifts of one label keep their difference.
  const LiftedSimplex<1> edge{{{4, {2}}, {4, {1}}}};
  EXPECT_EQ(canonical<1>(edge), (LiftedSimplex<1>{{{4, {0}}, {4, {1}}}}));
}

/// Few points first, between which there is more room: copies are then added farther out, too.
template <int m>
void check_growth(const FlatSpace<m>& space, const ExactPoints<m>& exact, double radius) {
  const auto points = approximate_all<m>(exact);
  GrowingProposal<m> growing(space, radius);
  for (const std::size_t part : {4U, 2U, 2U, 1U}) {
    const std::vector<Vector<double, m>> known(points.begin(),
                                               points.begin() + static_cast<std::ptrdiff_t>(points.size() / part));
    EXPECT_EQ(growing.simplices(known), propose_delaunay<m>(space, known, radius));
  }
}

TEST(GrowingProposal, has_the_simplices_of_all_points_so_far) {
  check_growth<1>(cubic_torus<1>(), random_points<1>(40, 1, 30, Rational(-2), Rational(4)), 0.05);
  check_growth<2>(hexagonal_torus(), random_points<2>(200, 2, 30), 0.05);
  check_growth<2>(square_torus_in_a_long_basis(), random_points<2>(200, 3, 30), 0.05);
  check_growth<3>(skewed_torus(), random_points<3>(240, 4, 30, Rational(-2), Rational(4)), 0.1);
  check_growth<3>(ball_of<3>(Rational(1)), random_points<3>(80, 5, 20, Rational(-1), Rational(2)), 0.1);
  check_growth<4>(ball_of<4>(Rational(1)), random_points<4>(40, 6, 20, Rational(-1), Rational(2)), 0.1);
}

TEST(GrowingProposal, refuses_too_few_points_until_there_are_more) {
  const auto points = approximate_all<2>(random_points<2>(60, 7, 30));
  const auto space = cubic_torus<2>();
  GrowingProposal<2> growing(space, 0.1);
  EXPECT_THROW((void)growing.simplices({}), Rejection);
  EXPECT_EQ(growing.simplices(points), propose_delaunay<2>(space, points, 0.1));
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
