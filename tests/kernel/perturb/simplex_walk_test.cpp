#include "kernel/perturb/simplex_walk.hpp"

#include <set>

#include "tests/kernel/manifold/exhaustive.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

using Positions = std::vector<std::uint32_t>;

/// What a walk tells, with the spheres that it shows.
template <int m, bool with_top>
struct Recorder {
  static constexpr bool visits_top = with_top;

  const PatchView<m>* view;
  FlatSpace<m> space;
  std::optional<Rational> largest_squared_radius;  // goes on below this only

  std::set<Positions> entered;
  std::set<Positions> degenerate_sets;
  std::set<Positions> tops;
  int repeated = 0;
  int wrong_spheres = 0;
  int exact_starts = 0;

  [[nodiscard]] ExactPoints<m> vertices_of(std::span<const std::uint32_t> positions) const {
    ExactPoints<m> result;
    for (const auto at : positions) result.push_back(view->template position_in<Rational>(at));
    return result;
  }
  void record(std::set<Positions>& sets, std::span<const std::uint32_t> vertices) {
    if (!sets.insert(Positions(vertices.begin(), vertices.end())).second) ++repeated;
  }
  template <class S>
  void check_sphere(std::span<const std::uint32_t> vertices, const S& squared_radius, const Vector<S, m>& centre) {
    const auto exact = vertices_of(vertices);
    const auto ball = ball_of_simplex<m>(space, exact);
    const auto encloses = [](const S& a, const Rational& b) {
      if constexpr (std::same_as<S, Rational>) {
        return a == b;
      } else {
        return contains(a, b);
      }
    };
    bool right = ball && encloses(squared_radius, ball->squared_radius);
    for (std::size_t axis = 0; axis < m && right; ++axis) {
      right = encloses(centre[axis], ball->centre[axis] - exact[0][axis]);
    }
    if (!right) ++wrong_spheres;
  }

  template <class S>
  void start(const Vector<S, m>&) {
    if constexpr (std::same_as<S, Rational>) ++exact_starts;
  }
  template <class S>
  bool enter(const SphereStack<S, m>& stack, std::span<const std::uint32_t> vertices) {
    record(entered, vertices);
    check_sphere<S>(vertices, stack.squared_radius(), stack.centre());
    if (!largest_squared_radius) return true;
    return !is_refuted(less(stack.squared_radius(), scalar_from<S>(*largest_squared_radius)));
  }
  void facet(const SphereStack<Filter, m>&) {}
  void over(const SphereStack<Filter, m>& stack, const typename SphereStack<Filter, m>::Apex& apex,
            std::span<const std::uint32_t> vertices) {
    record(entered, vertices);
    check_sphere<Filter>(vertices, apex.squared_radius, stack.centre_over(apex));
  }
  void degenerate(std::span<const std::uint32_t> vertices) { record(degenerate_sets, vertices); }
  template <class S>
  void top(const SphereStack<S, m>&, std::span<const std::uint32_t> vertices, std::uint32_t apex, const Vector<S, m>&,
           const S&) {
    Positions all(vertices.begin(), vertices.end());
    all.push_back(apex);
    record(tops, all);
  }
};

/// What a walk should tell: by extending sets in all ways.
template <int m, bool with_top>
struct Expected {
  std::set<Positions> entered;
  std::set<Positions> degenerate_sets;
  std::set<Positions> tops;

  Expected(const Recorder<m, with_top>& like, const Rational& squared_bound) {
    for (std::uint32_t origin = 0; origin < like.view->size(); ++origin) extend(like, squared_bound, {origin});
  }

  void extend(const Recorder<m, with_top>& like, const Rational& squared_bound, const Positions& set) {
    const auto vertices = like.vertices_of(set);
    for (std::uint32_t next = set.back() + 1; next < like.view->size(); ++next) {
      const auto position = like.view->template position_in<Rational>(next);
      if (std::any_of(vertices.begin(), vertices.end(), [&](const auto& vertex) {
            return squared_distance<m>(like.space, vertex, position) >= squared_bound;
          })) {
        continue;
      }
      Positions larger = set;
      larger.push_back(next);
      if (larger.size() == m + 2) {
        if (with_top) tops.insert(larger);
        continue;
      }
      const auto ball = ball_of_simplex<m>(like.space, like.vertices_of(larger));
      if (!ball) {
        degenerate_sets.insert(larger);
        continue;
      }
      entered.insert(larger);
      if (like.largest_squared_radius && ball->squared_radius >= *like.largest_squared_radius) continue;
      extend(like, squared_bound, larger);
    }
  }
};

template <int m, bool with_top>
Recorder<m, with_top> check_walk(const FlatSpace<m>& space, const ExactPoints<m>& points, const Rational& squared_bound,
                                 std::optional<Rational> radius_bound = {}) {
  const PointSet<m> set(points);
  const FlatAtlas<m> atlas(space, set, ratio(1, 10));
  const FilterGuard guard;
  const auto filter = space.metric.template on<Filter>();
  const auto exact = space.metric.template on<Rational>();
  PatchView<m> view(atlas, set);
  for (std::uint32_t index = 0; index < points.size(); ++index) view.add({index, {}});
  const Filter bound = scalar_from<Filter>(squared_bound);
  view.connect(filter, &bound);
  Recorder<m, with_top> recorder;
  recorder.view = &view;
  recorder.space = space;
  recorder.largest_squared_radius = radius_bound;
  SimplexWalk<m, Recorder<m, with_top>> walk(view, filter, exact, recorder);
  for (std::uint32_t origin = 0; origin < view.size(); ++origin) walk.from(origin);
  const Expected<m, with_top> expected(recorder, squared_bound);
  EXPECT_EQ(recorder.entered, expected.entered);
  EXPECT_EQ(recorder.degenerate_sets, expected.degenerate_sets);
  EXPECT_EQ(recorder.tops, expected.tops);
  EXPECT_EQ(recorder.repeated, 0);
  EXPECT_EQ(recorder.wrong_spheres, 0);
  return recorder;
}

template <int m>
void check_both(const FlatSpace<m>& space, const ExactPoints<m>& points, const Rational& squared_bound,
                std::optional<Rational> radius_bound = {}) {
  check_walk<m, true>(space, points, squared_bound, radius_bound);
  const auto recorder = check_walk<m, false>(space, points, squared_bound, radius_bound);
  EXPECT_GT(recorder.entered.size(), points.size());
}

TEST(SimplexWalk, visits_every_clique_once_with_its_sphere) {
  check_both<1>(cubic_torus<1>(), random_points<1>(20, 1, 20), ratio(1, 16));
  check_both<2>(hexagonal_torus(), random_points<2>(25, 2, 20), ratio(1, 6));
  check_both<3>(skewed_torus(), random_points<3>(18, 3, 20), ratio(1, 3));
  check_both<4>(cubic_torus<4>(), random_points<4>(12, 4, 20), ratio(1, 2));
}

TEST(SimplexWalk, goes_on_where_the_visitor_wants_to) {
  check_both<2>(hexagonal_torus(), random_points<2>(25, 5, 20), ratio(1, 4), ratio(1, 30));
  check_both<3>(cubic_torus<3>(), random_points<3>(18, 6, 20), ratio(1, 2), ratio(1, 12));
}

/// Thirds, which no double is: what is degenerate cannot be told by the filter.
template <int m>
ExactPoints<m> grid_of_thirds(std::int32_t side) {
  ExactPoints<m> points;
  Shift<m> last;
  last.fill(side - 1);
  for_each_shift<m>(Shift<m>{}, last, [&](const Shift<m>& shift) {
    points.emplace_back();
    for (std::size_t axis = 0; axis < m; ++axis) points.back()[axis] = ratio(shift[axis], 3) + ratio(1, 7);
  });
  return points;
}

TEST(SimplexWalk, tells_degenerate_simplices_exactly_and_goes_no_further) {
  auto doubled = grid_of_thirds<1>(5);
  doubled.push_back(doubled.front());
  EXPECT_EQ((check_walk<1, false>(ball_of<1>(Rational(9)), doubled, Rational(9)).degenerate_sets.size()), 1U);
  const auto plane = check_walk<2, true>(ball_of<2>(Rational(9)), grid_of_thirds<2>(3), Rational(1));
  EXPECT_EQ(plane.degenerate_sets.size(), 8U) << "the lines of a square of 3 × 3 points";
  EXPECT_GT(plane.exact_starts, 0);
  EXPECT_EQ((check_walk<2, false>(ball_of<2>(Rational(9)), grid_of_thirds<2>(3), Rational(1)).degenerate_sets.size()),
            8U);
  EXPECT_GT((check_walk<3, true>(ball_of<3>(Rational(9)), grid_of_thirds<3>(2), Rational(1)).exact_starts), 0);
  EXPECT_EQ((check_walk<3, false>(ball_of<3>(Rational(9)), grid_of_thirds<3>(2), Rational(1)).degenerate_sets.size()),
            12U)
      << "the rectangles of a cube";
}

TEST(SimplexWalk, walks_what_is_nearly_degenerate_in_rationals) {
  auto points = grid_of_thirds<2>(3);
  for (std::size_t k = 0; k < points.size(); ++k) {
    points[k][0] += Rational(static_cast<long>(k * k)) * Rational::power_of_two(-80);
    points[k][1] += Rational(static_cast<long>(k * k * k)) * Rational::power_of_two(-80);
  }
  const auto recorder = check_walk<2, true>(ball_of<2>(Rational(9)), points, Rational(1));
  EXPECT_TRUE(recorder.degenerate_sets.empty());
  EXPECT_GT(recorder.exact_starts, 0);
  check_walk<2, false>(ball_of<2>(Rational(9)), points, Rational(1));
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
