#include "kernel/manifold/flat_atlas.hpp"

#include <numeric>

#include "kernel/number/rounding_guard.hpp"
#include "tests/kernel/manifold/exhaustive.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

template <int m>
void check_sightings(const FlatSpace<m>& space, const ExactPoints<m>& points, const Rational& sampling_radius) {
  const FlatAtlas<m> atlas(space, PointSet<m>(points), sampling_radius);
  ASSERT_EQ(atlas.size(), points.size());
  for (std::uint32_t index = 0; index < points.size(); index += 3) {
    const Label i(index);
    Lifts<m> seen{{99, {}}};
    for (const Rational& distance : {sampling_radius, Rational(5) * sampling_radius / Rational(2)}) {
      atlas.sightings(i, approximate_double(distance), seen);
      const auto within = lifts_within<m>(space, points, points[index], distance);
      const auto slightly_farther =
          lifts_within<m>(space, points, points[index], distance * (Rational(1) + Rational::power_of_two(-29)));
      EXPECT_TRUE(std::is_sorted(seen.begin(), seen.end()));
      EXPECT_TRUE(std::includes(seen.begin(), seen.end(), within.begin(), within.end()));
      EXPECT_TRUE(std::includes(slightly_farther.begin(), slightly_farther.end(), seen.begin(), seen.end()));
      const Lift<m> itself{index, {}};
      EXPECT_TRUE(std::binary_search(seen.begin(), seen.end(), itself));
    }
    const auto patch = lifts_within<m>(space, points, points[index], Rational(9) * sampling_radius);
    EXPECT_EQ(atlas.neighbours(i), patch);
  }
}

TEST(FlatAtlas, sees_what_lies_in_its_patches) {
  check_sightings<1>(cubic_torus<1>(), random_points<1>(30, 1, 12, Rational(-2), Rational(4)), ratio(1, 25));
  check_sightings<2>(hexagonal_torus(), random_points<2>(40, 2), ratio(1, 25));
  check_sightings<2>(square_torus_in_a_long_basis(), random_points<2>(40, 3), ratio(1, 25));
  check_sightings<3>(skewed_torus(), random_points<3>(40, 4), ratio(1, 20));
  check_sightings<3>(ball_of<3>(Rational(1)), random_points<3>(60, 5, 12, Rational(-1), Rational(2)), ratio(1, 10));
}

/// Whatever has been asked for before, answers are those of an atlas that is asked for the first time.
template <int m>
void check_order_of_questions(const FlatSpace<m>& space, const ExactPoints<m>& points, const Rational& radius) {
  const std::vector<Rational> factors{Rational(1), ratio(5, 2), ratio(9, 2), Rational(3), Rational(9)};
  std::vector<std::size_t> order(factors.size());
  std::iota(order.begin(), order.end(), 0U);
  do {
    const FlatAtlas<m> atlas(space, PointSet<m>(points), radius);
    for (const std::size_t at : order) {
      Lifts<m> seen;
      atlas.sightings(Label(1), approximate_double(factors[at] * radius), seen);
      EXPECT_EQ(seen, lifts_within<m>(space, points, points[1], factors[at] * radius));
    }
  } while (std::next_permutation(order.begin(), order.end()));
}

TEST(FlatAtlas, keeps_lists_that_change_no_answer) {
  check_order_of_questions<2>(hexagonal_torus(), random_points<2>(40, 2), ratio(1, 25));
  check_order_of_questions<3>(skewed_torus(), random_points<3>(40, 4, 12, Rational(-2), Rational(4)), ratio(1, 20));
  check_order_of_questions<2>(ball_of<2>(Rational(1)), random_points<2>(60, 5, 12, Rational(-1), Rational(2)),
                              ratio(1, 10));
  // Shifts that lists have no room for.
  auto far = random_points<2>(40, 6);
  for (std::size_t index = 0; index < far.size(); index += 2) far[index][0] += Rational(1000);
  check_order_of_questions<2>(cubic_torus<2>(), far, ratio(1, 25));
}

TEST(FlatAtlas, sees_a_label_through_several_lifts_where_patches_overlap_themselves) {
  const FlatAtlas<1> atlas(cubic_torus<1>(), PointSet<1>({{ratio(1, 4)}, {ratio(3, 4)}}), ratio(1, 8));
  // 9/8 on either side of 1/4: three lifts of each.
  const auto seen = atlas.neighbours(Label(0));
  EXPECT_EQ(seen, (Lifts<1>{{0, {-1}}, {0, {0}}, {0, {1}}, {1, {-1}}, {1, {0}}}));
  EXPECT_EQ(label_of<1>(seen[3]), Label(1));
}

TEST(FlatAtlas, carries_points_by_whole_lattice_vectors_exactly) {
  const FlatAtlas<2> atlas(hexagonal_torus(), PointSet<2>(random_points<2>(3, 6)), ratio(1, 10));
  const Vector<Rational, 2> home{ratio(1, 3), ratio(-5, 7)};
  const Sighting<2> seen{1, {3, -2}};
  const Vector<Rational, 2> there{ratio(10, 3), ratio(-19, 7)};
  EXPECT_EQ(atlas.carry(Label(0), seen, home), there);
  const FilterGuard guard;
  Vector<Filter, 2> on_intervals;
  Vector<BigInterval, 2> on_big_intervals;
  for (std::size_t axis = 0; axis < 2; ++axis) {
    on_intervals[axis] = scalar_from<Filter>(home[axis]);
    on_big_intervals[axis] = scalar_from<BigInterval>(home[axis]);
  }
  for (std::size_t axis = 0; axis < 2; ++axis) {
    EXPECT_TRUE(contains(atlas.carry(Label(0), seen, on_intervals)[axis], there[axis]));
    EXPECT_TRUE(contains(atlas.carry(Label(0), seen, on_big_intervals)[axis], there[axis]));
    // Nothing is lost where nothing moves.
    EXPECT_EQ(atlas.carry(Label(0), Sighting<2>{1, {}}, on_intervals)[axis].lower(), on_intervals[axis].lower());
  }
}

TEST(FlatAtlas, of_a_torus_has_interior_labels_only) {
  const FlatAtlas<2> atlas(cubic_torus<2>(), PointSet<2>(random_points<2>(5, 7)), Rational(100));
  for (std::uint32_t index = 0; index < atlas.size(); ++index) EXPECT_TRUE(atlas.is_interior(Label(index)));
}

TEST(FlatAtlas, of_a_ball_decides_interior_labels_exactly) {
  // 8ε = 4/5 leaves the closed ball of radius 1/5 = |(3/25, 4/25)|.
  const Rational hair = Rational::power_of_two(-100);
  const ExactPoints<2> points{{ratio(3, 25), ratio(4, 25)},
                              {ratio(3, 25), ratio(4, 25) + hair},
                              {ratio(-3, 25), ratio(4, 25) - hair},
                              {Rational(0), Rational(0)},
                              {ratio(1, 2), ratio(1, 2)}};
  const FlatAtlas<2> atlas(ball_of<2>(Rational(1)), PointSet<2>(points), ratio(1, 10));
  const std::vector<bool> expected{true, false, true, true, false};
  for (std::uint32_t index = 0; index < points.size(); ++index) {
    EXPECT_EQ(atlas.is_interior(Label(index)), expected[index]) << index;
  }
  // Where 8ε exceeds the radius nothing is interior, though (r − 8ε)² is large.
  const FlatAtlas<2> coarse(ball_of<2>(Rational(1)), PointSet<2>(points), Rational(1));
  for (std::uint32_t index = 0; index < points.size(); ++index) EXPECT_FALSE(coarse.is_interior(Label(index)));
}

TEST(FlatAtlas, has_one_sampling_radius_and_its_net) {
  const auto points = random_points<2>(4, 8);
  const FlatAtlas<2> atlas(hexagonal_torus(), PointSet<2>(points), ratio(1, 7));
  const Atlas<2>& as_atlas = atlas;
  EXPECT_EQ(as_atlas.sampling_radius(Label(3)), ratio(1, 7));
  EXPECT_EQ(as_atlas.net().exact(Label(2)), points[2]);
  EXPECT_EQ(as_atlas.metric().gram()[0][1], ratio(1, 2));
  EXPECT_TRUE(atlas.space().is_torus());
  EXPECT_EQ(ball_of<2>(ratio(3, 2)).box_radius(), 1.5);
  EXPECT_FALSE(atlas.space().box_radius().has_value());
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
