#include "proofs/drawing/measures.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "proofs/drawing/simplex_shape.hpp"

namespace delcert {

namespace {

/// A label, moved by an element.
struct MovedLabel {
  std::uint32_t label;
  std::uint32_t element;
  friend auto operator<=>(const MovedLabel&, const MovedLabel&) = default;
};

using Place = ApproximateManifold::ChartPlace;

struct Shown {
  MovedLabel point;
  Place place;
};

double squared_distance(const Place& a, const Place& b) {
  double sum = 0;
  for (std::size_t axis = 0; axis < a.size(); ++axis) sum += (a[axis] - b[axis]) * (a[axis] - b[axis]);
  return sum;
}

class StarMeasurement {
 public:
  StarMeasurement(ApproximateManifold& manifold, const std::vector<DrawnSimplex>& simplices, std::size_t labels)
      : manifold_(manifold), simplices_(simplices), stars_(labels), neighbours_(labels) {
    for (const DrawnSimplex& simplex : simplices) {
      for (std::size_t a = 0; a < simplex.labels.size(); ++a) {
        stars_[simplex.labels[a]].push_back(simplex.position);
        for (std::size_t b = 0; b < simplex.labels.size(); ++b) {
          if (a == b) continue;
          neighbours_[simplex.labels[a]].push_back(
              {simplex.labels[b], manifold.relative_element(simplex.elements[a], simplex.elements[b])});
        }
      }
    }
    for (auto& list : neighbours_) unique(list);
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
  static void unique(std::vector<MovedLabel>& list) {
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
  }

  /// What chart `label` shows of neighbours of neighbours; where simplices are missing, of all points.
  void show(std::uint32_t label) {
    std::vector<MovedLabel> near{{label, 0}};
    if (!manifold_.is_closed()) {
      near.clear();
      for (std::uint32_t other = 0; other < stars_.size(); ++other) near.push_back({other, 0});
    } else {
      for (const MovedLabel& first : neighbours_[label]) {
        near.push_back(first);
        for (const MovedLabel& second : neighbours_[first.label])
          near.push_back({second.label, manifold_.product(first.element, second.element)});
      }
      unique(near);
    }
    shown_.clear();
    for (const MovedLabel& point : near) {
      if (const auto place = manifold_.in_chart(label, point.label, point.element)) shown_.push_back({point, *place});
    }
  }

  void measure(std::uint32_t label, const DrawnSimplex& simplex, SimplexMeasures& result) {
    const std::size_t m = simplex.labels.size() - 1;
    const std::size_t own = static_cast<std::size_t>(std::find(simplex.labels.begin(), simplex.labels.end(), label) -
                                                     simplex.labels.begin());
    std::array<const Shown*, ApproximateShape::most_vertices> vertices{};
    for (std::size_t k = 0; k <= m; ++k) {
      const MovedLabel vertex{simplex.labels[k],
                              manifold_.relative_element(simplex.elements[own], simplex.elements[k])};
      const auto found =
          std::lower_bound(shown_.begin(), shown_.end(), vertex,
                           [](const Shown& shown, const MovedLabel& wanted) { return shown.point < wanted; });
      if (found == shown_.end() || found->point != vertex) return;
      vertices[k] = &*found;
    }
    SquaredEdges squares{};
    for (std::size_t j = 0; j <= m; ++j) {
      for (std::size_t k = 0; k <= m; ++k) squares[j][k] = squared_distance(vertices[j]->place, vertices[k]->place);
    }
    const ApproximateShape shape = approximate_shape(m, squares);
    Place centre{};
    for (std::size_t k = 0; k <= m; ++k) {
      for (std::size_t axis = 0; axis < centre.size(); ++axis)
        centre[axis] += shape.centre[k] * vertices[k]->place[axis];
    }
    double nearest = std::numeric_limits<double>::infinity();
    const auto end = vertices.begin() + static_cast<std::ptrdiff_t>(m + 1);
    for (const Shown& other : shown_) {
      if (std::find(vertices.begin(), end, &other) == end)
        nearest = std::min(nearest, squared_distance(centre, other.place));
    }
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

  ApproximateManifold& manifold_;
  const std::vector<DrawnSimplex>& simplices_;
  std::vector<std::vector<std::size_t>> stars_;
  std::vector<std::vector<MovedLabel>> neighbours_;
  std::vector<Shown> shown_;  ///< by label and element
};

/// What each simplex adds at its facets; none where there is no piecewise flat metric.
std::optional<ApproximateShape::Numbers> facet_heights(const ApproximateManifold& manifold,
                                                       const DrawnSimplex& simplex) {
  const std::size_t m = simplex.labels.size() - 1;
  SquaredEdges squares{};
  for (std::size_t j = 0; j <= m; ++j) {
    for (std::size_t k = j + 1; k <= m; ++k) {
      const auto square =
          manifold.squared_edge(simplex.labels[j], simplex.elements[j], simplex.labels[k], simplex.elements[k]);
      if (!square) return std::nullopt;
      squares[j][k] = squares[k][j] = *square;
    }
  }
  const ApproximateShape shape = approximate_shape(m, squares);
  ApproximateShape::Numbers result{};
  for (std::size_t k = 0; k <= m; ++k) {
    const double height = shape.centre[k] * shape.altitudes[k];
    // cot α = height / half of the edge.
    result[k] =
        m == 2 ? 2 * height / std::sqrt(squares[(k + 1) % 3][(k + 2) % 3]) : height / manifold.unit(simplex.labels[k]);
  }
  return result;
}

void measure_hinges(const ApproximateManifold& manifold, const std::vector<DrawnSimplex>& simplices,
                    SimplexMeasures& result) {
  if (manifold.dimension() < 2) return;
  struct Side {
    std::vector<std::uint32_t> facet;
    std::size_t simplex;
    double height;
  };
  std::vector<Side> sides;
  for (const DrawnSimplex& simplex : simplices) {
    const auto heights = facet_heights(manifold, simplex);
    if (!heights) return;
    for (std::size_t k = 0; k < simplex.labels.size(); ++k) {
      std::vector<std::uint32_t> facet = simplex.labels;
      facet.erase(facet.begin() + static_cast<std::ptrdiff_t>(k));
      sides.push_back({std::move(facet), simplex.position, (*heights)[k]});
    }
  }
  std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) { return a.facet < b.facet; });
  result.hinge.assign(simplices.size(), std::numeric_limits<double>::quiet_NaN());
  for (std::size_t at = 0; at + 1 < sides.size(); ++at) {
    if (sides[at].facet != sides[at + 1].facet) continue;
    const double sum = sides[at].height + sides[at + 1].height;
    for (const std::size_t simplex : {sides[at].simplex, sides[at + 1].simplex}) {
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
