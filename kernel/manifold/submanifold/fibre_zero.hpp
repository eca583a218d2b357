#pragma once

#include <optional>
#include <vector>

#include "kernel/manifold/submanifold/tangent_chart.hpp"

namespace delcert {

/// The zero of f over chart coordinates y: an enclosure z of its heights, so that for each of the coordinates enclosed
/// f has exactly one zero c + T(y, z) with heights in some neighbourhood of the enclosure. Newton's method proposes,
/// from the heights 0 on; Krawczyk's test decides. S = Interval (needs a `RoundingGuard`) or BigInterval. None if the
/// test fails: no zero near by, a singular derivative, or enclosures that are too wide.
template <class S>
[[nodiscard]] std::optional<std::vector<S>> zero_on_fibre(FormulaEvaluation<S>& f, const EnclosedChart<S>& chart,
                                                          const S* y);

}  // namespace delcert
