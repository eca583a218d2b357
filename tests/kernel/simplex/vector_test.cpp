#include "kernel/simplex/vector.hpp"

#include "kernel/number/rounding_guard.hpp"
#include "tests/kernel/manifold/exhaustive.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

template <std::size_t m>
std::array<Rational, m> any_vector() {
  std::array<Rational, m> result;
  for (Rational& coordinate : result) coordinate = *any_coordinate();
  return result;
}

template <class S, std::size_t m>
std::array<S, m> on_rung(const std::array<Rational, m>& x) {
  std::array<S, m> result;
  for (std::size_t axis = 0; axis < m; ++axis) result[axis] = scalar_from<S>(x[axis]);
  return result;
}

/// det(x, e_1, …, e_{m−1}) by Laplace, as the edges from the origin.
template <std::size_t m>
Rational determinant_with(const std::array<Rational, m>& x, const std::array<std::array<Rational, m>, m>& e) {
  ExactPoints<static_cast<int>(m)> vertices{std::array<Rational, m>{}, x};
  for (std::size_t row = 0; row + 1 < m; ++row) vertices.push_back(e[row]);
  return edge_determinant<static_cast<int>(m)>(vertices);
}

template <std::size_t m>
void check_wedge() {
  std::array<std::array<Rational, m>, m> e;
  for (std::size_t row = 0; row + 1 < m; ++row) e[row] = any_vector<m>();
  const auto x = any_vector<m>();
  const auto covector = wedge(e);
  RC_ASSERT(pairing(covector, x) == determinant_with<m>(x, e));
  for (std::size_t row = 0; row + 1 < m; ++row) RC_ASSERT(pairing(covector, e[row]) == Rational(0));

  const RoundingGuard guard;
  std::array<std::array<Interval, m>, m> on_intervals;
  std::array<std::array<BigInterval, m>, m> on_big_intervals;
  for (std::size_t row = 0; row + 1 < m; ++row) {
    on_intervals[row] = on_rung<Interval>(e[row]);
    on_big_intervals[row] = on_rung<BigInterval>(e[row]);
  }
  for (std::size_t axis = 0; axis < m; ++axis) {
    RC_ASSERT(contains(wedge(on_intervals)[axis], covector[axis]));
    RC_ASSERT(contains(wedge(on_big_intervals)[axis], covector[axis]));
  }
}

RC_GTEST_PROP(Wedge, pairs_to_the_determinant_and_vanishes_on_its_vectors, ()) {
  check_wedge<1>();
  check_wedge<2>();
  check_wedge<3>();
  check_wedge<4>();
}

RC_GTEST_PROP(Wedge, of_dependent_vectors_is_zero, ()) {
  const auto a = any_vector<4>();
  const auto b = any_vector<4>();
  const Rational factor = *any_coordinate();
  const std::array<std::array<Rational, 4>, 4> e{a, b, sum(scaled(factor, a), b), {}};
  RC_ASSERT(wedge(e) == (std::array<Rational, 4>{}));
  const auto c = any_vector<3>();
  RC_ASSERT(wedge(std::array<std::array<Rational, 3>, 3>{c, scaled(factor, c), {}}) == (std::array<Rational, 3>{}));
}

TEST(Wedge, of_the_other_unit_vectors_is_the_first) {
  const Rational one(1);
  const Rational zero(0);
  EXPECT_EQ(wedge(std::array<std::array<Rational, 1>, 1>{}), (std::array<Rational, 1>{one}));
  EXPECT_EQ(wedge(std::array<std::array<Rational, 2>, 2>{{{zero, one}, {}}}), (std::array<Rational, 2>{one, zero}));
  EXPECT_EQ(wedge(std::array<std::array<Rational, 3>, 3>{{{zero, one, zero}, {zero, zero, one}, {}}}),
            (std::array<Rational, 3>{one, zero, zero}));
  EXPECT_EQ(wedge(std::array<std::array<Rational, 4>, 4>{
                {{zero, one, zero, zero}, {zero, zero, one, zero}, {zero, zero, zero, one}, {}}}),
            (std::array<Rational, 4>{one, zero, zero, zero}));
}

RC_GTEST_PROP(Vectors, obey_the_laws_of_a_vector_space, ()) {
  const auto a = any_vector<3>();
  const auto b = any_vector<3>();
  const Rational factor = *any_coordinate();
  RC_ASSERT(sum(difference(a, b), b) == a);
  RC_ASSERT(scaled(factor, sum(a, b)) == sum(scaled(factor, a), scaled(factor, b)));
  RC_ASSERT(pairing(a, b) == a[0] * b[0] + a[1] * b[1] + a[2] * b[2]);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
