#include "kernel/theorems/seam_homes.hpp"

#include <algorithm>
#include <map>
#include <numeric>

#include "kernel/number/rounding_guard.hpp"
#include "kernel/theorems/blended_simplex.hpp"
#include "support/error.hpp"

namespace delcert {

namespace {

/// Labels that are to have one home.
class HomeGroups {
 public:
  explicit HomeGroups(std::size_t labels) : parent_(labels) { std::iota(parent_.begin(), parent_.end(), 0U); }

  [[nodiscard]] std::uint32_t group_of(std::uint32_t label) {
    while (parent_[label] != label) label = parent_[label] = parent_[parent_[label]];
    return label;
  }
  /// The least label stands for all.
  void join(std::uint32_t a, std::uint32_t b) {
    a = group_of(a);
    b = group_of(b);
    parent_[std::max(a, b)] = std::min(a, b);
  }

 private:
  std::vector<std::uint32_t> parent_;
};

template <int m>
class HomeChoice {
 public:
  HomeChoice(std::shared_ptr<const ChartGluing> gluing, const FormulaAtlas<m>& atlas, const PointSet<m>& points,
             const std::vector<LabelSimplex<m>>& simplices)
      : gluing_(std::move(gluing)),
        radius_(atlas.sampling_radius()),
        simplices_(simplices),
        groups_(atlas.size()),
        places_(atlas, points),
        points_(points) {
    for (std::uint32_t label = 0; label < atlas.size(); ++label)
      net_.push_back({atlas.home_chart(Label(label)), atlas.centre(Label(label))});
    first_ = net_;
    (void)note_folds(atlas, places_);
  }

  [[nodiscard]] bool has_folds() const { return has_folds_; }

  /// Gives one home to each group, and looks again. False if that cannot be.
  [[nodiscard]] bool choose() {
    std::map<std::uint32_t, std::vector<std::uint32_t>> members;
    for (std::uint32_t label = 0; label < net_.size(); ++label) members[groups_.group_of(label)].push_back(label);
    for (const auto& [group, labels] : members) {
      if (labels.size() > 1 && !give_one_home(labels)) return false;
    }
    const FormulaAtlas<m> atlas(gluing_, net_, radius_);
    return note_folds(atlas, GluedPlaces<m>(atlas, points_));
  }

  [[nodiscard]] SeamHomes<m> result(int rounds) && {
    SeamHomes<m> result{std::move(net_), std::move(points_), rounds, 0};
    for (std::size_t label = 0; label < first_.size(); ++label)
      result.changed += result.net[label].chart == first_[label].chart ? 0U : 1U;
    return result;
  }

 private:
  /// Joins the labels of simplices that may be folded. False if there are some whose labels had one home already.
  [[nodiscard]] bool note_folds(const FormulaAtlas<m>& atlas, const GluedPlaces<m>& places) {
    const RoundingGuard guard;
    BlendedSimplexCheck<m> check(atlas, places);
    has_folds_ = false;
    bool is_new = false;
    for (const LabelSimplex<m>& simplex : simplices_) {
      const BlendedSimplex found = check.measure(simplex);
      if (!found.is_seam || (!found.cause && found.contraction <= most_contraction)) continue;
      has_folds_ = true;
      for (const std::uint32_t label : simplex) {
        is_new = is_new || groups_.group_of(label) != groups_.group_of(simplex[0]);
        groups_.join(label, simplex[0]);
      }
    }
    return !has_folds_ || is_new;
  }

  /// To the chart in which most of them are at home at first, of those that show all.
  [[nodiscard]] bool give_one_home(const std::vector<std::uint32_t>& labels) {
    std::optional<std::size_t> chosen;
    std::size_t most = 0;
    for (std::size_t chart = 0; chart < places_.charts(); ++chart) {
      const auto is_shown = [&](std::uint32_t label) { return places_.place(chart, label).has_value(); };
      if (!std::all_of(labels.begin(), labels.end(), is_shown)) continue;
      const auto at_home = static_cast<std::size_t>(
          std::count_if(labels.begin(), labels.end(), [&](auto label) { return first_[label].chart == chart; }));
      if (chosen && at_home <= most) continue;
      chosen = chart;
      most = at_home;
    }
    if (!chosen) return false;
    for (const std::uint32_t label : labels) settle(label, *chosen);
    return true;
  }

  void settle(std::uint32_t label, std::size_t chart) {
    if (net_[label].chart == chart) return;
    net_[label].chart = chart;
    const Vector<Interval, m>& place = *places_.place(chart, label);
    for (std::size_t axis = 0; axis < m; ++axis) {
      const double middle = place[axis].lower() / 2 + place[axis].upper() / 2;
      net_[label].x[axis] = Rational::exactly(middle);
    }
    const FilterGuard guard;
    points_.place(Label(label), {});
  }

  std::shared_ptr<const ChartGluing> gluing_;
  Rational radius_;
  const std::vector<LabelSimplex<m>>& simplices_;
  HomeGroups groups_;
  GluedPlaces<m> places_;  // of the points at first
  PointSet<m> points_;
  std::vector<NetPlace<m>> net_;
  std::vector<NetPlace<m>> first_;
  bool has_folds_ = false;
};

}  // namespace

template <int m>
std::optional<SeamHomes<m>> homes_without_folds(std::shared_ptr<const ChartGluing> gluing, const FormulaAtlas<m>& atlas,
                                                const PointSet<m>& points,
                                                const std::vector<LabelSimplex<m>>& simplices, int most_rounds,
                                                const Progress& progress) {
  try {
    HomeChoice<m> choice(std::move(gluing), atlas, points, simplices);
    if (!choice.has_folds()) return std::nullopt;
    for (int round = 1; round <= most_rounds; ++round) {
      progress("choose home charts", static_cast<std::size_t>(round), static_cast<std::size_t>(most_rounds));
      if (!choice.choose()) return std::nullopt;
      if (!choice.has_folds()) return std::move(choice).result(round);
    }
  } catch (const Rejection&) {
    // Patches do not fit into the charts.
  } catch (const Undecided&) {
    // It is not certain what a chart shows.
  }
  return std::nullopt;
}

#define DELCERT_INSTANTIATE(m)                                                        \
  template std::optional<SeamHomes<m>> homes_without_folds<m>(                        \
      std::shared_ptr<const ChartGluing>, const FormulaAtlas<m>&, const PointSet<m>&, \
      const std::vector<LabelSimplex<m>>&, int, const Progress&);
DELCERT_INSTANTIATE(2)
DELCERT_INSTANTIATE(3)
#undef DELCERT_INSTANTIATE

}  // namespace delcert
