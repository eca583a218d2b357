#include "kernel/perturb/patch_view.hpp"

#include "tests/kernel/manifold/exhaustive.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

const auto space = hexagonal_torus();
const auto net = random_points<2>(30, 1, 20);
const FlatAtlas<2> atlas(space, PointSet<2>(net), ratio(1, 10));

/// The points a little away from the net.
PointSet<2> displaced() {
  auto points = net;
  for (auto& point : points) point[0] += ratio(1, 300);
  return PointSet<2>(points);
}

bool are_adjacent(const PatchView<2>& view, std::size_t a, std::size_t b) {
  const auto row = view.later_neighbours(std::min(a, b));
  const std::size_t later = std::max(a, b);
  return (row[later / 64] >> (later % 64) & 1U) != 0;
}

TEST(PatchView, shows_the_points_where_the_chart_sees_them) {
  const PointSet<2> points = displaced();
  const FilterGuard guard;
  PatchView<2> view(atlas, points);
  const auto seen = atlas.neighbours(Label(3));
  for (const auto& sighting : seen) view.add(sighting);
  ASSERT_EQ(view.size(), seen.size());
  for (std::size_t at = 0; at < seen.size(); ++at) {
    EXPECT_EQ(view.sighting(at), seen[at]);
    EXPECT_EQ(view.label(at), Label(seen[at].index));
    const auto exact = moved<2>(points.exact(Label(seen[at].index)), seen[at].shift);
    EXPECT_EQ(view.position_in<Rational>(at), exact);
    for (std::size_t axis = 0; axis < 2; ++axis) {
      EXPECT_TRUE(contains(view.position(at)[axis], exact[axis]));
      EXPECT_TRUE(contains(view.position_in<BigInterval>(at)[axis], exact[axis]));
    }
  }
}

TEST(PatchView, believes_what_is_sure_and_asks_the_metric_else) {
  const PointSet<2> points = displaced();
  const FilterGuard guard;
  const auto metric = space.metric.on<Filter>();
  PatchView<2> view(atlas, points);
  PatchView<2> same(atlas, points);
  for (const auto& sighting : atlas.neighbours(Label(3))) {
    view.add(sighting);
    same.add(sighting, atlas.carry(Label(3), sighting, points.enclosure(label_of<2>(sighting))));
  }
  const Filter bound = scalar_from<Filter>(ratio(1, 16));
  view.connect(metric, &bound);
  same.connect(metric, bound, [](std::size_t a, std::size_t b) {
    return a == 0 ? Verdict::proved : b % 5 == 0 ? Verdict::refuted : Verdict::undecided;
  });
  for (std::size_t a = 0; a < view.size(); ++a) {
    for (std::size_t b = a + 1; b < view.size(); ++b) {
      const bool expected = a == 0 || (b % 5 != 0 && are_adjacent(view, a, b));
      EXPECT_EQ(are_adjacent(same, a, b), expected);
    }
  }
}

TEST(PatchView, connects_what_is_not_certainly_apart) {
  const PointSet<2> points = displaced();
  const FilterGuard guard;
  const auto metric = space.metric.on<Filter>();
  PatchView<2> view(atlas, points);
  for (const auto& sighting : atlas.neighbours(Label(3))) view.add(sighting);
  ASSERT_GT(view.size(), 64U) << "more than a word of them";
  const Rational bound = ratio(1, 16);
  const Filter filter_bound = scalar_from<Filter>(bound);
  view.connect(metric, &filter_bound);
  EXPECT_EQ(view.words(), (view.size() + 63) / 64);
  std::size_t connected = 0;
  for (std::size_t a = 0; a < view.size(); ++a) {
    for (std::size_t b = a + 1; b < view.size(); ++b) {
      const bool near =
          squared_distance<2>(space, view.position_in<Rational>(a), view.position_in<Rational>(b)) < bound;
      EXPECT_EQ(are_adjacent(view, a, b), near) << a << " " << b;
      connected += near ? 1U : 0U;
    }
    for (std::size_t b = 0; b <= a; ++b) {
      EXPECT_EQ(view.later_neighbours(a)[b / 64] >> (b % 64) & 1U, 0U) << "not later";
    }
  }
  EXPECT_GT(connected, 100U);
  view.connect(metric, nullptr);
  for (std::size_t b = 1; b < view.size(); ++b) EXPECT_TRUE(are_adjacent(view, 0, b));
}

TEST(PatchView, keeps_ties_and_what_the_filter_cannot_tell) {
  // Distances 1/3 and a hair more; the bound is 1/9 exactly, which no double is.
  const Rational hair = Rational::power_of_two(-100);
  const PointSet<1> points({{Rational(0)}, {ratio(1, 3) + hair}, {ratio(-1, 3) - Rational::power_of_two(-20)}});
  const FlatAtlas<1> line(ball_of<1>(Rational(2)), points, ratio(1, 10));
  const FilterGuard guard;
  PatchView<1> view(line, points);
  for (std::uint32_t index = 0; index < 3; ++index) view.add({index, {0}});
  const Filter bound = scalar_from<Filter>(ratio(1, 9));
  view.connect(line.metric().on<Filter>(), &bound);
  EXPECT_EQ(view.later_neighbours(0)[0], 0b010U);
}

TEST(PatchView, is_empty_again_when_cleared) {
  const PointSet<2> points = displaced();
  const FilterGuard guard;
  PatchView<2> view(atlas, points);
  view.add({4, {1, 0}});
  view.clear(Label(0));
  EXPECT_EQ(view.size(), 0U);
  view.connect(space.metric.on<Filter>(), nullptr);
  EXPECT_EQ(view.words(), 0U);
  view.add({7, {0, 0}});
  EXPECT_EQ(view.label(0), Label(7));
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
