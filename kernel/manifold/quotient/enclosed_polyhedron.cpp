#include "kernel/manifold/quotient/enclosed_polyhedron.hpp"

namespace delcert {

template <int m>
EnclosedPolyhedron<m>::EnclosedPolyhedron(const InvariantForm& form, const DirichletPolyhedron& polyhedron) {
  for (const auto& side : polyhedron.sides) {
    // ⟨x, c − o⟩ ≤ 0 for the centre c of the tile across the side; ⟨c − o, c − o⟩ = 2c₀ − 2.
    const auto rows = form.in_standard_basis(side.element);
    const BigInterval stretch = rows[0][0] - BigInterval(1);
    const BigInterval length = square_root(stretch + stretch);
    ModelPoint<Interval, m> normal;
    normal[0] = in_doubles((BigInterval(0) - stretch) / length);
    for (std::size_t row = 1; row <= m; ++row) normal[row] = in_doubles(rows[row][0] / length);
    normals_.push_back(normal);
  }
}

template <int m>
Verdict EnclosedPolyhedron<m>::contains(const ModelPoint<Interval, m>& x) const {
  Verdict result = Verdict::proved;
  for (const auto& normal : normals_) {
    const Verdict is_inside = less_equal(pairing(normal, x), Interval(0));
    if (is_refuted(is_inside)) return Verdict::refuted;
    if (is_undecided(is_inside)) result = Verdict::undecided;
  }
  return result;
}

template <int m>
bool EnclosedPolyhedron<m>::is_certainly_farther(const ModelPoint<Interval, m>& x, const Interval& sine) const {
  for (const auto& normal : normals_) {
    if (is_proved(less(sine, pairing(normal, x)))) return true;
  }
  return false;
}

template class EnclosedPolyhedron<2>;
template class EnclosedPolyhedron<3>;

}  // namespace delcert
