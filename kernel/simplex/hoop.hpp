#pragma once

#include <cstddef>

#include "kernel/simplex/sphere_distance.hpp"

namespace delcert {

/// d(p, S(σ)) ≤ α₀R(σ) for the given offset of p against σ; α₀ comes as its square.
template <Scalar S>
[[nodiscard]] Verdict is_within_hoop(const SphereOffset<S>& offset, const S& squared_hoop_bound) {
  return is_circumsphere_within(offset, S(squared_hoop_bound * offset.squared_radius));
}

/// The α₀-hoop property (section 2): d(p, S(τ_p)) ≤ α₀R(τ_p) < ∞ for every vertex p, τ_p its opposite facet.
/// A facet without a circumcentre refutes it. Precondition: the simplex has dimension at least 1.
template <Scalar S>
[[nodiscard]] Verdict has_hoop_property(const EdgeGram<S>& simplex, const S& squared_hoop_bound) {
  Verdict result = Verdict::proved;
  for (std::size_t p = 0; p < simplex.vertex_count() && !is_refuted(result); ++p) {
    const auto offset = sphere_offset(simplex, p);
    result = conjunction(result, offset ? is_within_hoop(*offset, squared_hoop_bound) : offset.exists());
  }
  return result;
}

}  // namespace delcert
