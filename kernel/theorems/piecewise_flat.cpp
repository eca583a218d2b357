#include "kernel/theorems/piecewise_flat.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>

#include "kernel/parallel/parts.hpp"
#include "kernel/simplex/altitude.hpp"
#include "kernel/simplex/circumsphere.hpp"
#include "kernel/simplex/dimensions.hpp"
#include "kernel/simplex/inertia.hpp"

namespace delcert {

namespace {

/// Labels of which the sides are put together by the thread that measures them: of so many near each other, most
/// facets have both sides there.
constexpr std::size_t labels_in_a_part = 64;

// Squared bounds of stretching are looked for among 1 + s, and 1 − s or powers of two, s = 2^e, 2^e·5/4, 2^e·3/2,
// 2^e·7/4 from 2^−30 on. All are exact, so it does not matter how they would be rounded.
constexpr int last_above = 144;  // s = 2^6; slivers may need much
constexpr int last_difference = 119;
constexpr int last_below = 123;

double squared_upper_stretch(int index) { return 1 + std::ldexp(4 + index % 4, index / 4 - 32); }
double squared_lower_stretch(int index) {
  return index <= last_difference ? 1 - std::ldexp(4 + index % 4, index / 4 - 32)
                                  : std::ldexp(1, last_difference - 3 - index);
}

Filter squared_upper(int index) { return Filter::exactly(squared_upper_stretch(index)); }
Filter squared_lower(int index) { return Filter::exactly(squared_lower_stretch(index)); }

bool is_positive_definite(const SymmetricMatrix<Filter>& matrix) {
  const auto result = inertia(matrix);
  return result.has_value() && result->positive == matrix.order();
}

/// factor·A − B.
SymmetricMatrix<Filter> combination(const Filter& factor, const SymmetricMatrix<Filter>& a,
                                    const SymmetricMatrix<Filter>& b) {
  SymmetricMatrix<Filter> result(a.order());
  for (std::size_t row = 0; row < a.order(); ++row) {
    for (std::size_t column = 0; column <= row; ++column)
      result(row, column) = factor * a(row, column) - b(row, column);
  }
  return result;
}

template <int m>
class FlatMetric {
 public:
  /// The view is copied.
  FlatMetric(const ChartView<m>& empty_view, const ChartComplex<m>& complex) : complex_(complex), view_(empty_view) {}

  void look_from(Label i) {
    const auto simplices = complex_.first_seen_from(i);
    if (simplices.empty()) return;
    std::vector<std::pair<LabelSimplex<m>, PlaceSimplex<m>>> found;
    for (const double half_reach : view_.half_reaches()) {
      view_.look_by_halves(i, half_reach);
      found.clear();
      for (const auto& others : simplices) {
        LabelSimplex<m> labels;
        for (std::size_t at = 0; at < m; ++at) labels[at] = others[at].index;
        labels[m] = i.value;
        std::sort(labels.begin(), labels.end());
        if (const auto places = places_of<m>(view_, labels)) found.emplace_back(labels, *places);
      }
      if (found.size() == simplices.size()) break;
    }
    if (found.size() < simplices.size()) result.stretch.is_complete = false;
    result.stretch.simplices += found.size();
    const FilterGuard guard;
    for (const auto& [labels, places] : found) measure(labels, places);
  }

  FlatSimplices<m> result;

 private:
  void measure(const LabelSimplex<m>& labels, const PlaceSimplex<m>& places) {
    const Curvature curvature = view_.geometry().curvature;
    const auto& metric = view_.filter_metric();
    std::array<ModelPoint<Filter, m>, static_cast<std::size_t>(m) + 1> at;
    for (std::size_t k = 0; k <= m; ++k)
      at[k] = exponential<Filter, m>(curvature, view_.position(LocalCoordinates::chart, places[k]));
    SymmetricMatrix<Filter> chords(at.size());
    SymmetricMatrix<Filter> lengths(at.size());
    for (std::size_t a = 1; a <= m; ++a) {
      for (std::size_t b = 0; b < a; ++b) {
        chords(a, b) = squared_chord<Filter, m>(curvature, metric, at[a], at[b]);
        lengths(a, b) = square(distance_of_chord(curvature, chords(a, b)));
      }
    }
    const auto flat = edge_gram_from_squared_edges(lengths);
    const bool exists = is_positive_definite(flat.gram());
    if (!exists) {
      ++result.stretch.unrealised;
    } else if (curvature != Curvature::zero) {
      stretch(flat.gram(), edge_gram_from_squared_edges(chords).gram());
    }
    add_sides(labels, flat, exists);
  }

  void add_sides(const LabelSimplex<m>& labels, const EdgeGram<Filter>& flat, bool exists) {
    const auto sphere = circumsphere(flat);
    for (std::size_t opposite = 0; opposite <= m; ++opposite) {
      FlatSide<m> side;
      std::size_t next = 0;
      for (std::size_t k = 0; k <= m; ++k) {
        if (k != opposite) side.facet[next++] = labels[k];
      }
      side.lower = -std::numeric_limits<double>::infinity();
      side.upper = std::numeric_limits<double>::infinity();
      const auto altitude = squared_altitude(flat, opposite);
      if (exists && sphere && altitude) {
        // The barycentric coordinate is the height over the facet in altitudes.
        Filter weight = sphere->barycentric[opposite] * square_root(*altitude);
        if constexpr (m == 2) {
          const Filter edge = flat.squared_edge((opposite + 1) % 3, (opposite + 2) % 3);
          weight = twice(weight) / square_root(edge);
        }
        side.lower = weight.lower();
        side.upper = weight.upper();
      }
      result.sides.push_back(side);
    }
  }

  void stretch(const SymmetricMatrix<Filter>& flat, const SymmetricMatrix<Filter>& chords) {
    int& above = result.stretch.above;
    int& below = result.stretch.below;
    while (above <= last_above && !is_positive_definite(combination(squared_upper(above), flat, chords))) ++above;
    while (below <= last_below && !is_positive_definite(combination(squared_lower(below), flat, chords).negated()))
      ++below;
  }

  const ChartComplex<m>& complex_;
  ChartView<m> view_;
};

/// Counts the facet of these two sides. Precondition: a `FilterGuard` is alive.
template <int m>
void count_hinge(const FlatSide<m>& one, const FlatSide<m>& other, HingeCount& result) {
  ++result.hinges;
  const Filter sum = Filter::between(one.lower, one.upper) + Filter::between(other.lower, other.upper);
  const Verdict ordered = less(Filter(0), sum);
  if (is_refuted(ordered)) ++result.not_delaunay;
  if (is_undecided(ordered)) ++result.undecided;
  result.least_weight = std::min(result.least_weight, sum.lower());
}

/// Counts the facets of which both sides are there, and leaves the other sides.
template <int m>
HingeCount count_pairs(std::vector<FlatSide<m>>& sides) {
  std::sort(sides.begin(), sides.end(), [](const auto& a, const auto& b) { return a.facet < b.facet; });
  const FilterGuard guard;
  HingeCount result;
  std::size_t left = 0;
  for (std::size_t at = 0; at < sides.size(); ++at) {
    if (at + 1 < sides.size() && sides[at].facet == sides[at + 1].facet) {
      count_hinge<m>(sides[at], sides[at + 1], result);
      ++at;
    } else {
      sides[left++] = sides[at];
    }
  }
  sides.resize(left);
  return result;
}

/// Puts together what was measured part by part. Only sides that wait for the other one are kept, which are few where
/// labels that follow each other are near each other.
template <int m>
class FlatParts {
 public:
  void include(const FlatSimplices<m>& found) {
    const FilterGuard guard;
    result_.stretch.include(found.stretch);
    result_.hinges.include(found.hinges);
    for (const FlatSide<m>& side : found.sides) {
      const auto [other, is_first] = waiting_.try_emplace(side.facet, side);
      if (is_first) continue;
      count_hinge<m>(other->second, side, result_.hinges);
      waiting_.erase(other);
    }
  }
  [[nodiscard]] FlatSimplices<m> finished() && {
    for (const auto& [facet, side] : waiting_) result_.sides.push_back(side);
    return std::move(result_);
  }

 private:
  FlatSimplices<m> result_;
  std::map<std::array<std::uint32_t, static_cast<std::size_t>(m)>, FlatSide<m>> waiting_;
};

}  // namespace

void FlatStretch::include(const FlatStretch& other) {
  simplices += other.simplices;
  unrealised += other.unrealised;
  above = std::max(above, other.above);
  below = std::max(below, other.below);
  is_complete = is_complete && other.is_complete;
}

void HingeCount::include(const HingeCount& other) {
  hinges += other.hinges;
  not_delaunay += other.not_delaunay;
  undecided += other.undecided;
  least_weight = std::min(least_weight, other.least_weight);
}

template <int m>
FlatSimplices<m> measure_flat_simplices(const Atlas<m>& atlas, const PointSet<m>& points, const ModelGeometry& geometry,
                                        const ChartComplex<m>& complex, LabelRange labels, const Progress& progress) {
  const ChartView<m> empty_view(atlas, points, geometry);
  const auto look = [&](std::size_t first, std::size_t last) {
    FlatMetric<m> metric(empty_view, complex);
    for (std::size_t at = first; at < last; ++at) metric.look_from(Label(labels.first + at));
    metric.result.hinges = count_pairs<m>(metric.result.sides);
    return std::move(metric.result);
  };
  FlatParts<m> all;
  in_parts<labels_in_a_part>("measure the flat metric", labels.size(), progress, look,
                             [&all](const FlatSimplices<m>& found) { all.include(found); });
  return std::move(all).finished();
}

template <int m>
HingeCount count_hinges(std::vector<FlatSide<m>> sides) {
  return count_pairs<m>(sides);
}

PiecewiseFlatReport piecewise_flat_report(const FlatStretch& stretch, const HingeCount& hinges, Curvature curvature,
                                          double circumradius) {
  PiecewiseFlatReport report;
  report.unrealised = stretch.unrealised;
  report.hinges = hinges.hinges;
  report.not_delaunay = hinges.not_delaunay;
  report.undecided = hinges.undecided + (stretch.is_complete ? 0 : 1);
  report.least_weight = hinges.least_weight;
  if (!stretch.is_complete || stretch.simplices == 0 || stretch.unrealised > 0) return report;
  if (curvature == Curvature::zero) {
    report.lower = report.upper = 1;
    return report;
  }
  if (stretch.above > last_above || stretch.below > last_below) return report;
  const FilterGuard guard;
  const Filter cosine = cosine_of_root(curvature, square(Filter::exactly(circumradius)));
  if (!is_proved(less(Filter(0), cosine))) return report;
  const Filter shrink = curvature == Curvature::positive ? cosine : Filter(1) / cosine;
  report.lower = (square_root(squared_lower(stretch.below)) * shrink).lower();
  report.upper = (square_root(squared_upper(stretch.above)) / shrink).upper();
  return report;
}

template <int m>
PiecewiseFlatReport measure_piecewise_flat(const Atlas<m>& atlas, const PointSet<m>& points,
                                           const ModelGeometry& geometry, const ChartComplex<m>& complex,
                                           double circumradius, const Progress& progress) {
  const auto all = measure_flat_simplices<m>(atlas, points, geometry, complex, all_labels_of(complex), progress);
  return piecewise_flat_report(all.stretch, all.hinges, geometry.curvature, circumradius);
}

#define DELCERT_INSTANTIATE(m)                                                                                      \
  template FlatSimplices<m> measure_flat_simplices<m>(const Atlas<m>&, const PointSet<m>&, const ModelGeometry&,    \
                                                      const ChartComplex<m>&, LabelRange, const Progress&);         \
  template HingeCount count_hinges<m>(std::vector<FlatSide<m>>);                                                    \
  template PiecewiseFlatReport measure_piecewise_flat<m>(const Atlas<m>&, const PointSet<m>&, const ModelGeometry&, \
                                                         const ChartComplex<m>&, double, const Progress&);
DELCERT_FOR_EACH_DIMENSION(DELCERT_INSTANTIATE)
#undef DELCERT_INSTANTIATE

}  // namespace delcert
