#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "kernel/simplex/good.hpp"
#include "kernel/simplex/partial.hpp"

namespace delcert {

/// Γ₀-flake (section 2): not Γ₀-good, but all facets are. With good facets only Υ(σ) < Γ₀ᵏ is left of the first
/// condition. A flake may be degenerate. Precondition: 0 < Γ₀² ≤ 1.
template <Scalar S>
[[nodiscard]] Verdict is_flake(const EdgeGram<S>& simplex, const S& squared_flake_parameter) {
  S bound(1);
  for (std::size_t j = 0; j < simplex.dimension(); ++j) bound = bound * squared_flake_parameter;
  const Verdict thin = negation(is_thickness_at_least(simplex, bound));
  return is_refuted(thin) ? thin : conjunction(thin, are_facets_good(simplex, squared_flake_parameter));
}

/// The vertices of a flake among the faces, one of least dimension. There is one exactly when the simplex is not good.
/// Refuted when it certainly is good. Precondition: 0 < Γ₀² ≤ 1.
template <Scalar S>
[[nodiscard]] Partial<std::vector<std::size_t>> find_flake(const EdgeGram<S>& simplex,
                                                           const S& squared_flake_parameter) {
  using Vertices = std::vector<std::size_t>;
  Verdict none = Verdict::proved;
  S bound(1);
  for (std::size_t j = 1; j <= simplex.dimension(); ++j) {
    bound = bound * squared_flake_parameter;
    for (Faces faces(simplex.vertex_count(), j + 1); faces.has_face(); faces.advance()) {
      const Verdict thick = is_thickness_at_least(simplex.face(faces.vertices()), bound);
      if (is_refuted(thick) && is_proved(none)) return faces.vertices();
      none = conjunction(none, thick);
    }
  }
  return Partial<Vertices>::absent(is_proved(none) ? Verdict::refuted : Verdict::undecided);
}

}  // namespace delcert
