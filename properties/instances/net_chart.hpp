#pragma once

#include <vector>

#include "properties/instances/choices.hpp"
#include "properties/instances/net_object.hpp"

namespace delcert {

/// A transition between two charts, a homeomorphism of ℝ² or ℝ³: x ↦ Ax + Σ a|⟨w, x⟩ − b|. The rows of A one after
/// another, then a, w and b of each fold; without folds it is linear.
using ChartMap = std::vector<Rational>;

/// A rotation, stretches by factors in [1 − ξ, 1 + ξ], both ends among them, and another rotation; all rational. With
/// folds, often, up to three of them within a few units of the origin: these have a part of ξ.
/// Precondition: 0 ≤ ξ < 1.
[[nodiscard]] ChartMap draw_chart_map(int dimension, const Rational& distortion, Choices& choices);

/// Whether A and the folds show that | |φ(x) − φ(y)| − |x − y| | ≤ ξ|x − y| for all x and y: the Lipschitz constants
/// |a||w| of the folds, rounded up by at most 2⁻⁴⁰ of them, leave η ≥ 0 of ξ, and (1 − η)|x| ≤ |Ax| ≤ (1 + η)|x|, which
/// is decided exactly. Then φ is a bijection if ξ < 1. Throws InputError unless there are m² numbers, and 2m + 1 for
/// each fold.
[[nodiscard]] bool has_chart_distortion(const ChartMap& map, int dimension, const Rational& distortion);

[[nodiscard]] std::vector<Rational> chart_image(const ChartMap& map, const std::vector<Rational>& point);
[[nodiscard]] NetObject::Points chart_image(const ChartMap& map, const NetObject::Points& points);

/// Adds images of nets under such maps, and how thick and protected stars are.
void add_chart_quantities(Vocabulary& vocabulary);

}  // namespace delcert
