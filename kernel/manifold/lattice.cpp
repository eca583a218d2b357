#include "kernel/manifold/lattice.hpp"

#include <algorithm>

#include "kernel/simplex/dimensions.hpp"
#include "support/error.hpp"

namespace delcert {

template <int m>
Rational squared_systole(const FrameMetric<m>& metric) {
  const auto exact = metric.template on<Rational>();
  Rational best = metric.gram()[0][0];
  for (std::size_t axis = 1; axis < m; ++axis) best = minimum(best, metric.gram()[axis][axis]);

  Shift<m> bound;
  Rational count(1);
  for (std::size_t axis = 0; axis < m; ++axis) {
    const Integer most = floor_of(square_root_upper(best * metric.inverse_diagonal(axis), 32));
    if (most > 1000000) throw InputError("lattice basis is too skewed: reduce it first");
    bound[axis] = most.convert_to<std::int32_t>();
    count *= Rational(2 * bound[axis] + 1);
  }
  if (count > Rational(10000000)) throw InputError("lattice basis is too skewed: reduce it first");

  Shift<m> x;
  for (std::size_t axis = 0; axis < m; ++axis) x[axis] = -bound[axis];
  while (true) {
    if (std::any_of(x.begin(), x.end(), [](auto coordinate) { return coordinate != 0; })) {
      Vector<Rational, m> vector;
      for (std::size_t axis = 0; axis < m; ++axis) vector[axis] = Rational(x[axis]);
      best = minimum(best, exact.squared_norm(vector));
    }
    std::size_t axis = m;
    while (axis > 0 && ++x[axis - 1] > bound[axis - 1]) {
      x[axis - 1] = -bound[axis - 1];
      --axis;
    }
    if (axis == 0) return best;
  }
}

#define DELCERT_INSTANTIATE(m) template Rational squared_systole<m>(const FrameMetric<m>&);
DELCERT_FOR_EACH_DIMENSION(DELCERT_INSTANTIATE)
#undef DELCERT_INSTANTIATE

}  // namespace delcert
