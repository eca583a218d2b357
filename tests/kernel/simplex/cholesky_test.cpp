#include "kernel/simplex/cholesky.hpp"

#include "kernel/number/rounding_guard.hpp"
#include "tests/kernel/manifold/exhaustive.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

/// |Rx|² encloses xᵀGx, and is not much wider.
template <int m>
void check(const FlatSpace<m>& space) {
  const auto exact = space.metric.template on<Rational>();
  const RoundingGuard guard;
  const auto metric = space.metric.template on<Interval>();
  const auto factor = upper_factor<Interval, m>(metric, space.metric.gram());
  for (std::size_t row = 0; row < m; ++row) {
    for (std::size_t column = 0; column < row; ++column) EXPECT_EQ(factor[row][column].upper(), 0);
  }
  for (const auto& x : random_points<m>(20, 5)) {
    Vector<Interval, m> enclosed;
    for (std::size_t axis = 0; axis < m; ++axis) enclosed[axis] = scalar_from<Interval>(x[axis]);
    const auto cartesian = upper_applied(factor, enclosed);
    Interval squared(0);
    for (const Interval& coordinate : cartesian) squared += square(coordinate);
    EXPECT_TRUE(contains(squared, exact.squared_norm(x)));
    EXPECT_LE(squared.upper() - squared.lower(), 1e-12);
    if (!metric.is_cartesian()) continue;
    for (std::size_t axis = 0; axis < m; ++axis) {
      EXPECT_EQ(cartesian[axis].lower(), enclosed[axis].lower());
      EXPECT_EQ(cartesian[axis].upper(), enclosed[axis].upper());
    }
  }
}

TEST(UpperFactor, gives_cartesian_coordinates) {
  check<1>(cubic_torus<1>());
  check<2>(hexagonal_torus());
  check<2>(square_torus_in_a_long_basis());
  check<3>(cubic_torus<3>());
  check<3>(skewed_torus());
  check<4>(cubic_torus<4>());
}

/// The twin: the diagonal alone does not.
TEST(UpperFactor, is_not_its_diagonal) {
  const RoundingGuard guard;
  const auto space = square_torus_in_a_long_basis();
  auto factor = upper_factor<Interval, 2>(space.metric.on<Interval>(), space.metric.gram());
  factor[0][1] = Interval(0);
  const auto cartesian = upper_applied(factor, Vector<Interval, 2>{Interval(1), Interval(1)});
  EXPECT_FALSE(contains(square(cartesian[0]) + square(cartesian[1]),
                        space.metric.on<Rational>().squared_norm({Rational(1), Rational(1)})));
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
