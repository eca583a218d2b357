#include "kernel/manifold/submanifold/shown_facet.hpp"

namespace delcert {

ShownFacet::ShownFacet(const PolyhedralMesh& mesh, const EnclosedChart<Interval>& chart, std::uint32_t facet) {
  for (std::size_t corner = 0; corner < 3; ++corner) {
    for (std::size_t k = 0; k < 3; ++k) corners[corner][k] = chart.coordinate(mesh.point(facet, corner), k);
  }
  normal = normal_of(corners);
}

Interval ShownFacet::side(std::size_t edge, const Interval& x, const Interval& y) const {
  return side_of(corners, edge, x, y);
}

bool ShownFacet::is_certainly_not_over(const Interval& x, const Interval& y) const {
  const bool is_up = is_proved(less(Interval(0), normal[2]));
  for (std::size_t edge = 0; edge < 3; ++edge) {
    const Interval beyond = side(edge, x, y);
    if (is_up ? is_proved(less(beyond, Interval(0))) : is_proved(less(Interval(0), beyond))) return true;
  }
  return false;
}

}  // namespace delcert
