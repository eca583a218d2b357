#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "kernel/number/rational.hpp"
#include "kernel/simplex/vector.hpp"

namespace delcert {

/// What Definition 2 of the paper asks of a forbidden configuration, as lengths; the flake parameter is a ratio.
struct NetForbiddenParameters {
  Rational flake_parameter;  ///< Γ₀, in (0, 1]
  Rational sampling_radius;  ///< ε′
  Rational protection;       ///< δ ≥ 0
};

/// The numbers of the points of some forbidden configuration (def:forbidden.config), or nothing if there is none: a
/// Γ₀-flake of dimension 2 … m + 1 with a facet that has a circumscribing ball of radius below ε′ and the opposite
/// vertex within δ of its boundary. Exact. Facets are found by walking all simplices of circumradius below ε′; what the
/// filter cannot exclude is decided in rationals.
template <int m>
[[nodiscard]] std::optional<std::vector<std::uint32_t>> find_forbidden_configuration(
    const std::vector<Vector<Rational, m>>& points, const NetForbiddenParameters& parameters);

}  // namespace delcert
