#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "kernel/run/chart_run.hpp"
#include "kernel/stars/stable_stars.hpp"
#include "proofs/certificate/claims.hpp"

namespace delcert {

/// Claims that are being derived from a run in charts, and what is derived alike in all families. Bounds are weaker
/// than what was found by a relative 2⁻²⁰ at least: a reader with other enclosures finds them too.
struct Derivation {
  const LevelSelection& selection;
  std::vector<std::string>& reasons;  ///< for levels that were selected and are not reached
  std::function<bool(const Rational&)>
      lies_within;  ///< whether what is so far from the centre of a chart is in its patch
  Rational shift;   ///< how far circumballs may be moved against the centre of a chart
  Claims claims = {};

  [[nodiscard]] bool selects(std::string_view level) const { return delcert::selects(selection, level); }
  /// Whether circumballs that have the label of a chart on them lie in its patch with their protection; if not, appends
  /// the reason why this level is not reached.
  [[nodiscard]] bool balls_fit(const char* level, const Rational& circumradius, const Rational& protection) const;

  /// Levels 1 and 2; the first of them by `derive_margins`.
  template <int m>
  void derive_stars(const ChartRun<m>& run) {
    if (!derive_margins(run.margins)) return;
    claims.manifold = manifold_claim(run.complex.label_complex(), run.complex.simplices().size(), true);
  }
  /// Level 2s, where level 2 is reached. `own_reach` is what the stars need in their own charts.
  void derive_stability(const StarStability& stability, double own_reach);
  /// Of isometric charts: states a reach of 4 circumradii and the shift, if it lies within a patch, since level 2s then
  /// follows from level 1.
  void widen_reach();
  bool derive_margins(const LocalMargins& found);
};

/// Levels 1, 2 and 2s of a run in charts whose patches are balls of one radius; `shift` as there. The stability is none
/// if it was not measured, as level 2s is not selected.
template <int m, class Atlas>
[[nodiscard]] Derivation derivation_in_patches(const Atlas& atlas, const ChartRun<m>& run,
                                               const std::optional<StarStability>& stability, const Rational& shift,
                                               const LevelSelection& selection, std::vector<std::string>& reasons) {
  Derivation result{selection, reasons, [patch = atlas.patch_radius()](const Rational& reach) { return reach < patch; },
                    shift};
  result.derive_stars(run);
  if (stability) result.derive_stability(*stability, run.margins.reach);
  return result;
}

}  // namespace delcert
