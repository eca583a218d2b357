#include "kernel/delaunay/stable_stars.hpp"

#include <algorithm>
#include <map>

#include "kernel/simplex/dimensions.hpp"

namespace delcert {

namespace {

template <int m>
class StabilityCheck {
 public:
  StabilityCheck(const Atlas<m>& atlas, const PointSet<m>& points, const ModelGeometry& geometry,
                 const SpaceFormComplex<m>& complex)
      : complex_(complex), view_(atlas, points, geometry), differs_(complex.size(), false) {}

  void look_from(Label chart) {
    const auto labels = complex_.neighbours(chart);
    std::vector<std::string> reasons;  // by position in labels; empty where nothing is wrong
    LocalMargins margins;
    bool has_margins = false;
    // Enough for the stars of the neighbours in a perturbed net; then the whole patch.
    for (const int half_reach : view_.half_reaches({12})) {
      view_.look_by_halves(chart, half_reach);
      blames_a_point_ = false;
      known_.clear();
      reasons.assign(labels.size(), {});
      has_margins = false;
      for (std::size_t at = 0; at < labels.size(); ++at) {
        if (complex_.is_interior(labels[at])) reasons[at] = failure_of(labels[at], margins, has_margins);
      }
      const bool is_fine =
          std::all_of(reasons.begin(), reasons.end(), [](const auto& reason) { return reason.empty(); });
      if (is_fine || blames_a_point_) break;
    }
    for (std::size_t at = 0; at < labels.size(); ++at) {
      if (!complex_.is_interior(labels[at])) continue;
      ++result.pairs;
      if (reasons[at].empty()) continue;
      ++result.differing;
      differs_[labels[at].value] = true;
      result.failures.push_back({labels[at],
                                 "in the chart of label " + std::to_string(chart.value) + " " + reasons[at],
                                 {labels[at], chart}});
    }
    if (!has_margins) return;
    if (has_any_) {
      result.margins.include(margins);
    } else {
      result.margins = margins;
    }
    has_any_ = true;
  }

  StarStability finish() {
    result.stars = static_cast<std::size_t>(std::count(differs_.begin(), differs_.end(), true));
    return std::move(result);
  }

  StarStability result;

 private:
  /// Why the star of this label is not certified to be the same in the chart at hand; empty if it is.
  std::string failure_of(Label i, LocalMargins& margins, bool& has_margins) {
    for (const auto& others : complex_.star(i)) {
      LabelSimplex<m> labels;
      std::copy(others.begin(), others.end(), labels.begin());
      labels[m] = i.value;
      std::sort(labels.begin(), labels.end());
      // Two stars share a simplex, so what was found is kept.
      const auto [entry, is_new] = known_.try_emplace(labels);
      if (is_new) entry->second = simplex_failure(labels, margins, has_margins);
      if (!entry->second.empty()) return entry->second;
    }
    return {};
  }

  std::string simplex_failure(const LabelSimplex<m>& labels, LocalMargins& margins, bool& has_margins) {
    PlaceSimplex<m> places;
    for (std::size_t corner = 0; corner <= m; ++corner) {
      const auto place = view_.find(Label(labels[corner]));
      if (!place) return "label " + std::to_string(labels[corner]) + " is not seen once";
      places[corner] = *place;
    }
    LocalMargins here;
    std::size_t witness = view_.size();
    if (const auto reason = chart_simplex_failure<m>(view_, places, 0, here, witness)) {
      std::string text = simplex_text(std::vector<Label>(labels.begin(), labels.end())) + " " + *reason;
      blames_a_point_ = blames_a_point_ || witness < view_.size();
      if (witness < view_.size()) text += ": label " + std::to_string(view_.label(witness).value);
      return text;
    }
    if (has_margins) {
      margins.include(here);
    } else {
      margins = here;
    }
    has_margins = true;
    return {};
  }

  const SpaceFormComplex<m>& complex_;
  ChartView<m> view_;
  std::map<LabelSimplex<m>, std::string> known_;
  std::vector<bool> differs_;
  bool has_any_ = false;
  bool blames_a_point_ = false;
};

}  // namespace

template <int m>
StarStability check_stability(const Atlas<m>& atlas, const PointSet<m>& points, const ModelGeometry& geometry,
                              const SpaceFormComplex<m>& complex, const Progress& progress) {
  StabilityCheck<m> check(atlas, points, geometry, complex);
  for (std::uint32_t index = 0; index < complex.size(); ++index) {
    if (index % 256 == 0) progress("compare stars in other charts", index, complex.size());
    if (complex.is_interior(Label(index))) check.look_from(Label(index));
  }
  progress("compare stars in other charts", complex.size(), complex.size());
  return check.finish();
}

#define DELCERT_INSTANTIATE(m)                                                                         \
  template StarStability check_stability<m>(const Atlas<m>&, const PointSet<m>&, const ModelGeometry&, \
                                            const SpaceFormComplex<m>&, const Progress&);
DELCERT_FOR_EACH_DIMENSION(DELCERT_INSTANTIATE)
#undef DELCERT_INSTANTIATE

}  // namespace delcert
