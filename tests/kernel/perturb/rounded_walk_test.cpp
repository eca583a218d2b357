#include "kernel/perturb/rounded_walk.hpp"

#include <set>

#include "tests/kernel/manifold/exhaustive.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

using Positions = std::vector<std::uint32_t>;

/// What both walks tell. Where simplices are smaller than a radius, the walk goes on.
template <int m>
struct Recorder {
  static constexpr bool visits_top = false;

  Rational squared_radius;
  double scale = 1;

  std::set<Positions> entered;
  std::set<Positions> degenerate_sets;
  int repeated = 0;
  int in_doubles = 0;
  int on_intervals = 0;
  std::uint64_t over_in_doubles = 0;
  bool claims_nothing = false;

  void record(std::set<Positions>& sets, std::span<const std::uint32_t> vertices) {
    if (!sets.insert(Positions(vertices.begin(), vertices.end())).second) ++repeated;
  }
  template <class S>
  void start(const Vector<S, m>&) {}
  template <class S>
  bool enter(const SphereStack<S, m>& stack, std::span<const std::uint32_t> vertices) {
    ++on_intervals;
    record(entered, vertices);
    return !is_refuted(less(stack.squared_radius(), scalar_from<S>(squared_radius)));
  }
  void facet(const SphereStack<Filter, m>&) {}
  void over(const SphereStack<Filter, m>&, const typename SphereStack<Filter, m>::Apex&,
            std::span<const std::uint32_t> vertices) {
    ++on_intervals;
    record(entered, vertices);
  }
  void degenerate(std::span<const std::uint32_t> vertices) { record(degenerate_sets, vertices); }

  void start_rounded(const Vector<double, m>&) {}
  RoundedAnswer tell(RoundedAnswer mine, std::span<const std::uint32_t> vertices) {
    if (claims_nothing) return RoundedAnswer::unsure;
    ++in_doubles;
    record(entered, vertices);
    return mine;
  }
  RoundedAnswer enter_rounded(const FaceForm<double, m>& face, std::span<const std::uint32_t> vertices) {
    const double radius = face.sphere.norm / (2 * face.sphere.weight * scale);
    // Clear cases only; no radius here is near the bound.
    return tell(radius * radius < approximate_double(squared_radius) ? RoundedAnswer::go_on : RoundedAnswer::stop,
                vertices);
  }
  void facet_rounded(const FacetForm<double, m>&) {}
  RoundedAnswer over_rounded(const FacetForm<double, m>&, const ApexForm<double>&,
                             std::span<const std::uint32_t> vertices) {
    return tell(RoundedAnswer::stop, vertices);
  }
  void count_over(std::uint64_t count) { over_in_doubles += count; }
};

enum class Errors { bounded, huge, ignored };

template <int m>
struct Both {
  Recorder<m> thorough;
  Recorder<m> rounded;
};

template <int m>
Both<m> walk_both(const FlatSpace<m>& space, const ExactPoints<m>& points, const Rational& edge_bound,
                  const Rational& radius_bound, Errors errors = Errors::bounded, bool claims_nothing = false) {
  const PointSet<m> set(points);
  const FlatAtlas<m> atlas(space, set, ratio(1, 10));
  const FilterGuard guard;
  const auto filter = space.metric.template on<Filter>();
  const auto exact = space.metric.template on<Rational>();
  PatchView<m> view(atlas, set);
  for (std::uint32_t index = 0; index < points.size(); ++index) view.add({index, {}});
  const Filter squared_bound = scalar_from<Filter>(square(edge_bound));
  view.connect(filter, &squared_bound);

  RoundedFrame<m> frame(filter, space.metric.gram());
  frame.measure_by(scalar_from<Filter>(edge_bound).upper());
  frame.look_about(set.enclosure(Label(0)));
  std::vector<Vector<double, m>> places;
  double size = 0;
  double error = 0;
  for (std::size_t at = 0; at < view.size(); ++at) {
    const auto place = frame.place(view.position(at));
    places.push_back(place.at);
    error = std::max(error, place.error);
    for (const double coordinate : place.at) size = std::max(size, std::fabs(coordinate));
  }
  if (errors == Errors::huge) error = 1;
  RoundedBounds<m> bounds(size, error, 1.01);
  if (errors == Errors::ignored) bounds = RoundedBounds<m>(0, 0, 0);
  bounds.most_squared_edge = errors == Errors::ignored ? 1.01 : bounds.most_squared_edge;

  Both<m> result;
  for (Recorder<m>* recorder : {&result.thorough, &result.rounded}) {
    recorder->squared_radius = square(radius_bound);
    recorder->scale = frame.scale();
    recorder->claims_nothing = claims_nothing;
    SimplexWalk<m, Recorder<m>> walk(view, filter, exact, *recorder);
    if (recorder == &result.thorough) {
      for (std::uint32_t origin = 0; origin < view.size(); ++origin) walk.from(origin);
    } else {
      RoundedWalk<m, Recorder<m>> in_doubles(view, places, bounds, walk, *recorder);
      for (std::uint32_t origin = 0; origin < view.size(); ++origin) in_doubles.from(origin);
    }
  }
  EXPECT_EQ(result.thorough.repeated, 0);
  EXPECT_EQ(result.rounded.repeated, 0);
  return result;
}

template <int m>
void expect_the_same(const Both<m>& both) {
  EXPECT_EQ(both.rounded.entered, both.thorough.entered);
  EXPECT_EQ(both.rounded.degenerate_sets, both.thorough.degenerate_sets);
}

template <int m>
void check(const FlatSpace<m>& space, const ExactPoints<m>& points, const Rational& edge_bound,
           const Rational& radius_bound) {
  const auto both = walk_both<m>(space, points, edge_bound, radius_bound);
  expect_the_same(both);
  EXPECT_GT(both.rounded.in_doubles, static_cast<int>(points.size()));
  const auto is_over = [](const Positions& vertices) { return vertices.size() == m + 1; };
  EXPECT_EQ(both.rounded.over_in_doubles, static_cast<std::uint64_t>(std::count_if(
                                              both.rounded.entered.begin(), both.rounded.entered.end(), is_over)));
  EXPECT_EQ(both.rounded.on_intervals, 0) << "of points in general position nothing is left open";
  // Forced to leave everything open, by errors and by answers.
  for (const bool claims_nothing : {false, true}) {
    const auto forced = walk_both<m>(space, points, edge_bound, radius_bound,
                                     claims_nothing ? Errors::bounded : Errors::huge, claims_nothing);
    expect_the_same(forced);
    EXPECT_EQ(forced.rounded.in_doubles, 0);
    EXPECT_EQ(forced.rounded.over_in_doubles, 0U);
    EXPECT_EQ(forced.rounded.entered, both.thorough.entered);
  }
}

TEST(RoundedWalk, visits_what_the_walk_on_intervals_visits) {
  check<1>(cubic_torus<1>(), random_points<1>(20, 1, 20), ratio(1, 4), ratio(1, 10));
  check<2>(hexagonal_torus(), random_points<2>(25, 2, 20), ratio(2, 5), ratio(1, 4));
  check<2>(square_torus_in_a_long_basis(), random_points<2>(25, 3, 20), ratio(2, 5), ratio(1, 4));
  check<3>(skewed_torus(), random_points<3>(18, 4, 20), ratio(3, 5), ratio(2, 5));
  check<3>(cubic_torus<3>(), random_points<3>(18, 5, 20), ratio(3, 5), ratio(2, 5));
}

/// Points with thirds as coordinates: what is degenerate is not so in doubles.
template <int m>
ExactPoints<m> grid_of_thirds(std::int32_t side, bool displaced) {
  ExactPoints<m> points;
  Shift<m> last;
  last.fill(side - 1);
  for_each_shift<m>(Shift<m>{}, last, [&](const Shift<m>& shift) {
    points.emplace_back();
    for (std::size_t axis = 0; axis < m; ++axis) {
      points.back()[axis] = ratio(shift[axis], 3) + ratio(1, 7);
      const auto number = static_cast<long>(points.size());
      if (displaced) points.back()[axis] += Rational(number * number) * Rational::power_of_two(-80);
    }
  });
  return points;
}

TEST(RoundedWalk, leaves_open_what_may_be_degenerate) {
  for (const bool displaced : {false, true}) {
    const auto plane = walk_both<2>(ball_of<2>(Rational(9)), grid_of_thirds<2>(3, displaced), Rational(1), Rational(9));
    expect_the_same(plane);
    EXPECT_GT(plane.rounded.on_intervals + static_cast<int>(plane.rounded.degenerate_sets.size()), 0);
    const auto solid = walk_both<3>(ball_of<3>(Rational(9)), grid_of_thirds<3>(2, displaced), Rational(1), Rational(9));
    expect_the_same(solid);
    EXPECT_GT(solid.rounded.on_intervals + static_cast<int>(solid.rounded.degenerate_sets.size()), 0);
  }
}

/// The twin: with errors that are not counted degenerate simplices pass for others.
TEST(RoundedWalk, that_ignores_its_errors_is_wrong) {
  const auto plane =
      walk_both<2>(ball_of<2>(Rational(9)), grid_of_thirds<2>(3, false), Rational(1), Rational(9), Errors::ignored);
  EXPECT_NE(plane.rounded.entered, plane.thorough.entered);
}

/// The bounds hold: of the same simplices in rationals and in doubles no quantity differs by more.
TEST(RoundedBounds, hold_for_thin_simplices) {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> coordinate(-0.5, 0.5);
  const double error = 0x1p-40;
  const RoundedBounds<3> bounds(0.5, error, 3);
  const Rational step = Rational::exactly(error);
  double worst = 0;
  for (int sample = 0; sample < 2000; ++sample) {
    std::array<Vector<double, 3>, 4> places;
    for (auto& place : places) {
      for (double& x : place) x = coordinate(random);
    }
    // Two of three are nearly flat.
    if (sample % 3 != 0) places[3] = sum(scaled(0.25, sum(places[0], places[1])), scaled(0.5, places[2]));
    std::array<Vector<Rational, 3>, 4> exact;
    for (std::size_t at = 0; at < 4; ++at) {
      for (std::size_t axis = 0; axis < 3; ++axis)
        exact[at][axis] = Rational::exactly(places[at][axis]) + (random() % 2 == 0 ? step : -step);
    }
    std::array<Vector<double, 3>, 3> edges;
    std::array<Vector<Rational, 3>, 3> exact_edges;
    for (std::size_t at = 0; at < 3; ++at) {
      edges[at] = difference(places[at + 1], places[0]);
      exact_edges[at] = difference(exact[at + 1], exact[0]);
    }
    const auto squared = [&](std::size_t at) { return pairing(edges[at], edges[at]); };
    const auto& [a, b, c] = exact_edges;
    const auto face = triangle_form<double, 3>(edges[0], squared(0), edges[1], squared(1));
    const Rational weight = pairing(a, a) * pairing(b, b) - square(pairing(a, b));
    const FacetForm<double, 3> facet(face, edges);
    const ApexForm<double> apex(facet, edges[2], squared(2));
    const Rational slope = pairing(wedge(exact_edges), c);
    const auto compare = [&](double computed, const Rational& truth, const RoundingBound& bound) {
      const double off = approximate_double(absolute(Rational::exactly(computed) - truth)) / bound.error();
      EXPECT_LE(off, 1);
      EXPECT_LE(std::fabs(computed), bound.largest());
      worst = std::max(worst, off);
    };
    compare(face.weight, weight, bounds.face[2].sphere.weight);
    compare(apex.slope, slope, bounds.apex().slope);
    compare(apex.weight, absolute(slope) * weight, bounds.apex().weight);
    const Rational product = pairing(a, b);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      compare(face.normal[axis],
              pairing(b, b) * (pairing(a, a) - product) * a[axis] + pairing(a, a) * (pairing(b, b) - product) * b[axis],
              bounds.face[2].sphere.normal[axis]);
    }
    const Vector<Rational, 3> normal = [&] {
      Vector<Rational, 3> result;
      for (std::size_t axis = 0; axis < 3; ++axis)
        result[axis] =
            pairing(b, b) * (pairing(a, a) - product) * a[axis] + pairing(a, a) * (pairing(b, b) - product) * b[axis];
      return result;
    }();
    compare(apex.lift, weight * pairing(c, c) - pairing(normal, c), bounds.apex().lift);
  }
  EXPECT_GT(worst, 1e-3) << "bounds that say little";
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
