#pragma once

#include <optional>

#include "kernel/manifold/gluing/atlas_distortion.hpp"
#include "kernel/stars/stable_stars.hpp"

namespace delcert {

/// Level 2s in patches that are wider than before.
struct StablePatches {
  Rational distortion;  ///< of the transitions between them
  StarStability stability;
};

/// Level 2s asks that a patch holds the balls of all stars around it, and a chart may show these larger than their own
/// charts do. Makes all patches wider, by one sampling radius at a time, until no star lacks room: what is still found
/// of stars then is that a point is in their balls, or nothing. None, and the atlas is as it was, if no patches that
/// fit are wide enough, or if charts are distorted by 4 or more within them. `found` is what `check_stability` says of
/// the patches that the atlas has; what was certified in these holds in wider ones. Precondition: as for
/// `check_stability`.
template <int m>
[[nodiscard]] std::optional<StablePatches> widen_patches(FormulaAtlas<m>& atlas, const PointSet<m>& points,
                                                         const ChartComplex<m>& complex, const StarStability& found,
                                                         const Progress& progress);

}  // namespace delcert
