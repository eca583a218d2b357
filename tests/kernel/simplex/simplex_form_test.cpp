#include "kernel/simplex/simplex_form.hpp"

#include <gtest/gtest.h>

#include "kernel/simplex/sphere_stack.hpp"
#include "tests/kernel/manifold/exhaustive.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

template <class S, int m>
using Edges = std::array<Vector<S, m>, static_cast<std::size_t>(m)>;

template <int m>
Vector<double, m> squares_of(const Edges<double, m>& edges) {
  Vector<double, m> result;
  for (std::size_t k = 0; k < m; ++k) result[k] = pairing(edges[k], edges[k]);
  return result;
}

/// The edges with this one last.
template <int m>
Edges<Rational, m> with_last(Edges<Rational, m> edges, std::size_t k) {
  std::swap(edges[k], edges[static_cast<std::size_t>(m) - 1]);
  return edges;
}

template <int m>
SphereStack<Rational, m> stack_of(const MetricOn<Rational, m>& metric, const Edges<Rational, m>& edges) {
  SphereStack<Rational, m> stack(metric);
  for (const auto& edge : edges) EXPECT_TRUE(is_proved(stack.push(edge, metric.squared_norm(edge))));
  return stack;
}

/// The squared least altitude over the squared longest edge, from the stacks with each vertex last.
template <int m>
Rational squared_flatness(const MetricOn<Rational, m>& metric, const Edges<Rational, m>& edges) {
  Rational longest(0);
  for (std::size_t k = 0; k < m; ++k) {
    longest = maximum(longest, metric.squared_norm(edges[k]));
    for (std::size_t j = 0; j < k; ++j) longest = maximum(longest, metric.squared_norm(difference(edges[k], edges[j])));
  }
  Rational least = stack_of<m>(metric, edges).squared_altitude();
  for (std::size_t k = 0; k < m; ++k)
    least = minimum(least, stack_of<m>(metric, with_last<m>(edges, k)).squared_altitude());
  // And the vertex at 0: seen from the end of the first edge.
  Edges<Rational, m> around;
  for (std::size_t k = 1; k < m; ++k) around[k - 1] = difference(edges[k], edges[0]);
  around[static_cast<std::size_t>(m) - 1] = difference(Vector<Rational, m>{}, edges[0]);
  least = minimum(least, stack_of<m>(metric, around).squared_altitude());
  return least / longest;
}

/// Small integers: everything but the norm is computed exactly.
template <int m>
void check_against_stacks(std::uint64_t seed) {
  std::mt19937_64 random(seed);
  const auto metric = FrameMetric<m>::cartesian().template on<Rational>();
  int simplices = 0;
  for (int sample = 0; sample < 200; ++sample) {
    Edges<double, m> edges;
    Edges<Rational, m> exact;
    for (std::size_t k = 0; k < m; ++k) {
      for (std::size_t axis = 0; axis < m; ++axis) {
        edges[k][axis] = static_cast<double>(random() % 15) - 7;
        exact[k][axis] = Rational::exactly(edges[k][axis]);
      }
    }
    const SimplexForm<double, m> form(edges, squares_of<m>(edges));
    if (form.sphere.weight == 0) continue;
    ++simplices;
    const auto stack = stack_of<m>(metric, exact);
    const Rational weight = Rational::exactly(form.sphere.weight);
    for (std::size_t axis = 0; axis < m; ++axis)
      EXPECT_EQ(Rational::exactly(form.sphere.normal[axis]), Rational(2) * weight * stack.centre()[axis]);
    EXPECT_NEAR(form.sphere.norm, 2 * form.sphere.weight * std::sqrt(approximate_double(stack.squared_radius())),
                1e-14 * form.sphere.norm);
    EXPECT_EQ(square(weight) / Rational::exactly(form.breadth), squared_flatness<m>(metric, exact));
  }
  EXPECT_GT(simplices, 150);
}

TEST(SimplexForm, is_that_of_the_stacks_of_spheres) {
  check_against_stacks<2>(1);
  check_against_stacks<3>(2);
}

TEST(SimplexForm, of_a_degenerate_simplex_has_no_weight) {
  const Edges<double, 3> flat{{{1, 2, 3}, {2, 1, 0}, {3, 3, 3}}};
  EXPECT_EQ((SimplexForm<double, 3>(flat, squares_of<3>(flat)).sphere.weight), 0);
  const Edges<double, 2> straight{{{1, 2}, {-2, -4}}};
  EXPECT_EQ((SimplexForm<double, 2>(straight, squares_of<2>(straight)).sphere.weight), 0);
}

/// In rationals next to the doubles no quantity differs by more than the bound; `counted` is the error it counts with.
template <int m>
double worst_error(double counted) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> coordinate(-1, 1);
  const double error = 0x1p-40;
  const auto edge = RoundingBound::of(1 + error, counted);
  Edges<RoundingBound, m> edge_bounds;
  for (auto& one : edge_bounds) one.fill(edge);
  Vector<RoundingBound, m> squared_bounds;
  squared_bounds.fill(pairing(edge_bounds[0], edge_bounds[0]));
  const SimplexForm<RoundingBound, m> bounds(edge_bounds, squared_bounds);
  double worst = 0;
  for (int sample = 0; sample < 500; ++sample) {
    Edges<double, m> edges;
    Edges<Rational, m> exact;
    for (std::size_t k = 0; k < m; ++k) {
      for (std::size_t axis = 0; axis < m; ++axis) {
        edges[k][axis] = coordinate(random);
        exact[k][axis] =
            Rational::exactly(edges[k][axis]) + Rational::exactly(error) * Rational(random() % 2 == 0 ? 1 : -1);
      }
    }
    const SimplexForm<double, m> form(edges, squares_of<m>(edges));
    const auto metric = FrameMetric<m>::cartesian().template on<Rational>();
    const auto stack = stack_of<m>(metric, exact);
    const Rational weight = absolute(pairing(wedge(Edges<Rational, m>([&] {
                                               Edges<Rational, m> others{};
                                               for (std::size_t k = 1; k < m; ++k) others[k - 1] = exact[k];
                                               return others;
                                             }())),
                                             exact[0]));
    const auto compare = [&](double computed, const Rational& truth, const RoundingBound& bound) {
      worst = std::max(worst, approximate_double(absolute(Rational::exactly(computed) - truth)) / bound.error());
    };
    compare(form.sphere.weight, weight, bounds.sphere.weight);
    for (std::size_t axis = 0; axis < m; ++axis)
      compare(form.sphere.normal[axis], Rational(2) * weight * stack.centre()[axis], bounds.sphere.normal[axis]);
    compare(form.breadth, square(weight) / squared_flatness<m>(metric, exact), bounds.breadth);
  }
  return worst;
}

TEST(SimplexForm, is_wrong_by_no_more_than_its_bounds) {
  for (const double worst : {worst_error<2>(0x1p-40), worst_error<3>(0x1p-40)}) {
    EXPECT_LE(worst, 1);
    EXPECT_GT(worst, 1e-3) << "bounds that say little";
  }
  // The twin: bounds that do not count the errors of the edges do not hold.
  EXPECT_GT(worst_error<2>(0), 1);
  EXPECT_GT(worst_error<3>(0), 1);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
