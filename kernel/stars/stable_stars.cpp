#include "kernel/stars/stable_stars.hpp"

#include <algorithm>
#include <limits>
#include <map>
#include <set>
#include <type_traits>

#include "kernel/chart/length_units.hpp"
#include "kernel/parallel/parts.hpp"
#include "kernel/simplex/dimensions.hpp"
#include "kernel/stars/rounded_balls.hpp"

namespace delcert {

namespace {

/// How little beyond a ball is looked at, as part of a sampling radius: most of the time goes there.
constexpr int look_beyond_part = 8;

void include(std::optional<LocalMargins>& margins, const LocalMargins& other) {
  if (margins) {
    margins->include(other);
  } else {
    margins = other;
  }
}

template <int m>
LabelSimplex<m> labels_of(Label i, const ChartSimplex<m>& others) {
  LabelSimplex<m> result;
  for (std::size_t at = 0; at < m; ++at) result[at] = others[at].index;
  result[m] = i.value;
  std::sort(result.begin(), result.end());
  return result;
}

/// Margins known so far, and what tells in doubles which simplices cannot change them.
template <int m>
struct KnownMargins {
  static constexpr bool has_doubles = m == 2 || m == 3;

  std::optional<LocalMargins> margins;
  std::conditional_t<has_doubles, RoundedBalls<m>, char> balls{};

  void look(const ChartView<m>& view) {
    if constexpr (has_doubles) {
      if (margins) balls.look(view, *margins);
      is_looking = margins.has_value();
    }
  }
  /// Whether it is certain that they do not change.
  [[nodiscard]] bool are_met_by(const PlaceSimplex<m>& simplex) const {
    if constexpr (has_doubles) {
      return is_looking && balls.are_met_by(simplex);
    } else {
      return false;
    }
  }
  void add(const LocalMargins& found, const ChartView<m>& view) {
    include(margins, found);
    if constexpr (has_doubles) {
      if (is_looking) {
        balls.compare_with(*margins);
      } else {
        look(view);
      }
    }
  }

  bool is_looking = false;
};

/// The stars that one chart has to show.
template <int m>
class ChartCheck {
 public:
  /// The margins found are those of simplices that are not better than what is known, which grows.
  ChartCheck(ChartView<m>& view, const ChartComplex<m>& complex, Label chart, KnownMargins<m>& known)
      : view_(view), complex_(complex), chart_(chart), known_(known), stars_(complex.neighbours(chart)) {
    std::erase_if(stars_, [&](Label i) { return !complex.is_interior(i); });
  }

  ChartStability run() {
    auto open = all_simplices();
    // What the chart has to show for the stars of a perturbed net, for all but a few; then the whole patch.
    for (const double half_reach : view_.half_reaches({9, 12})) {
      view_.look_by_halves(chart_, half_reach);
      known_.look(view_);
      std::vector<LabelSimplex<m>> rest;
      for (const auto& simplex : open) {
        if (look(simplex) == Outcome::sees_too_little) rest.push_back(simplex);
      }
      open = std::move(rest);
      if (open.empty()) break;
    }
    report_stars();
    return std::move(result_);
  }

 private:
  enum class Outcome { certified, fails, sees_too_little };

  /// Two stars share most of their simplices.
  [[nodiscard]] std::vector<LabelSimplex<m>> all_simplices() const {
    std::vector<LabelSimplex<m>> result;
    for (const Label i : stars_) {
      for (const auto& others : complex_.chart_star(i).simplices) result.push_back(labels_of<m>(i, others));
    }
    std::sort(result.begin(), result.end());
    result.erase(std::unique(result.begin(), result.end()), result.end());
    return result;
  }

  /// Notes the margins of the simplex, or why it fails. More of the patch cannot help where a point is to blame.
  Outcome look(const LabelSimplex<m>& labels) {
    PlaceSimplex<m> places;
    for (std::size_t corner = 0; corner <= m; ++corner) {
      const auto place = view_.find(Label(labels[corner]));
      if (!place) {
        reasons_[labels] = {FailureCause::undecided, "label " + std::to_string(labels[corner]) + " is not seen once"};
        return Outcome::sees_too_little;
      }
      places[corner] = *place;
    }
    if (known_.are_met_by(places)) {
      ladder_statistics().count(Rung::interval, view_.size());
      reasons_.erase(labels);
      return Outcome::certified;
    }
    LocalMargins margins;
    std::size_t witness = view_.size();
    const auto failure = chart_simplex_failure<m>(view_, places, 0, margins, witness, look_beyond_part);
    if (!failure) {
      reasons_.erase(labels);
      include(result_.margins, margins);
      known_.add(margins, view_);
      return Outcome::certified;
    }
    std::string text = simplex_text(std::vector<Label>(labels.begin(), labels.end())) + " " + failure->reason;
    const bool blames_a_point = witness < view_.size();
    if (blames_a_point) text += ": label " + std::to_string(view_.label(witness).value);
    reasons_[labels] = {failure->cause, std::move(text)};
    return blames_a_point ? Outcome::fails : Outcome::sees_too_little;
  }

  void report_stars() {
    result_.pairs = stars_.size();
    if (reasons_.empty()) return;
    for (const Label i : stars_) {
      auto first = reasons_.end();
      FailureCause cause = FailureCause::undecided;
      for (const auto& others : complex_.chart_star(i).simplices) {
        const auto found = reasons_.find(labels_of<m>(i, others));
        if (found == reasons_.end()) continue;
        if (first == reasons_.end() || found->first < first->first) first = found;
        if (found->second.cause == FailureCause::occupied_ball) cause = FailureCause::occupied_ball;
      }
      if (first == reasons_.end()) continue;
      result_.failures.push_back({i,
                                  "in the chart of label " + std::to_string(chart_.value) + " " + first->second.reason,
                                  {i, chart_},
                                  cause});
    }
  }

  ChartView<m>& view_;
  const ChartComplex<m>& complex_;
  Label chart_;
  KnownMargins<m>& known_;
  std::vector<Label> stars_;
  std::map<LabelSimplex<m>, SimplexFailure> reasons_;  // of the simplices that are not certified
  ChartStability result_;
};

/// Of simplices of the star of the chart's own label; none unless all are certified in the view.
template <int m>
std::optional<LocalMargins> margins_in_chart(const ChartView<m>& view, const std::vector<ChartSimplex<m>>& simplices) {
  std::optional<LocalMargins> result;
  for (const auto& others : simplices) {
    LocalMargins margins;
    std::size_t witness = 0;
    const auto places = places_of<m>(view, labels_of<m>(view.chart(), others));
    if (!places || chart_simplex_failure<m>(view, *places, 0, margins, witness, look_beyond_part)) return std::nullopt;
    include(result, margins);
  }
  return result;
}

/// Where all charts are isometric, a simplex that one chart certifies is certified in every chart that shows enough
/// about it. With r the largest circumradius and D the largest displacement, a ball of a simplex of star(i), j a label
/// of it, lies within D + 4r of p_j: |C − p′_i| ≤ r, |p′_i − p′_j| ≤ 2r, |p′_j − p_j| ≤ D. None if this does not
/// decide all.
template <int m>
std::optional<LocalMargins> margins_by_isometry(ChartView<m>& view, const ChartComplex<m>& complex) {
  if (!view.geometry().isometric_charts || LengthUnits(view.atlas()).vary() || !complex.agreement().failures.empty())
    return std::nullopt;
  std::optional<LocalMargins> result;
  double complete = std::numeric_limits<double>::infinity();
  double displacement = 0;
  for (std::uint32_t index = 0; index < complex.size(); ++index) {
    const Label chart(index);
    displacement = std::max(displacement, view.displacement(chart));
    const auto mine = complex.first_seen_from(chart);
    if (complex.is_interior(chart)) complete = std::min(complete, view.complete_radius_of_patch(chart));
    if (mine.empty()) continue;
    std::optional<LocalMargins> here;
    for (const double half_reach : view.half_reaches()) {
      view.look_by_halves(chart, half_reach);
      here = margins_in_chart<m>(view, mine);
      if (here) break;
    }
    if (!here) return std::nullopt;
    include(result, *here);
  }
  if (!result) return std::nullopt;
  const FilterGuard guard;
  const Filter reach = Filter::exactly(displacement) + Filter(4) * Filter::exactly(result->circumradius);
  const double room = (Filter::exactly(complete) - reach).lower();
  if (!(room > 0)) return std::nullopt;
  result->reach = reach.upper();
  result->protection = std::min(result->protection, room);
  return result;
}

}  // namespace

template <int m>
ChartStability stability_in_chart(ChartView<m>& scratch, const ChartComplex<m>& complex, Label chart) {
  KnownMargins<m> known;
  return ChartCheck<m>(scratch, complex, chart, known).run();
}

namespace {

/// `decided`: margins of all simplices in all charts, where they are known already.
template <int m>
StabilityInCharts stability_in_charts(const ChartView<m>& view, const ChartComplex<m>& complex, LabelRange charts,
                                      const std::optional<LocalMargins>& decided, const Progress& progress) {
  const auto is_interior = [&](Label i) { return complex.is_interior(i); };
  const LengthUnits units(view.atlas());
  StabilityInCharts result;
  result.margins = decided;
  const auto look = [&](std::size_t first, std::size_t last) {
    ChartView<m> scratch = view;
    // What was found before, in whatever chart, holds everywhere; where units vary, lengths mean something else.
    KnownMargins<m> known;
    if (!units.vary()) known.margins = result.margins;
    std::vector<std::pair<Label, ChartStability>> found;
    for (std::size_t at = first; at < last; ++at) {
      const Label chart(charts.first + at);
      if (!complex.is_interior(chart)) continue;
      if (decided) {
        const auto labels = complex.neighbours(chart);
        found.emplace_back(chart, ChartStability()).second.pairs =
            static_cast<std::size_t>(std::count_if(labels.begin(), labels.end(), is_interior));
      } else {
        if (units.vary()) known = {};
        found.emplace_back(chart, ChartCheck<m>(scratch, complex, chart, known).run());
      }
    }
    return found;
  };
  in_parts("compare stars in other charts", charts.size(), progress, look,
           [&](const std::vector<std::pair<Label, ChartStability>>& found) {
             for (const auto& [chart, here] : found) {
               result.pairs += here.pairs;
               result.failures.insert(result.failures.end(), here.failures.begin(), here.failures.end());
               if (here.margins) include(result.margins, here.margins->as_multiples(units, chart));
             }
           });
  return result;
}

}  // namespace

StarStability star_stability(StabilityInCharts all) {
  StarStability result;
  result.pairs = all.pairs;
  result.differing = all.failures.size();
  std::set<Label> stars;
  std::set<Label> occupied;
  for (const StarFailure& failure : all.failures) {
    stars.insert(failure.label);
    if (failure.cause == FailureCause::occupied_ball) occupied.insert(failure.label);
  }
  result.stars = stars.size();
  result.occupied = occupied.size();
  result.failures = std::move(all.failures);
  if (all.margins) result.margins = *all.margins;
  return result;
}

template <int m>
StabilityInCharts check_stability_in(const Atlas<m>& atlas, const PointSet<m>& points, const ModelGeometry& geometry,
                                     const ChartComplex<m>& complex, LabelRange charts, const Progress& progress) {
  return stability_in_charts<m>(ChartView<m>(atlas, points, geometry), complex, charts, std::nullopt, progress);
}

template <int m>
StarStability check_stability(const Atlas<m>& atlas, const PointSet<m>& points, const ModelGeometry& geometry,
                              const ChartComplex<m>& complex, const Progress& progress) {
  ChartView<m> view(atlas, points, geometry);
  progress("compare stars in other charts", 0, complex.size());
  const std::optional<LocalMargins> decided = margins_by_isometry<m>(view, complex);
  return star_stability(stability_in_charts<m>(view, complex, all_labels_of(complex), decided, progress));
}

#define DELCERT_INSTANTIATE(m)                                                                                \
  template ChartStability stability_in_chart<m>(ChartView<m>&, const ChartComplex<m>&, Label);                \
  template StabilityInCharts check_stability_in<m>(const Atlas<m>&, const PointSet<m>&, const ModelGeometry&, \
                                                   const ChartComplex<m>&, LabelRange, const Progress&);      \
  template StarStability check_stability<m>(const Atlas<m>&, const PointSet<m>&, const ModelGeometry&,        \
                                            const ChartComplex<m>&, const Progress&);
DELCERT_FOR_EACH_DIMENSION(DELCERT_INSTANTIATE)
#undef DELCERT_INSTANTIATE

}  // namespace delcert
