#include "kernel/theorems/riemannian_simplices.hpp"

#include <algorithm>
#include <array>
#include <limits>

#include "kernel/parallel/parts.hpp"
#include "kernel/simplex/dimensions.hpp"

namespace delcert {

namespace {

/// Places of the simplices of star(i) in a view large enough for them, its label first in each; empty if there is none.
template <int m>
std::vector<PlaceSimplex<m>> star_places(ChartView<m>& view, const ChartComplex<m>& complex, Label i) {
  for (const double half_reach : view.half_reaches()) {
    view.look_by_halves(i, half_reach);
    std::vector<PlaceSimplex<m>> result;
    for (const auto& others : complex.star(i)) {
      LabelSimplex<m> labels{i.value};
      std::copy(others.begin(), others.end(), labels.begin() + 1);
      const auto places = places_of<m>(view, labels);
      if (!places) break;
      result.push_back(*places);
    }
    if (result.size() == complex.star(i).size()) return result;
  }
  return {};
}

/// exp⁻¹ at the first of these vertices, of all of them. Precondition: a `FilterGuard` is alive.
template <int m>
LocalVertices<Filter, m> about_first(const ChartView<m>& view, const PlaceSimplex<m>& places) {
  const Curvature curvature = view.geometry().curvature;
  LocalVertices<Filter, m> result{};
  const auto& origin = view.position(LocalCoordinates::conformal, places[0]);
  if (curvature == Curvature::zero) {
    for (std::size_t k = 1; k <= m; ++k)
      result[k] = difference(view.position(LocalCoordinates::chart, places[k]), origin);
    return result;
  }
  const auto back = inverse_model_frame<Filter, m>(curvature, origin);
  for (std::size_t k = 1; k <= m; ++k) {
    const auto point = exponential<Filter, m>(curvature, view.position(LocalCoordinates::chart, places[k]));
    result[k] = logarithm<Filter, m>(curvature, applied(back, point));
  }
  return result;
}

template <int m>
void measure_star(ChartView<m>& view, const ChartComplex<m>& complex, Label i, StarsAboutPoints& result) {
  const auto places = star_places<m>(view, complex, i);
  if (places.empty()) result.is_complete = false;
  const FilterGuard guard;
  const auto metric = view.atlas().metric().template on<Filter>();
  for (const auto& simplex : places) {
    const auto vertices = about_first<m>(view, simplex);
    result.thickness = std::min(result.thickness, thickness_of<m>(metric, vertices));
    for (const auto& vertex : vertices) {
      result.star_radius = std::max(result.star_radius, square_root(metric.squared_norm(vertex)).upper());
    }
  }
}

}  // namespace

void StarsAboutPoints::include(const StarsAboutPoints& other) {
  thickness = std::min(thickness, other.thickness);
  star_radius = std::max(star_radius, other.star_radius);
  is_complete = is_complete && other.is_complete;
}

template <int m>
StarsAboutPoints measure_stars_about_points(const Atlas<m>& atlas, const PointSet<m>& points,
                                            const ModelGeometry& geometry, const ChartComplex<m>& complex,
                                            LabelRange labels, const Progress& progress) {
  const ChartView<m> empty_view(atlas, points, geometry);
  const auto measure = [&](std::size_t first, std::size_t last) {
    ChartView<m> view = empty_view;
    StarsAboutPoints found;
    for (std::size_t at = first; at < last; ++at) {
      const Label label(labels.first + at);
      if (complex.is_interior(label)) measure_star<m>(view, complex, label, found);
    }
    return found;
  };
  StarsAboutPoints all;
  in_parts("measure stars about their points", labels.size(), progress, measure,
           [&all](const StarsAboutPoints& found) { all.include(found); });
  return all;
}

RiemannianSimplices riemannian_simplices(const StarsAboutPoints& all, const ModelGeometry& geometry) {
  if (!all.is_complete) return {};
  RiemannianSimplices result;
  result.thickness = all.thickness;
  result.star_radius = all.star_radius;
  if (!(result.thickness > 0) || result.star_radius == 0) return {};
  const FilterGuard guard;
  Filter scale = scalar_from<Filter>(geometry.injectivity_radius) / Filter(4);
  if (geometry.curvature != Curvature::zero) scale = minimum(scale, Filter::exactly(result.thickness) / Filter(6));
  result.scale = scale.lower();
  result.holds = verdict_of(result.star_radius <= result.scale);
  return result;
}

template <int m>
RiemannianSimplices measure_riemannian_simplices(const Atlas<m>& atlas, const PointSet<m>& points,
                                                 const ModelGeometry& geometry, const ChartComplex<m>& complex,
                                                 const Progress& progress) {
  return riemannian_simplices(
      measure_stars_about_points<m>(atlas, points, geometry, complex, all_labels_of(complex), progress), geometry);
}

#define DELCERT_INSTANTIATE(m)                                                                                       \
  template StarsAboutPoints measure_stars_about_points<m>(const Atlas<m>&, const PointSet<m>&, const ModelGeometry&, \
                                                          const ChartComplex<m>&, LabelRange, const Progress&);      \
  template RiemannianSimplices measure_riemannian_simplices<m>(                                                      \
      const Atlas<m>&, const PointSet<m>&, const ModelGeometry&, const ChartComplex<m>&, const Progress&);
DELCERT_FOR_EACH_DIMENSION(DELCERT_INSTANTIATE)
#undef DELCERT_INSTANTIATE

}  // namespace delcert
