#include "kernel/simplex/sphere_stack.hpp"

#include "kernel/number/rounding_guard.hpp"
#include "kernel/simplex/altitude.hpp"
#include "kernel/simplex/gram_elimination.hpp"
#include "tests/kernel/manifold/exhaustive.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

template <int m>
Vector<Rational, m> any_vector() {
  Vector<Rational, m> result;
  for (Rational& coordinate : result) coordinate = *any_coordinate();
  return result;
}

template <class S, int m>
Vector<S, m> on_rung(const Vector<Rational, m>& x) {
  Vector<S, m> result;
  for (std::size_t axis = 0; axis < m; ++axis) result[axis] = scalar_from<S>(x[axis]);
  return result;
}

/// The Cartesian frame, or one with AᵀA + I.
template <int m>
FlatSpace<m> any_space() {
  if (*rc::gen::inRange(0, 2) == 0) return cubic_torus<m>();
  Matrix<Rational, m> factor;
  for (auto& row : factor) row = any_vector<m>();
  Matrix<Rational, m> gram;
  for (std::size_t a = 0; a < m; ++a) {
    for (std::size_t b = 0; b < m; ++b) {
      gram[a][b] = Rational(a == b ? 1 : 0);
      for (std::size_t k = 0; k < m; ++k) gram[a][b] += factor[k][a] * factor[k][b];
    }
  }
  return torus_of<m>(gram);
}

/// m edges from the origin; in one of four draws the last is a combination of two, give or take 2⁻ᵉ.
template <int m>
ExactPoints<m> any_edges() {
  ExactPoints<m> edges;
  for (int k = 0; k < m; ++k) edges.push_back(any_vector<m>());
  if (m >= 2 && *rc::gen::inRange(0, 4) == 0) {
    edges.back() = scaled(*any_coordinate(), edges.front());
    if (*rc::gen::inRange(0, 2) == 0) edges.back()[0] += Rational::power_of_two(-*rc::gen::inRange(1, 120));
  }
  return edges;
}

bool encloses(const Rational& a, const Rational& b) { return a == b; }
bool encloses(const Interval& a, const Rational& b) { return contains(a, b); }
bool encloses(const BigInterval& a, const Rational& b) { return contains(a, b); }

/// Pushes all edges on the rung S and compares every depth with the quantities from the Gram matrix.
template <class S, int m>
void check_pushes(const FlatSpace<m>& space, const ExactPoints<m>& edges, const Vector<Rational, m>& y) {
  const auto exact = space.metric.template on<Rational>();
  const auto metric = space.metric.template on<S>();
  SphereStack<S, m> stack(metric);
  ExactPoints<m> vertices{Vector<Rational, m>{}};
  for (const auto& edge : edges) {
    const auto edge_on_rung = on_rung<S, m>(edge);
    const int before = stack.dimension();
    const Verdict verdict = stack.push(edge_on_rung, metric.squared_norm(edge_on_rung));
    vertices.push_back(edge);
    const auto simplex = simplex_in<m>(space, vertices);
    const Verdict truth = GramElimination<Rational>(simplex.gram()).definite();
    RC_ASSERT(agrees(verdict, truth));
    if constexpr (std::same_as<S, Rational>) RC_ASSERT(verdict == truth);
    if (!is_proved(verdict)) {
      RC_ASSERT(stack.dimension() == before);
      return;
    }
    RC_ASSERT(stack.dimension() == before + 1);
    const auto ball = ball_of_simplex<m>(space, vertices);
    RC_ASSERT(encloses(stack.squared_radius(), ball->squared_radius));
    RC_ASSERT(encloses(stack.squared_altitude(), *squared_altitude(simplex, vertices.size() - 1)));
    for (std::size_t axis = 0; axis < m; ++axis) RC_ASSERT(encloses(stack.centre()[axis], ball->centre[axis]));
    const Rational power = squared_distance<m>(space, y, ball->centre) - ball->squared_radius;
    RC_ASSERT(encloses(stack.power(on_rung<S, m>(y), scalar_from<S>(exact.squared_norm(y))), power));
  }
}

template <int m>
void check_dimension() {
  const auto space = any_space<m>();
  const auto edges = any_edges<m>();
  const auto y = any_vector<m>();
  check_pushes<Rational, m>(space, edges, y);
  check_pushes<BigInterval, m>(space, edges, y);
  const RoundingGuard guard;
  check_pushes<Interval, m>(space, edges, y);
}

RC_GTEST_PROP(SphereStack, has_the_diametric_spheres_of_its_simplices_on_every_rung, ()) {
  check_dimension<1>();
  check_dimension<2>();
  check_dimension<3>();
  check_dimension<4>();
}

/// The sphere over a facet by `apex` is the one that `push` finds, for the power of points as well.
template <class S, int m>
void check_apex(const FlatSpace<m>& space, const ExactPoints<m>& edges, const Vector<Rational, m>& y) {
  const auto metric = space.metric.template on<S>();
  SphereStack<S, m> stack(metric);
  for (std::size_t k = 0; k + 1 < m; ++k) {
    const auto edge = on_rung<S, m>(edges[k]);
    if (!is_proved(stack.push(edge, metric.squared_norm(edge)))) return;
  }
  ExactPoints<m> vertices{Vector<Rational, m>{}};
  vertices.insert(vertices.end(), edges.begin(), edges.end());
  const auto ball = ball_of_simplex<m>(space, vertices);
  const auto last = on_rung<S, m>(edges.back());
  const auto apex = stack.apex(last, metric.squared_norm(last));
  RC_ASSERT(agrees(apex.non_degenerate, verdict_of(ball.has_value())));
  if constexpr (std::same_as<S, Rational>) RC_ASSERT(!is_undecided(apex.non_degenerate));
  if (!is_proved(apex.non_degenerate)) return;
  RC_ASSERT(encloses(apex.squared_radius, ball->squared_radius));
  for (std::size_t axis = 0; axis < m; ++axis) RC_ASSERT(encloses(stack.centre_over(apex)[axis], ball->centre[axis]));
  const auto place = on_rung<S, m>(y);
  const auto probe = stack.probe(place, metric.squared_norm(place));
  const Rational power = squared_distance<m>(space, y, ball->centre) - ball->squared_radius;
  RC_ASSERT((encloses(SphereStack<S, m>::power_over(apex, probe), power)));
  // Neither of them changed the stack: pushing gives the same sphere.
  RC_ASSERT(stack.dimension() == m - 1);
  if constexpr (std::same_as<S, Rational>) {
    RC_ASSERT(is_proved(stack.push(last, metric.squared_norm(last))));
    RC_ASSERT(stack.squared_radius() == apex.squared_radius);
  }
}

template <int m>
void check_apex_in_dimension() {
  const auto space = any_space<m>();
  const auto edges = any_edges<m>();
  const auto y = any_vector<m>();
  check_apex<Rational, m>(space, edges, y);
  check_apex<BigInterval, m>(space, edges, y);
  const RoundingGuard guard;
  check_apex<Interval, m>(space, edges, y);
}

RC_GTEST_PROP(SphereStack, knows_the_sphere_over_a_facet_without_pushing, ()) {
  check_apex_in_dimension<1>();
  check_apex_in_dimension<2>();
  check_apex_in_dimension<3>();
  check_apex_in_dimension<4>();
}

TEST(SphereStack, pops_back_to_the_sphere_before) {
  const auto space = hexagonal_torus();
  const auto metric = space.metric.on<Rational>();
  SphereStack<Rational, 2> stack(metric);
  const Vector<Rational, 2> a{Rational(3), Rational(1)};
  const Vector<Rational, 2> b{Rational(-1), Rational(2)};
  const Vector<Rational, 2> c{Rational(1), Rational(5)};
  ASSERT_TRUE(is_proved(stack.push(a, metric.squared_norm(a))));
  const Rational below = stack.squared_radius();
  ASSERT_TRUE(is_proved(stack.push(b, metric.squared_norm(b))));
  const Rational first = stack.squared_radius();
  stack.pop();
  EXPECT_EQ(stack.dimension(), 1);
  EXPECT_EQ(stack.squared_radius(), below);
  ASSERT_TRUE(is_proved(stack.push(c, metric.squared_norm(c))));
  EXPECT_NE(stack.squared_radius(), first);
  stack.pop();
  ASSERT_TRUE(is_proved(stack.push(b, metric.squared_norm(b))));
  EXPECT_EQ(stack.squared_radius(), first);
}

TEST(SphereStack, refutes_degenerate_simplices_in_rationals_and_leaves_them_undecided_in_intervals) {
  const auto space = cubic_torus<3>();
  const Vector<Rational, 3> a{ratio(1, 3), ratio(1, 7), Rational(0)};
  const auto doubled = scaled(Rational(2), a);
  const auto exact = space.metric.on<Rational>();
  SphereStack<Rational, 3> stack(exact);
  EXPECT_EQ(stack.push(Vector<Rational, 3>{}, Rational(0)), Verdict::refuted);
  ASSERT_EQ(stack.push(a, exact.squared_norm(a)), Verdict::proved);
  EXPECT_EQ(stack.push(doubled, exact.squared_norm(doubled)), Verdict::refuted);
  EXPECT_EQ(stack.dimension(), 1);

  const RoundingGuard guard;
  const auto metric = space.metric.on<Interval>();
  SphereStack<Interval, 3> on_intervals(metric);
  const auto edge = on_rung<Interval, 3>(a);
  const auto doubled_edge = on_rung<Interval, 3>(doubled);
  ASSERT_EQ(on_intervals.push(edge, metric.squared_norm(edge)), Verdict::proved);
  EXPECT_EQ(on_intervals.push(doubled_edge, metric.squared_norm(doubled_edge)), Verdict::undecided);
  EXPECT_EQ(on_intervals.dimension(), 1);
}

TEST(SphereStack, of_a_cube_corner_has_the_middle_of_the_cube_as_its_centre) {
  const auto space = cubic_torus<4>();
  const auto metric = space.metric.on<Rational>();
  SphereStack<Rational, 4> stack(metric);
  for (std::size_t k = 0; k < 4; ++k) {
    Vector<Rational, 4> unit;
    unit[k] = Rational(1);
    ASSERT_TRUE(is_proved(stack.push(unit, Rational(1))));
    EXPECT_EQ(stack.squared_radius(), ratio(static_cast<long>(k) + 1, 4));
  }
  EXPECT_EQ(stack.centre(), (Vector<Rational, 4>{ratio(1, 2), ratio(1, 2), ratio(1, 2), ratio(1, 2)}));
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
