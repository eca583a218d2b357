#pragma once

#include <optional>

#include "properties/instances/configuration.hpp"
#include "properties/instances/instance_class.hpp"

namespace delcert {

/// A forbidden configuration of dimension k + 1 in ℝᵐ (def:forbidden.config) with vertices μ₀′ε′ apart.
///
/// All vertices lie on a sphere of ℝᵏ, rationally; then one of them is moved off it by at most δ, and for k < m also
/// out of ℝᵏ, as high as leaves a flake, with a shift along ℝᵏ such that a larger ball still goes through all of them.
/// Facets are fat, or (k ≥ 3) slivers that are hardly Γ₀-good. Nothing for k = 1 (there is none, proof in
/// docs/claims/forbidden-configurations.md), and rarely for other choices. Where no hypothesis limits μ₀, some are
/// drawn in ℝ² with μ₀ = 17/10, from a hexagonal net: see docs. Precondition: `bound` has k and m.
[[nodiscard]] std::optional<Configuration> draw_forbidden_configuration(const Shape& shape, const Bindings& bound,
                                                                        const Limits& limits, Choices& choices);

/// A (k+1)-simplex in ℝᵐ with the properties P1 … P4 of lem:prop.forbid.cfg only, and vertices μ₀ε apart (ρ₀ = 0): all
/// vertices near a sphere of radius up to 2ε, one moved so far that the α₀-hoop property hardly holds. Most of them
/// are not forbidden configurations. Precondition: `bound` has k and m.
[[nodiscard]] std::optional<Configuration> draw_forbidden_properties(const Shape& shape, const Bindings& bound,
                                                                     const Limits& limits, Choices& choices);

/// One with the four properties of which a facet attains bounds, up to 2⁻⁶⁰ to 2⁻⁴⁰⁰: the vertex opposite is α₀R off
/// its sphere, and its radius is 2ε where no edge would be longer than allowed. So the least distortion can carry it
/// past them. Nothing where another facet would be past them, as for most choices. Precondition: `bound` has k and m.
[[nodiscard]] std::optional<Configuration> draw_tight_properties(const Shape& shape, const Bindings& bound,
                                                                 const Limits& limits, Choices& choices);

}  // namespace delcert
