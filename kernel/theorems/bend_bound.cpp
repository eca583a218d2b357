#include "kernel/theorems/bend_bound.hpp"

namespace delcert {

template <int m>
Interval bend_bound(const Interval* form, std::size_t n, const Interval& steepness) {
  Interval plane(0), mixed(0), normal(0);
  for (std::size_t k = 0; k < n; ++k) {
    for (std::size_t l = 0; l < n; ++l) {
      Interval& sum = k < m && l < m ? plane : k >= m && l >= m ? normal : mixed;
      sum += square(form[k * n + l]);
    }
  }
  Interval in_plane = square_root(plane);
  if constexpr (m == 2) {  // the greater eigenvalue in size
    const Interval half(2);
    const Interval mean = (form[0] + form[n + 1]) / half;
    const Interval difference = (form[0] - form[n + 1]) / half;
    const Interval off = (form[1] + form[n]) / half;
    in_plane = minimum(in_plane, absolute(mean) + square_root(square(difference) + square(off)));
  }
  // `mixed` has both blocks: the sum of their norms is at most √2 times their common norm.
  return in_plane + square_root(Interval(2)) * steepness * square_root(mixed) + square(steepness) * square_root(normal);
}

template Interval bend_bound<1>(const Interval*, std::size_t, const Interval&);
template Interval bend_bound<2>(const Interval*, std::size_t, const Interval&);
template Interval bend_bound<3>(const Interval*, std::size_t, const Interval&);

}  // namespace delcert
