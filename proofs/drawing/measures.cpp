#include "proofs/drawing/measures.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "proofs/drawing/facet_table.hpp"
#include "proofs/drawing/simplex_shape.hpp"

namespace delcert {

namespace {

/// A label, moved by an element.
struct MovedLabel {
  std::uint32_t label;
  std::uint32_t element;
  friend bool operator==(const MovedLabel&, const MovedLabel&) = default;
};

using Place = ApproximateManifold::ChartPlace;

constexpr std::size_t expected_valence = 8;  ///< of a surface; lists may be longer
constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

struct Shown {
  MovedLabel point;
  std::uint32_t before;  ///< where there is another one of the same label, or none
  bool is_other;         ///< whether it is shown, and is no vertex of the simplex that is being measured
  Place place;
};

class StarMeasurement {
 public:
  StarMeasurement(ApproximateManifold& manifold, const std::vector<DrawnSimplex>& simplices, std::size_t labels)
      : manifold_(manifold),
        axes_(manifold.dimension()),
        simplices_(simplices),
        stars_(labels),
        neighbours_(labels),
        last_of_label_(labels, none) {
    for (auto& star : stars_) star.reserve(expected_valence);
    for (auto& list : neighbours_) list.reserve(expected_valence);
    for (const DrawnSimplex& simplex : simplices) {
      for (std::size_t a = 0; a < simplex.labels.size(); ++a) {
        stars_[simplex.labels[a]].push_back(simplex.position);
        for (std::size_t b = 0; b < simplex.labels.size(); ++b) {
          if (a == b) continue;
          std::vector<MovedLabel>& list = neighbours_[simplex.labels[a]];
          const MovedLabel neighbour{simplex.labels[b],
                                     manifold.relative_element(simplex.elements[a], simplex.elements[b])};
          if (std::find(list.begin(), list.end(), neighbour) == list.end()) list.push_back(neighbour);
        }
      }
    }
  }

  void measure(std::uint32_t label, SimplexMeasures& result) {
    std::vector<std::size_t> star = stars_[label];
    // In isometric charts one is enough.
    if (manifold_.has_isometric_charts())
      std::erase_if(star, [&](std::size_t at) { return simplices_[at].labels[0] != label; });
    if (star.empty()) return;
    show(label);
    for (const std::size_t at : star) measure(label, simplices_[at], result);
  }

 private:
  /// What chart `label` shows of neighbours of neighbours; where simplices are missing, of all points.
  void show(std::uint32_t label) {
    for (const Shown& shown : shown_) last_of_label_[shown.point.label] = none;
    shown_.clear();
    if (!manifold_.is_closed()) {
      for (std::uint32_t other = 0; other < stars_.size(); ++other) show(label, {other, 0});
      return;
    }
    show(label, {label, 0});
    for (const MovedLabel& first : neighbours_[label]) {
      show(label, first);
      for (const MovedLabel& second : neighbours_[first.label])
        show(label, {second.label, manifold_.product(first.element, second.element)});
    }
  }

  void show(std::uint32_t label, const MovedLabel& point) {
    if (find(point) != nullptr) return;
    const auto place = manifold_.in_chart(label, point.label, point.element);
    std::uint32_t& last = last_of_label_[point.label];
    shown_.push_back({point, last, place.has_value(), place.value_or(Place{})});
    last = static_cast<std::uint32_t>(shown_.size() - 1);
  }

  [[nodiscard]] Shown* find(const MovedLabel& point) {
    std::uint32_t at = last_of_label_[point.label];
    while (at != none && shown_[at].point != point) at = shown_[at].before;
    return at == none ? nullptr : &shown_[at];
  }

  void measure(std::uint32_t label, const DrawnSimplex& simplex, SimplexMeasures& result) {
    const std::size_t m = simplex.labels.size() - 1;
    const std::size_t own = static_cast<std::size_t>(std::find(simplex.labels.begin(), simplex.labels.end(), label) -
                                                     simplex.labels.begin());
    std::array<Shown*, ApproximateShape::most_vertices> vertices{};
    for (std::size_t k = 0; k <= m; ++k) {
      const MovedLabel vertex{simplex.labels[k],
                              manifold_.relative_element(simplex.elements[own], simplex.elements[k])};
      vertices[k] = find(vertex);
      if (vertices[k] == nullptr || !vertices[k]->is_other) return;
    }
    const SquaredEdges squares = squares_between(
        m + 1, [&](std::size_t j, std::size_t k) { return squared_distance(vertices[j]->place, vertices[k]->place); });
    const ApproximateShape shape = approximate_shape(m, squares);
    Place centre{};
    for (std::size_t k = 0; k <= m; ++k) {
      for (std::size_t axis = 0; axis < axes_; ++axis) centre[axis] += shape.centre[k] * vertices[k]->place[axis];
    }
    const double nearest = squared_distance_to_others(centre, std::span(vertices).first(m + 1));
    const double unit = manifold_.unit(label);
    const auto least = [&](std::vector<double>& all, double value) {
      double& kept = all[simplex.position];
      kept = std::isnan(kept) ? value : std::min(kept, value);
    };
    least(result.protection, (std::sqrt(nearest) - shape.circumradius) / unit);
    least(result.thickness, shape.thickness);
    double& radius = result.circumradius[simplex.position];
    radius = std::isnan(radius) ? shape.circumradius / unit : std::max(radius, shape.circumradius / unit);
  }

  /// Of all points that are shown besides the vertices the least.
  [[nodiscard]] double squared_distance_to_others(const Place& centre, std::span<Shown* const> vertices) const {
    for (Shown* vertex : vertices) vertex->is_other = false;
    double nearest = std::numeric_limits<double>::infinity();
    for (const Shown& point : shown_) {
      const double distance = squared_distance(centre, point.place);
      if (point.is_other && distance < nearest) nearest = distance;
    }
    for (Shown* vertex : vertices) vertex->is_other = true;
    return nearest;
  }

  [[nodiscard]] double squared_distance(const Place& a, const Place& b) const {
    double sum = 0;
    for (std::size_t axis = 0; axis < axes_; ++axis) sum += (a[axis] - b[axis]) * (a[axis] - b[axis]);
    return sum;
  }

  ApproximateManifold& manifold_;
  std::size_t axes_;  ///< of a chart
  const std::vector<DrawnSimplex>& simplices_;
  std::vector<std::vector<std::size_t>> stars_;
  std::vector<std::vector<MovedLabel>> neighbours_;
  std::vector<Shown> shown_;
  std::vector<std::uint32_t> last_of_label_;  ///< in shown_, or none
};

/// What each simplex adds at its facets; none where there is no piecewise flat metric.
std::optional<ApproximateShape::Numbers> facet_heights(const ApproximateManifold& manifold,
                                                       const DrawnSimplex& simplex) {
  const std::size_t m = simplex.labels.size() - 1;
  const auto squares = manifold.squared_edges(simplex);
  if (!squares) return std::nullopt;
  const ApproximateShape shape = approximate_shape(m, *squares);
  ApproximateShape::Numbers result{};
  for (std::size_t k = 0; k <= m; ++k) {
    const double height = shape.centre[k] * shape.altitudes[k];
    // cot α = height / half of the edge.
    result[k] = m == 2 ? 2 * height / std::sqrt((*squares)[(k + 1) % 3][(k + 2) % 3])
                       : height / manifold.unit(simplex.labels[k]);
  }
  return result;
}

void measure_hinges(const ApproximateManifold& manifold, const std::vector<DrawnSimplex>& simplices,
                    SimplexMeasures& result) {
  if (manifold.dimension() < 2) return;
  const std::size_t size = manifold.dimension() + 1;
  std::vector<std::uint32_t> labels;
  std::vector<double> heights;
  labels.reserve(simplices.size() * size);
  heights.reserve(simplices.size() * size);
  for (const DrawnSimplex& simplex : simplices) {
    const auto here = facet_heights(manifold, simplex);
    if (!here) return;
    labels.insert(labels.end(), simplex.labels.begin(), simplex.labels.end());
    heights.insert(heights.end(), here->begin(), here->begin() + static_cast<std::ptrdiff_t>(size));
  }
  result.hinge.assign(simplices.size(), std::numeric_limits<double>::quiet_NaN());
  const FacetTable facets(labels, size);
  const auto height_at = [&](const FacetTable::Side& side) { return heights[side.simplex * size + side.without]; };
  for (std::size_t at = 1; at < facets.sides().size(); ++at) {
    if (!facets.is_same_as_before(at)) continue;
    const FacetTable::Side& first = facets.sides()[at - 1];
    const FacetTable::Side& second = facets.sides()[at];
    const double sum = height_at(first) + height_at(second);
    for (const std::size_t simplex : {first.simplex, second.simplex}) {
      double& kept = result.hinge[simplex];
      kept = std::isnan(kept) ? sum : std::min(kept, sum);
    }
  }
}

}  // namespace

SimplexMeasures measure_simplices(ApproximateManifold& manifold, const std::vector<DrawnSimplex>& simplices,
                                  std::size_t labels) {
  SimplexMeasures result;
  for (std::vector<double>* all : {&result.protection, &result.thickness, &result.circumradius})
    all->assign(simplices.size(), std::numeric_limits<double>::quiet_NaN());
  StarMeasurement measurement(manifold, simplices, labels);
  for (std::uint32_t label = 0; label < labels; ++label) measurement.measure(label, result);
  measure_hinges(manifold, simplices, result);
  return result;
}

}  // namespace delcert
