#include "kernel/sample/torus_sizing.hpp"

#include <algorithm>
#include <cmath>

#include "kernel/simplex/dimensions.hpp"
#include "support/error.hpp"

namespace delcert {

namespace {

constexpr double most_lifts = 1e6;

template <int m>
Vector<double, m> in_unit_cell(Vector<double, m> x) {
  for (double& coordinate : x) coordinate -= std::floor(coordinate);
  return x;
}

}  // namespace

template <int m>
TorusSizing<m>::TorusSizing(const FlatSpace<m>& space, double greatest) : metric_(space.metric), cones_(m, greatest) {
  for (std::size_t axis = 0; axis < m; ++axis) {
    stretch_[axis] = std::sqrt(approximate_double(metric_.inverse_diagonal(axis)));
    farthest_ += std::sqrt(approximate_double(metric_.gram()[axis][axis])) / 2;
  }
}

template <int m>
void TorusSizing<m>::add(const Sizing::Cone& cone) {
  if (cone.radius >= greatest()) return;
  // Farther away a cone is above e_max, or another lift of it is lower.
  const double reach = cone.slope > 0 ? std::min((greatest() - cone.radius) / cone.slope, farthest_) : farthest_;
  Vector<double, m> apex;
  std::copy(cone.apex.begin(), cone.apex.end(), apex.begin());
  apex = in_unit_cell<m>(apex);
  Shift<m> first;
  Shift<m> last;
  double number = 1;
  for (std::size_t axis = 0; axis < m; ++axis) {
    const double half_width = reach * stretch_[axis] * (1 + 0x1p-20) + 0x1p-20;
    first[axis] = static_cast<std::int32_t>(std::ceil(std::max(-half_width - apex[axis], -0x1p30)));
    last[axis] = static_cast<std::int32_t>(std::floor(std::min(1 + half_width - apex[axis], 0x1p30)));
    number *= 1.0 + last[axis] - first[axis];
  }
  if (!(number <= most_lifts))
    throw InputError(
        "the lattice basis is too skewed for a sizing function: describe the same torus by a reduced basis");
  Shift<m> shift = first;
  while (number >= 1) {
    Vector<double, m> lift = apex;
    for (std::size_t axis = 0; axis < m; ++axis) lift[axis] += shift[axis];
    const Vector<double, m> place = metric_.approximate_cartesian(lift);
    cones_.add({{place.begin(), place.end()}, cone.radius, cone.slope});
    std::size_t axis = m;
    while (axis > 0 && ++shift[axis - 1] > last[axis - 1]) {
      shift[axis - 1] = first[axis - 1];
      --axis;
    }
    if (axis == 0) break;
  }
}

template <int m>
double TorusSizing<m>::at(const Vector<double, m>& x) const {
  return cones_.at(metric_.approximate_cartesian(in_unit_cell<m>(x)).data());
}

template <int m>
TorusSizing<m> torus_sizing(const SizingRequest& request, const FlatSpace<m>& space, double greatest) {
  if (!space.is_torus()) throw InputError("--sizing is for flat tori and submanifolds");
  if (request.is_by_curvature()) throw InputError("--sizing " + request.text + ": a flat torus has no curvature");
  TorusSizing<m> result(space, greatest);
  for (const Sizing::Cone& cone : read_cones(request.text, m)) result.add(cone);
  return result;
}

#define DELCERT_INSTANTIATE(m)   \
  template class TorusSizing<m>; \
  template TorusSizing<m> torus_sizing<m>(const SizingRequest&, const FlatSpace<m>&, double);
DELCERT_FOR_EACH_DIMENSION(DELCERT_INSTANTIATE)
#undef DELCERT_INSTANTIATE

}  // namespace delcert
