#include "kernel/simplex/frame_metric.hpp"

#include "kernel/number/rounding_guard.hpp"
#include "support/error.hpp"
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

/// AᵀA + I for a random A: symmetric and positive definite.
template <int m>
Matrix<Rational, m> any_gram() {
  Matrix<Rational, m> factor;
  for (auto& row : factor) row = any_vector<m>();
  Matrix<Rational, m> gram;
  for (std::size_t a = 0; a < m; ++a) {
    for (std::size_t b = 0; b < m; ++b) {
      gram[a][b] = Rational(a == b ? 1 : 0);
      for (std::size_t k = 0; k < m; ++k) gram[a][b] += factor[k][a] * factor[k][b];
    }
  }
  return gram;
}

template <int m>
Rational determinant_of_rows(const Matrix<Rational, m>& rows) {
  ExactPoints<m> vertices{Vector<Rational, m>{}};
  vertices.insert(vertices.end(), rows.begin(), rows.end());
  return edge_determinant<m>(vertices);
}

template <int m>
void check_inner_product() {
  const FrameMetric<m> metric(any_gram<m>());
  RC_ASSERT(metric.determinant() == determinant_of_rows<m>(metric.gram()));
  const auto exact = metric.template on<Rational>();
  const auto a = any_vector<m>();
  const auto b = any_vector<m>();
  Rational inner(0);
  for (std::size_t i = 0; i < m; ++i) {
    for (std::size_t j = 0; j < m; ++j) inner += a[i] * metric.gram()[i][j] * b[j];
  }
  RC_ASSERT(exact.inner(a, b) == inner);
  RC_ASSERT(exact.squared_norm(a) == exact.inner(a, a));
  RC_ASSERT(exact.determinant() == metric.determinant());
  // adj(G) raises: ⟨adj(G)ν, x⟩ = det(G)·ν(x).
  RC_ASSERT(exact.inner(exact.raised(b), a) == metric.determinant() * pairing(b, a));
  for (std::size_t axis = 0; axis < m; ++axis) {
    // |x_a|² ≤ (G⁻¹)_aa |x|², with equality for x = G⁻¹e_a.
    RC_ASSERT(square(a[axis]) <= metric.inverse_diagonal(axis) * exact.squared_norm(a));
    Vector<Rational, m> unit;
    unit[axis] = Rational(1);
    const auto steepest = exact.raised(unit);
    RC_ASSERT(square(steepest[axis]) == metric.inverse_diagonal(axis) * exact.squared_norm(steepest));
  }

  const RoundingGuard guard;
  const auto on_intervals = metric.template on<Interval>();
  RC_ASSERT(contains(on_intervals.inner(on_rung<Interval, m>(a), on_rung<Interval, m>(b)), inner));
  RC_ASSERT(contains(on_intervals.squared_norm(on_rung<Interval, m>(a)), exact.squared_norm(a)));
  RC_ASSERT(contains(on_intervals.determinant(), metric.determinant()));
  const auto on_big_intervals = metric.template on<BigInterval>();
  RC_ASSERT(contains(on_big_intervals.inner(on_rung<BigInterval, m>(a), on_rung<BigInterval, m>(b)), inner));
  for (std::size_t axis = 0; axis < m; ++axis) {
    RC_ASSERT(contains(on_intervals.raised(on_rung<Interval, m>(b))[axis], exact.raised(b)[axis]));
    RC_ASSERT(contains(on_big_intervals.raised(on_rung<BigInterval, m>(b))[axis], exact.raised(b)[axis]));
  }
}

RC_GTEST_PROP(FrameMetric, has_the_inner_product_of_its_gram_matrix_on_every_rung, ()) {
  check_inner_product<1>();
  check_inner_product<2>();
  check_inner_product<3>();
  check_inner_product<4>();
}

template <int m>
void check_approximate_coordinates() {
  const FrameMetric<m> metric(any_gram<m>());
  const auto x = any_vector<m>();
  const auto cartesian = metric.approximate_cartesian(approximate<m>(x));
  const double squared = approximate_double(metric.template on<Rational>().squared_norm(x));
  RC_ASSERT(std::abs(pairing(cartesian, cartesian) - squared) <= 1e-9 * (1 + squared));
  const auto back = metric.approximate_frame(cartesian);
  for (std::size_t axis = 0; axis < m; ++axis) {
    RC_ASSERT(std::abs(back[axis] - approximate_double(x[axis])) <= 1e-6 * (1 + std::sqrt(squared)));
  }
}

RC_GTEST_PROP(FrameMetric, has_approximate_cartesian_coordinates_with_the_right_lengths, ()) {
  check_approximate_coordinates<1>();
  check_approximate_coordinates<2>();
  check_approximate_coordinates<3>();
  check_approximate_coordinates<4>();
}

TEST(FrameMetric, knows_the_cartesian_frame) {
  const auto cartesian = FrameMetric<3>::cartesian();
  EXPECT_TRUE(cartesian.is_cartesian());
  EXPECT_TRUE(cartesian.on<Rational>().is_cartesian());
  EXPECT_EQ(cartesian.determinant(), Rational(1));
  const Vector<Rational, 3> x{Rational(2), ratio(1, 3), Rational(-1)};
  EXPECT_EQ(cartesian.on<Rational>().raised(x), x);
  EXPECT_EQ(cartesian.on<Rational>().squared_norm(x), ratio(46, 9));
  // A metric that differs in one diagonal entry is none, and is not mistaken for one.
  Matrix<Rational, 3> gram = cartesian.gram();
  gram[2][2] = Rational(2);
  const FrameMetric<3> stretched(gram);
  EXPECT_FALSE(stretched.is_cartesian());
  EXPECT_EQ(stretched.on<Rational>().squared_norm(x), ratio(55, 9));
}

std::string refusal(const Matrix<Rational, 2>& gram) {
  return message_of<InputError>([&] { (void)FrameMetric<2>(gram); });
}

TEST(FrameMetric, refuses_what_is_not_positive_definite_and_says_which_minor) {
  const Rational one(1);
  EXPECT_TRUE(mentions(refusal({{{Rational(0), one}, {one, one}}}), "order 1"));
  EXPECT_TRUE(mentions(refusal({{{Rational(-1), Rational(0)}, {Rational(0), Rational(-1)}}}), "order 1"));
  EXPECT_TRUE(mentions(refusal({{{one, one}, {one, one}}}), "order 2"));
  EXPECT_TRUE(mentions(refusal({{{one, Rational(2)}, {Rational(2), one}}}), "order 2"));
  EXPECT_TRUE(mentions(refusal({{{one, ratio(1, 2)}, {ratio(1, 3), one}}}), "symmetric"));
  // Within a hair of singular is still definite.
  const Rational almost = one - Rational::power_of_two(-200);
  EXPECT_GT(FrameMetric<2>({{{one, almost}, {almost, one}}}).determinant(), Rational(0));
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
