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
  for (const int half_reach : view.half_reaches()) {
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

/// Of some stars.
struct Measured {
  double thickness = std::numeric_limits<double>::infinity();
  double star_radius = 0;
  bool is_complete = true;
};

template <int m>
void measure_star(ChartView<m>& view, const ChartComplex<m>& complex, Label i, Measured& result) {
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

template <int m>
RiemannianSimplices measure_riemannian_simplices(const Atlas<m>& atlas, const PointSet<m>& points,
                                                 const ModelGeometry& geometry, const ChartComplex<m>& complex,
                                                 const Progress& progress) {
  const ChartView<m> empty_view(atlas, points, geometry);
  const auto measure = [&](std::size_t first, std::size_t last) {
    ChartView<m> view = empty_view;
    Measured found;
    for (std::size_t index = first; index < last; ++index) {
      if (complex.is_interior(Label(index))) measure_star<m>(view, complex, Label(index), found);
    }
    return found;
  };
  Measured all;
  in_parts("measure stars about their points", complex.size(), progress, measure, [&all](const Measured& found) {
    all.thickness = std::min(all.thickness, found.thickness);
    all.star_radius = std::max(all.star_radius, found.star_radius);
    all.is_complete = all.is_complete && found.is_complete;
  });
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

#define DELCERT_INSTANTIATE(m)                                  \
  template RiemannianSimplices measure_riemannian_simplices<m>( \
      const Atlas<m>&, const PointSet<m>&, const ModelGeometry&, const ChartComplex<m>&, const Progress&);
DELCERT_FOR_EACH_DIMENSION(DELCERT_INSTANTIATE)
#undef DELCERT_INSTANTIATE

}  // namespace delcert
