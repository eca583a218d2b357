#include "kernel/theorems/piecewise_flat.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "kernel/parallel/parts.hpp"
#include "kernel/simplex/altitude.hpp"
#include "kernel/simplex/circumsphere.hpp"
#include "kernel/simplex/dimensions.hpp"
#include "kernel/simplex/inertia.hpp"

namespace delcert {

namespace {

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

/// A facet with the height of the circumcentre of one of its simplices over it, towards the opposite vertex; on a
/// surface in halves of the edge, which makes it the cotangent of the opposite angle.
template <int m>
struct Side {
  std::array<std::uint32_t, static_cast<std::size_t>(m)> facet{};
  double lower = 0;
  double upper = 0;
};

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

  /// Takes over what another one saw.
  void include(const FlatMetric& other) {
    sides_.insert(sides_.end(), other.sides_.begin(), other.sides_.end());
    above_ = std::max(above_, other.above_);
    below_ = std::max(below_, other.below_);
    is_complete_ = is_complete_ && other.is_complete_;
    report_.unrealised += other.report_.unrealised;
  }

  void look_from(Label i) {
    const auto simplices = complex_.first_seen_from(i);
    if (simplices.empty()) return;
    std::vector<std::pair<LabelSimplex<m>, PlaceSimplex<m>>> found;
    for (const int half_reach : view_.half_reaches()) {
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
    if (found.size() < simplices.size()) is_complete_ = false;
    const FilterGuard guard;
    for (const auto& [labels, places] : found) measure(labels, places);
  }

  PiecewiseFlatReport finish(double circumradius) {
    compare_sides();
    bound_stretch(circumradius);
    return report_;
  }

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
      ++report_.unrealised;
    } else if (curvature != Curvature::zero) {
      stretch(flat.gram(), edge_gram_from_squared_edges(chords).gram());
    }
    add_sides(labels, flat, exists);
  }

  void add_sides(const LabelSimplex<m>& labels, const EdgeGram<Filter>& flat, bool exists) {
    const auto sphere = circumsphere(flat);
    for (std::size_t opposite = 0; opposite <= m; ++opposite) {
      Side<m> side;
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
      sides_.push_back(side);
    }
  }

  void stretch(const SymmetricMatrix<Filter>& flat, const SymmetricMatrix<Filter>& chords) {
    while (above_ <= last_above && !is_positive_definite(combination(squared_upper(), flat, chords))) ++above_;
    while (below_ <= last_below && !is_positive_definite(combination(squared_lower(), flat, chords).negated()))
      ++below_;
  }

  [[nodiscard]] Filter squared_upper() const { return Filter::exactly(squared_upper_stretch(above_)); }
  [[nodiscard]] Filter squared_lower() const { return Filter::exactly(squared_lower_stretch(below_)); }

  void compare_sides() {
    std::sort(sides_.begin(), sides_.end(), [](const auto& a, const auto& b) { return a.facet < b.facet; });
    const FilterGuard guard;
    report_.least_weight = std::numeric_limits<double>::infinity();
    for (std::size_t at = 0; at + 1 < sides_.size(); ++at) {
      if (sides_[at].facet != sides_[at + 1].facet) continue;
      ++report_.hinges;
      const Filter sum = Filter::between(sides_[at].lower, sides_[at].upper) +
                         Filter::between(sides_[at + 1].lower, sides_[at + 1].upper);
      const Verdict ordered = less(Filter(0), sum);
      if (is_refuted(ordered)) ++report_.not_delaunay;
      if (is_undecided(ordered)) ++report_.undecided;
      report_.least_weight = std::min(report_.least_weight, sum.lower());
      ++at;
    }
    if (!is_complete_) ++report_.undecided;
  }

  void bound_stretch(double circumradius) {
    const Curvature curvature = view_.geometry().curvature;
    if (!is_complete_ || sides_.empty() || report_.unrealised > 0) return;
    if (curvature == Curvature::zero) {
      report_.lower = report_.upper = 1;
      return;
    }
    if (above_ > last_above || below_ > last_below) return;
    const FilterGuard guard;
    const Filter cosine = cosine_of_root(curvature, square(Filter::exactly(circumradius)));
    if (!is_proved(less(Filter(0), cosine))) return;
    const Filter shrink = curvature == Curvature::positive ? cosine : Filter(1) / cosine;
    report_.lower = (square_root(squared_lower()) * shrink).lower();
    report_.upper = (square_root(squared_upper()) / shrink).upper();
  }

  const ChartComplex<m>& complex_;
  ChartView<m> view_;
  std::vector<Side<m>> sides_;
  int above_ = 0;
  int below_ = 0;
  bool is_complete_ = true;
  PiecewiseFlatReport report_;
};

}  // namespace

template <int m>
PiecewiseFlatReport measure_piecewise_flat(const Atlas<m>& atlas, const PointSet<m>& points,
                                           const ModelGeometry& geometry, const ChartComplex<m>& complex,
                                           double circumradius, const Progress& progress) {
  const ChartView<m> empty_view(atlas, points, geometry);
  FlatMetric<m> all(empty_view, complex);
  const auto look = [&](std::size_t first, std::size_t last) {
    FlatMetric<m> metric(empty_view, complex);
    for (std::size_t index = first; index < last; ++index) metric.look_from(Label(index));
    return metric;
  };
  in_parts("measure the flat metric", complex.size(), progress, look,
           [&all](const FlatMetric<m>& found) { all.include(found); });
  return all.finish(circumradius);
}

#define DELCERT_INSTANTIATE(m)                                                                                      \
  template PiecewiseFlatReport measure_piecewise_flat<m>(const Atlas<m>&, const PointSet<m>&, const ModelGeometry&, \
                                                         const ChartComplex<m>&, double, const Progress&);
DELCERT_FOR_EACH_DIMENSION(DELCERT_INSTANTIATE)
#undef DELCERT_INSTANTIATE

}  // namespace delcert
