#pragma once

#include <optional>

#include "kernel/chart/chart_view.hpp"
#include "kernel/manifold/gluing/formula_atlas.hpp"
#include "support/progress.hpp"

namespace delcert {

/// A certified bound ξ of how much longer transitions between the charts of labels make vectors:
/// |A_i·Dτ(x)·A_j⁻¹v| ≤ (1 + ξ)|v|, for all labels i, j and all points x within a quarter of a sampling radius of p_j,
/// in the chart of j, that the patch of i may show. A little too large: by at most 1/32 of itself, but for what
/// intervals add. None if it is not certainly below the limit. Precondition: rounding to nearest.
template <int m>
[[nodiscard]] std::optional<Rational> measure_transitions(const FormulaAtlas<m>& atlas, const Rational& limit,
                                                          const Progress& progress);

/// No patches are so wide that their charts are distorted by this.
[[nodiscard]] inline Rational greatest_distortion() { return 4; }

/// Makes the patches of the atlas smaller until that is below 1/4, or they are as small as they can be. Throws
/// Rejection if it is 4 or more then: the radius is too large for the charts. Levels 1 and 2 need no small bound; for
/// level 2s `widen_patches` may make them wider again.
template <int m>
[[nodiscard]] Rational fit_patches(FormulaAtlas<m>& atlas, const Progress& progress);

/// What certification asks of an atlas whose transitions have this bound.
template <int m>
[[nodiscard]] ModelGeometry geometry_of(const FormulaAtlas<m>& atlas, const Rational& distortion);

}  // namespace delcert
