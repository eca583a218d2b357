#pragma once

#include <vector>

#include "properties/instances/choices.hpp"
#include "properties/instances/net_object.hpp"

namespace delcert {

/// The rows of an invertible linear map of ℝ² or ℝ³, a transition between two charts, one after another.
using ChartMap = std::vector<Rational>;

/// A rotation, stretches by factors in [1 − ξ, 1 + ξ], both ends among them, and another rotation; all rational.
/// Precondition: 0 ≤ ξ < 1.
[[nodiscard]] ChartMap draw_chart_map(int dimension, const Rational& distortion, Choices& choices);

/// Whether (1 − ξ)|x| ≤ |Ax| ≤ (1 + ξ)|x| for all x, exactly; throws InputError unless there are m² numbers.
[[nodiscard]] bool has_chart_distortion(const ChartMap& map, int dimension, const Rational& distortion);

[[nodiscard]] std::vector<Rational> chart_image(const ChartMap& map, const std::vector<Rational>& point);
[[nodiscard]] NetObject::Points chart_image(const ChartMap& map, const NetObject::Points& points);

/// Adds images of nets under such maps, and how thick and protected stars are.
void add_chart_quantities(Vocabulary& vocabulary);

}  // namespace delcert
