#include "proofs/certificate/submanifold_claims.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <map>

#include "kernel/number/decimal_bounds.hpp"
#include "kernel/number/rounding_guard.hpp"
#include "proofs/certificate/derivation.hpp"
#include "proofs/certificate/stated_bounds.hpp"

namespace delcert {

namespace {

constexpr int digits_of_reasons = 4;

template <int m>
std::string reason_of(const GraphTriangulation<m>& triangulation) {
  if (triangulation.failures.empty()) {
    return fmt::format("level 5: in {} components no label is certainly alone over its place, that of label {} first",
                       triangulation.unclear.size(), triangulation.unclear.front().value);
  }
  const GraphSimplexFailure<m>& first = triangulation.failures.front();
  return fmt::format("level 5: {} simplices are not certainly mapped to the manifold as they should be; simplex {}: {}",
                     triangulation.failures.size(), fmt::join(first.simplex, " "), description_of(first.cause));
}

std::string reason_of(const char* distance, const RestrictedDelaunay& delaunay) {
  if (delaunay.failures.empty())
    return fmt::format("level 4, {}: label {} is not certainly clear of simplices around", distance,
                       delaunay.unclear.front().value);
  return fmt::format("level 4, {}: at {} labels it is not certain which simplices are nearest, label {} first",
                     distance, delaunay.failures.size(), delaunay.failures.front().value);
}

template <int m>
void claim_delaunay(const SubmanifoldMeasures<m>& measures, Claims& claims, std::vector<std::string>& reasons) {
  if (!measures.delaunay) return;
  const bool extrinsic = measures.delaunay->extrinsic.holds();
  const bool intrinsic = measures.delaunay->intrinsic.holds();
  if (!extrinsic) reasons.push_back(reason_of("for the distance around", measures.delaunay->extrinsic));
  if (!intrinsic) reasons.push_back(reason_of("for the length of curves", measures.delaunay->intrinsic));
  if (!extrinsic && !intrinsic) return;
  claims.delaunay = DelaunayClaim{{}, {}, DelaunayClaim::Restricted{extrinsic, intrinsic, measures.delaunay->density}};
}

/// Bounds with room for readers whose enclosures are wider.
template <int m>
void claim_metric(const SubmanifoldMeasures<m>& measures, Claims& claims, std::vector<std::string>& reasons) {
  double least = 1;
  double greatest = 1;
  double normal = 0;
  for (const GraphSimplex<m>& one : measures.triangulation.simplices) {
    least = std::min(least, one.least_stretch);
    greatest = std::max(greatest, one.greatest_stretch);
    normal = std::max(normal, one.normal);
  }
  const Rational room = Rational::power_of_two(-6);
  const Rational sine = stated_above(Rational::exactly(normal) * (Rational(1) + room));
  if (!(least > 0) || !(greatest < 0x1p10) || Rational(1) <= sine) {
    reasons.emplace_back("level 6: it is not known how much longer distances become");
    return;
  }
  MetricClaim metric;
  metric.least_stretch = stated_below(Rational::exactly(least) * (Rational(1) - room), digits_of_stretches);
  metric.greatest_stretch = stated_above(Rational::exactly(greatest) * (Rational(1) + room), digits_of_stretches);
  metric.normal = sine;
  metric.self_delaunay = measures.weight > 0;
  if (metric.self_delaunay) metric.weight = stated_below(measures.weight);
  claims.metric = metric;
}

/// The least sum of the cotangents of the angles opposite to an edge, over the edges of straight triangles in ℝᴺ; 0
/// if it is not above that.
double least_weight(const GraphVertices& vertices, const std::vector<LabelSimplex<2>>& triangles) {
  const RoundingGuard guard;
  std::map<std::array<std::uint32_t, 2>, Interval> sums;
  for (const LabelSimplex<2>& triangle : triangles) {
    for (std::size_t apex = 0; apex < 3; ++apex) {
      const Interval* c = vertices.position(triangle[apex]);
      const std::uint32_t one = triangle[apex == 0 ? 1 : 0];
      const std::uint32_t other = triangle[apex == 2 ? 1 : 2];
      Interval across(0), a_squared(0), b_squared(0);
      for (std::size_t axis = 0; axis < vertices.manifold.ambient(); ++axis) {
        const Interval a = vertices.position(one)[axis] - c[axis];
        const Interval b = vertices.position(other)[axis] - c[axis];
        across += a * b;
        a_squared += square(a);
        b_squared += square(b);
      }
      sums[{one, other}] += across / square_root(a_squared * b_squared - square(across));
    }
  }
  double least = std::numeric_limits<double>::infinity();
  for (const auto& [edge, sum] : sums) least = std::min(least, sum.lower());
  return least > 0 && least < std::numeric_limits<double>::infinity() ? least : 0;
}

/// Segments are looked at up to some sampling radii only, the least if they vary.
template <int m>
ReachBound reach_of(const ZeroSet& zero_set, const GraphVertices& vertices,
                    const std::vector<LabelSimplex<m>>& simplices, const std::vector<double>& reaches,
                    const SubmanifoldAtlas<m>& atlas, const Progress& progress) {
  constexpr double most_radii = 12;
  double least = 1;
  for (std::uint32_t label = 0; label < vertices.charts.size(); ++label) least = std::min(least, vertices.unit(label));
  return bound_reach<m>(zero_set, vertices, simplices, reaches, atlas.slope(),
                        most_radii * least * approximate_double(atlas.sampling_radius()), progress);
}

}  // namespace

template <int m>
SubmanifoldMeasures<m> measure_submanifold(const SubmanifoldAtlas<m>& atlas, const ChartRun<m>& run,
                                           const ModelGeometry& geometry, const LevelSelection& selection,
                                           const Progress& progress) {
  const GraphVertices vertices = graph_vertices<m>(atlas, run.points);
  const std::vector<LabelSimplex<m>> simplices = run.complex.simplices();
  SubmanifoldMeasures<m> result{{}, check_graph_triangulation<m>(vertices, simplices, progress), {}, {}, {}};
  if (selects(selection, "2s"))
    result.stability =
        run.stability ? *run.stability : check_stability<m>(atlas, run.points, geometry, run.complex, progress);
  if (!result.triangulation.triangulates()) return result;
  if (selects(selection, "5i"))
    result.isotopy = check_graph_isotopy<m>(vertices, simplices, result.triangulation, progress);
  if (selects(selection, "4")) {
    const GraphDensity density = graph_density<m>(vertices, simplices, result.triangulation, atlas.slope());
    const auto check = [&](GraphMetric metric) {
      return check_restricted_delaunay<m>(vertices, simplices, result.triangulation, atlas.slope(), density, metric,
                                          progress);
    };
    if (const auto* zero_set = dynamic_cast<const ZeroSet*>(&atlas.manifold()))
      result.reach = reach_of<m>(*zero_set, vertices, simplices, density.reaches, atlas, progress);
    result.delaunay = typename SubmanifoldMeasures<m>::Delaunay{density.density, check(GraphMetric::extrinsic),
                                                                check(GraphMetric::intrinsic)};
  }
  if constexpr (m == 2) {
    if (selects(selection, "6")) result.weight = least_weight(vertices, simplices);
  }
  return result;
}

template <int m>
void claim_graph(const GraphTriangulation<m>& triangulation, const std::optional<GraphIsotopy>& isotopy,
                 const Rational& unit, const LevelSelection& selection, Claims& claims,
                 std::vector<std::string>& reasons) {
  if (!claims.manifold || !(selects(selection, "5") || selects(selection, "5i"))) return;
  if (!triangulation.triangulates()) {
    reasons.push_back(reason_of(triangulation));
    return;
  }
  claims.triangulation =
      TriangulationClaim{"graph", {}, TriangulationClaim::Graph{triangulation.contraction, triangulation.displacement}};
  if (!isotopy || !selects(selection, "5i")) return;
  if (isotopy->margin > 0) {
    claims.isotopy = IsotopyClaim{stated_below(isotopy->margin)};
  } else if (isotopy->cosine) {
    const Rational room = Rational::power_of_two(-6);
    claims.isotopy = IsotopyClaim{{}, stated_below(Rational::exactly(*isotopy->cosine) * (Rational(1) - room))};
  } else {
    reasons.push_back(fmt::format(
        "level 5i: simplices may meet on their way to the manifold: margin ≥ {} ε, at label {}",
        decimal_lower(Rational::exactly(isotopy->margin) / unit, digits_of_reasons), isotopy->tightest.value));
  }
}

template <int m>
Claims derive_claims(const SubmanifoldAtlas<m>& atlas, const RunParameters& parameters, const ChartRun<m>& run,
                     const SubmanifoldMeasures<m>& measures, const LevelSelection& selection,
                     std::vector<std::string>& reasons) {
  const Rational shift = parameters.algorithm.perturbation * atlas.sampling_radius();
  Derivation derivation = derivation_in_patches<m>(atlas, run, measures.stability, shift, selection, reasons);
  Claims& claims = derivation.claims;
  claim_graph<m>(measures.triangulation, measures.isotopy, atlas.sampling_radius(), selection, claims, reasons);
  if (claims.triangulation) {
    if (selects(selection, "4")) claim_delaunay<m>(measures, claims, reasons);
    if (selects(selection, "6")) claim_metric<m>(measures, claims, reasons);
  }
  return claims;
}

#define DELCERT_INSTANTIATE(m)                                                                                       \
  template SubmanifoldMeasures<m> measure_submanifold<m>(                                                            \
      const SubmanifoldAtlas<m>&, const ChartRun<m>&, const ModelGeometry&, const LevelSelection&, const Progress&); \
  template Claims derive_claims<m>(const SubmanifoldAtlas<m>&, const RunParameters&, const ChartRun<m>&,             \
                                   const SubmanifoldMeasures<m>&, const LevelSelection&, std::vector<std::string>&); \
  template void claim_graph<m>(const GraphTriangulation<m>&, const std::optional<GraphIsotopy>&, const Rational&,    \
                               const LevelSelection&, Claims&, std::vector<std::string>&);
DELCERT_INSTANTIATE(1)
DELCERT_INSTANTIATE(2)
DELCERT_INSTANTIATE(3)
#undef DELCERT_INSTANTIATE

}  // namespace delcert
