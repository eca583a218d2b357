#pragma once

#include <cstddef>
#include <vector>

#include "kernel/simplex/edge_gram.hpp"
#include "kernel/simplex/gram_elimination.hpp"
#include "kernel/simplex/partial.hpp"
#include "kernel/simplex/root_comparison.hpp"

namespace delcert {

/// Where a point p lies relative to the circumsphere of a simplex σ.
template <Scalar S>
struct SphereOffset {
  S squared_height;  ///< distance of p from aff σ, squared
  S squared_shift;   ///< distance of the projection of p to aff σ from C(σ), squared
  S squared_radius;  ///< R(σ)²

  /// |p − C(σ)|²
  [[nodiscard]] S squared_centre_distance() const { return squared_height + squared_shift; }
};

/// Vertex p of the simplex against the circumsphere of the opposite facet, in whatever dimension the simplex lies.
/// Absent as `circumsphere` of the facet. Precondition: the simplex has dimension at least 1.
template <Scalar S>
[[nodiscard]] Partial<SphereOffset<S>> sphere_offset(const EdgeGram<S>& simplex, std::size_t p) {
  if (simplex.dimension() == 0) throw std::invalid_argument("a vertex has no facet");
  // In aff σ, C solves Gλ = b (half the diagonal) and the projection of p solves Gμ = g; their difference gives the
  // shift.
  const std::size_t base = p == 0 ? 1 : 0;
  std::vector<S> centre;
  std::vector<S> shadow;
  std::vector<S> apart;
  for (std::size_t i = 0; i < simplex.vertex_count(); ++i) {
    if (i == p || i == base) continue;
    centre.push_back(simplex.squared_edge(i, base) / S(2));
    shadow.push_back(simplex.product(base, i, p));
    apart.push_back(shadow.back() - centre.back());
  }
  const GramElimination<S> elimination(simplex.opposite_facet(p).gram());
  const auto to_centre = elimination.energy(std::move(centre));
  const auto to_shadow = elimination.energy(std::move(shadow));
  const auto between = elimination.energy(std::move(apart));
  const Verdict exists = conjunction(to_centre.exists(), conjunction(to_shadow.exists(), between.exists()));
  if (!is_proved(exists)) return Partial<SphereOffset<S>>::absent(exists);
  return SphereOffset<S>{simplex.squared_edge(p, base) - *to_shadow, *between, *to_centre};
}

/// d(p, S(σ)) ≤ bound, with S(σ) = S^{m−1}(σ) ∩ aff σ the circumsphere: h² + ρ² + R² − bound² ≤ 2ρR.
template <Scalar S>
[[nodiscard]] Verdict is_circumsphere_within(const SphereOffset<S>& offset, const S& squared_bound) {
  return is_at_most_twice_root(S(offset.squared_centre_distance() + offset.squared_radius - squared_bound),
                               S(offset.squared_shift * offset.squared_radius));
}

/// d(p, S^{m−1}(σ)) ≤ bound for the diametric sphere: q² + R² − bound² ≤ 2qR with q = |p − C(σ)|.
template <Scalar S>
[[nodiscard]] Verdict is_diametric_sphere_within(const SphereOffset<S>& offset, const S& squared_bound) {
  const S squared_centre_distance = offset.squared_centre_distance();
  return is_at_most_twice_root(S(squared_centre_distance + offset.squared_radius - squared_bound),
                               S(squared_centre_distance * offset.squared_radius));
}

/// d(p, S(σ)), on the rungs that have square roots.
template <Scalar S>
[[nodiscard]] S circumsphere_distance(const SphereOffset<S>& offset) {
  const S gap = square_root(offset.squared_shift) - square_root(offset.squared_radius);
  return square_root(S(offset.squared_height + square(gap)));
}

/// d(p, S^{m−1}(σ)), on the rungs that have square roots.
template <Scalar S>
[[nodiscard]] S diametric_sphere_distance(const SphereOffset<S>& offset) {
  return absolute(S(square_root(offset.squared_centre_distance()) - square_root(offset.squared_radius)));
}

}  // namespace delcert
