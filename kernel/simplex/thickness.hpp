#pragma once

#include <cstddef>
#include <optional>

#include "kernel/simplex/altitude.hpp"
#include "kernel/simplex/edges.hpp"

namespace delcert {

namespace detail {
template <Scalar S>
[[nodiscard]] S squared_thickness_scale(const EdgeGram<S>& simplex) {
  const S dimension(static_cast<int>(simplex.dimension()));
  return square(dimension) * squared_longest_edge(simplex);
}
}  // namespace detail

/// Υ(σ)²: the least squared altitude over (jΔ)² for a j-simplex, 1 for a vertex (section 2), 0 for a degenerate
/// simplex, also where all vertices coincide. On intervals absent where a facet, or the longest edge, may be
/// degenerate.
template <Scalar S>
[[nodiscard]] Partial<S> squared_thickness(const EdgeGram<S>& simplex) {
  if (simplex.dimension() == 0) return S(1);
  const S scale = detail::squared_thickness_scale(simplex);
  const Verdict is_point = is_zero(scale);
  if (is_proved(is_point)) return S(0);
  if (is_undecided(is_point)) return Partial<S>::absent(Verdict::undecided);
  if (simplex.dimension() == 1) return S(1);
  std::optional<S> least;
  for (std::size_t p = 0; p < simplex.vertex_count(); ++p) {
    Partial<S> here = squared_altitude(simplex, p);
    if (!here) return here;
    least = least ? minimum(*least, *here) : *here;
  }
  return S(*least / scale);
}

/// Υ(σ), on the rungs that have square roots; absent as `squared_thickness`.
template <Scalar S>
[[nodiscard]] Partial<S> thickness(const EdgeGram<S>& simplex) {
  const Partial<S> squared = squared_thickness(simplex);
  return squared ? Partial<S>(square_root(*squared)) : squared;
}

/// Whether Υ(σ)² ≥ squared_bound, altitude by altitude: one that is certainly too short refutes, whatever is unknown
/// about the others. Precondition: squared_bound > 0.
template <Scalar S>
[[nodiscard]] Verdict is_thickness_at_least(const EdgeGram<S>& simplex, const S& squared_bound) {
  if (simplex.dimension() == 0) return less_equal(squared_bound, S(1));
  const S scale = detail::squared_thickness_scale(simplex);
  Verdict result = negation(is_zero(scale));
  if (simplex.dimension() == 1) return conjunction(result, less_equal(squared_bound, S(1)));
  const S least = squared_bound * scale;
  for (std::size_t p = 0; p < simplex.vertex_count() && !is_refuted(result); ++p) {
    const Partial<S> here = squared_altitude(simplex, p);
    result = conjunction(result, here ? less_equal(least, *here) : Verdict::undecided);
  }
  return result;
}

}  // namespace delcert
