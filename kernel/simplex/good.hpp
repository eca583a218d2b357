#pragma once

#include <cstddef>

#include "kernel/simplex/edge_gram.hpp"
#include "kernel/simplex/faces.hpp"
#include "kernel/simplex/thickness.hpp"

namespace delcert {

namespace detail {
/// Whether Υ(σʲ) ≥ Γ₀ʲ for all faces with 1 ≤ j ≤ up_to. Vertices have thickness 1 = Γ₀⁰.
template <Scalar S>
[[nodiscard]] Verdict are_faces_thick(const EdgeGram<S>& simplex, const S& squared_flake_parameter, std::size_t up_to) {
  Verdict result = Verdict::proved;
  S bound(1);
  for (std::size_t j = 1; j <= up_to; ++j) {
    bound = bound * squared_flake_parameter;
    for (Faces faces(simplex.vertex_count(), j + 1); faces.has_face(); faces.advance()) {
      result = conjunction(result, is_thickness_at_least(simplex.face(faces.vertices()), bound));
      if (is_refuted(result)) return result;
    }
  }
  return result;
}
}  // namespace detail

/// Γ₀-good (section 2): Υ(σʲ) ≥ Γ₀ʲ for every face σʲ of σ, σ among them. Γ₀ comes as its square.
/// Precondition: 0 < Γ₀² ≤ 1.
template <Scalar S>
[[nodiscard]] Verdict is_good(const EdgeGram<S>& simplex, const S& squared_flake_parameter) {
  return detail::are_faces_thick(simplex, squared_flake_parameter, simplex.dimension());
}

/// Whether every facet is Γ₀-good, that is, every proper face is thick enough. True for a vertex, which has no facet.
template <Scalar S>
[[nodiscard]] Verdict are_facets_good(const EdgeGram<S>& simplex, const S& squared_flake_parameter) {
  if (simplex.dimension() == 0) return Verdict::proved;
  return detail::are_faces_thick(simplex, squared_flake_parameter, simplex.dimension() - 1);
}

}  // namespace delcert
