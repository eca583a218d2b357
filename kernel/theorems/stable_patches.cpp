#include "kernel/theorems/stable_patches.hpp"

#include <algorithm>
#include <set>

#include "kernel/parallel/parts.hpp"

namespace delcert {

namespace {

bool lacks_room(const StarFailure& failure) { return failure.cause != FailureCause::occupied_ball; }

/// Of these charts those that do not hold the balls of all stars that they have to show.
template <int m>
std::vector<Label> narrow_charts(const FormulaAtlas<m>& atlas, const PointSet<m>& points, const ModelGeometry& geometry,
                                 const ChartComplex<m>& complex, const std::vector<Label>& charts,
                                 const Progress& progress) {
  const ChartView<m> empty_view(atlas, points, geometry);
  std::vector<Label> result;
  in_parts(
      "widen patches", charts.size(), progress,
      [&](std::size_t first, std::size_t last) {
        ChartView<m> view = empty_view;
        std::vector<Label> found;
        for (std::size_t at = first; at < last; ++at) {
          const auto failures = stability_in_chart<m>(view, complex, charts[at]).failures;
          if (std::any_of(failures.begin(), failures.end(), lacks_room)) found.push_back(charts[at]);
        }
        return found;
      },
      [&](const std::vector<Label>& found) { result.insert(result.end(), found.begin(), found.end()); });
  return result;
}

}  // namespace

template <int m>
std::optional<StablePatches> widen_patches(FormulaAtlas<m>& atlas, const PointSet<m>& points,
                                           const ChartComplex<m>& complex, const StarStability& found,
                                           const Progress& progress) {
  std::set<Label> charts;
  for (const StarFailure& failure : found.failures) {
    if (lacks_room(failure)) charts.insert(failure.concerned.back());
  }
  std::vector<Label> narrow(charts.begin(), charts.end());
  const int before = atlas.patch_factor();
  for (int factor = before + 1; factor <= atlas.widest_patch_factor(); ++factor) {
    atlas.set_patch_factor(factor);
    const auto distortion = measure_transitions<m>(atlas, greatest_distortion(), progress);
    if (!distortion) break;
    const ModelGeometry geometry = geometry_of<m>(atlas, *distortion);
    narrow = narrow_charts<m>(atlas, points, geometry, complex, narrow, progress);
    if (!narrow.empty()) continue;
    StarStability stability = check_stability<m>(atlas, points, geometry, complex, progress);
    if (std::none_of(stability.failures.begin(), stability.failures.end(), lacks_room))
      return StablePatches{*distortion, std::move(stability)};
    break;
  }
  atlas.set_patch_factor(before);
  return std::nullopt;
}

#define DELCERT_INSTANTIATE(m)                                                                                         \
  template std::optional<StablePatches> widen_patches<m>(FormulaAtlas<m>&, const PointSet<m>&, const ChartComplex<m>&, \
                                                         const StarStability&, const Progress&);
DELCERT_INSTANTIATE(2)
DELCERT_INSTANTIATE(3)
#undef DELCERT_INSTANTIATE

}  // namespace delcert
