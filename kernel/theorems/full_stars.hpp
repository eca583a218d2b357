#pragma once

#include <vector>

#include "kernel/manifold/submanifold/tangent_chart.hpp"
#include "kernel/stars/chart_complex.hpp"

namespace delcert {

/// Level 1f (docs/levels/submanifolds.md): whether the star of every label, straight in the chart of that label with
/// the centres of the charts as vertices, is embedded and full: every face of dimension m−1 at the label is in exactly
/// two simplices, which are on different sides of it, and the ray through the barycentre of the first simplex is in no
/// other. One failure for each star that is not. Decided exactly. `simplices`: all m-simplices of the complex, each
/// once. Precondition: rounding to nearest.
template <int m>
[[nodiscard]] std::vector<StarFailure> check_full_stars(const std::vector<TangentChart>& charts,
                                                        const std::vector<LabelSimplex<m>>& simplices);

}  // namespace delcert
