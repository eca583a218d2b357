#include "proofs/certificate/content.hpp"

#include <fmt/format.h>

#include "kernel/manifold/submanifold/polyhedral_mesh.hpp"
#include "kernel/number/flint_rational.hpp"
#include "kernel/simplex/dimensions.hpp"
#include "proofs/certificate/document.hpp"

namespace delcert {

namespace {

std::string matrix_text(const std::vector<std::vector<Rational>>& matrix) {
  return listed(matrix, [](const auto& row) { return listed(row, number); });
}

std::string wave_text(const MetricFieldDescription::Term& wave) {
  return "{\"frequency\":" + listed(wave.frequency, [](int k) { return std::to_string(k); }) +
         ",\"cosine\":" + matrix_text(wave.cosine) + ",\"sine\":" + matrix_text(wave.sine) + "}";
}

std::string box_text(const Sides& box) {
  return listed(box, [](const auto& side) { return listed(side, number); });
}

using Field = FieldElement::Field;

Field field_of(const SpaceForm& form) {
  if (form.form().time().field()) return form.form().time().field();
  std::vector<const FieldMatrix*> matrices{&form.form().gram()};
  for (const FieldMatrix& generator : form.description.generators) matrices.push_back(&generator);
  for (const FieldMatrix* matrix : matrices) {
    for (std::size_t row = 0; row < matrix->order(); ++row) {
      for (std::size_t column = 0; column < matrix->order(); ++column) {
        if ((*matrix)(row, column).field()) return (*matrix)(row, column).field();
      }
    }
  }
  return nullptr;
}

/// The polynomial and two numbers around its root, so close that no other one of it or of its derivative is between.
std::string field_entries(const Field& field) {
  if (!field) return R"("field":["0","1"],"root":["-1","1"])";
  std::vector<Rational> coefficients;
  for (long k = 0; k <= field->degree(); ++k) coefficients.push_back(coefficient_of(field->modulus(), k));
  const BigInterval root = field->root();
  return "\"field\":" + listed(coefficients, number) + ",\"root\":[" + number(rounded_down(root.lower(), -64)) + "," +
         number(rounded_up(root.upper(), -64)) + "]";
}

std::string element_text(const FieldElement& x) {
  const std::vector<Rational> coefficients = x.coefficients();
  return coefficients.empty() ? "[\"0\"]" : listed(coefficients, number);
}

std::string field_matrix_text(const FieldMatrix& a) {
  std::vector<std::string> rows;
  for (std::size_t row = 0; row < a.order(); ++row) {
    std::vector<FieldElement> entries;
    for (std::size_t column = 0; column < a.order(); ++column) entries.push_back(a(row, column));
    rows.push_back(listed(entries, element_text));
  }
  return listed(rows, [](const std::string& row) { return row; });
}

/// The entries on and above the diagonal, row by row.
template <int m>
std::vector<Rational> upper_triangle(const AffineChart<m>& chart) {
  std::vector<Rational> entries;
  for (std::size_t row = 0; row < m; ++row) {
    for (std::size_t column = row; column < m; ++column) entries.push_back(chart.matrix()[row][column]);
  }
  return entries;
}

template <std::size_t m>
std::vector<Rational> numbers(const std::array<Rational, m>& vector) {
  return {vector.begin(), vector.end()};
}

template <int m>
typename CertificateContent<m>::Numbers exactly(const PointSet<m>& points) {
  return [&points](Label at) { return numbers(points.exact(at)); };
}

std::string facet_text(const std::array<std::uint32_t, 3>& facet) {
  return listed(facet, [](std::uint32_t vertex) { return std::to_string(vertex); });
}

/// s, A above the diagonal, Y, ϱ, ζ.
std::vector<Rational> numbers(const ChartData& chart) {
  std::vector<Rational> result(chart.columns.begin(), chart.columns.end());
  result.insert(result.end(), chart.skew.begin(), chart.skew.end());
  result.insert(result.end(), chart.preconditioner.begin(), chart.preconditioner.end());
  result.insert(result.end(), {chart.radius, chart.height});
  return result;
}

}  // namespace

std::string manifold_object(const ManifoldDescription& manifold) {
  const bool is_ball = manifold.family == ManifoldFamily::euclidean_ball;
  return fmt::format("{{\"name\":{},\"family\":\"{}\",\"dimension\":{},\"{}\":{}}}", quoted(manifold.name),
                     name_of(manifold.family), manifold.dimension.value, is_ball ? "radius" : "gram",
                     is_ball ? number(manifold.radius) : matrix_text(manifold.gram));
}

std::string_view family_of(Curvature curvature) {
  return curvature == Curvature::positive ? "spherical" : curvature == Curvature::zero ? "flat" : "hyperbolic";
}

std::string manifold_object(const SpaceForm& form) {
  return fmt::format(
      "{{\"name\":{},\"family\":\"{}\",\"dimension\":{},{},\"time\":{},\"gram\":{},\"generators\":{},"
      "\"injectivity_radius\":{}}}",
      quoted(form.description.name), family_of(form.form().curvature()), form.form().dimension(),
      field_entries(field_of(form)), element_text(form.form().time()), field_matrix_text(form.form().gram()),
      listed(form.description.generators, field_matrix_text), number(form.injectivity_radius.lower));
}

std::string manifold_object(const MetricFieldDescription& field, const ChartDistortion& distortion,
                            const Rational& patch_radius) {
  return fmt::format(
      "{{\"name\":{},\"family\":\"metric-field\",\"dimension\":{},\"constant\":{},\"waves\":{},\"rounding\":{},"
      "\"patch_radius\":{},\"metric_distortion\":{}}}",
      quoted(field.name), field.dimension.value, matrix_text(field.constant), listed(field.waves, wave_text),
      number(distortion.rounding), number(patch_radius), number(distortion.metric));
}

std::string manifold_object(const FormulaAtlasDescription& atlas, const Rational& patch_radius) {
  const auto chart_text = [](const FormulaAtlasDescription::Chart& chart) {
    return fmt::format("{{\"name\":{},\"variables\":{},\"domain\":{},\"core\":{}}}", quoted(chart.name),
                       listed(chart.variables, quoted), box_text(chart.domain), box_text(chart.core));
  };
  const auto transition_text = [](const FormulaAtlasDescription::Transition& transition) {
    return fmt::format("{{\"from\":{},\"to\":{},\"map\":{},\"inverse\":{},\"where\":{}}}", transition.from,
                       transition.to, listed(transition.map, quoted), listed(transition.inverse, quoted),
                       listed(transition.where, quoted));
  };
  return fmt::format(
      "{{\"name\":{},\"family\":\"atlas\",\"dimension\":{},\"charts\":{},\"transitions\":{},\"patch_radius\":{}}}",
      quoted(atlas.name), atlas.dimension.value, listed(atlas.charts, chart_text),
      listed(atlas.transitions, transition_text), number(patch_radius));
}

std::string manifold_object(const EmbeddedManifold& embedded, const Rational& slope, VerticesKind vertices) {
  if (const auto* mesh = dynamic_cast<const PolyhedralMesh*>(&embedded)) {
    return fmt::format(
        "{{\"name\":{},\"family\":\"submanifold\",\"dimension\":2,\"mesh\":{},\"facets\":{},\"slope\":{},\"vertices\":"
        "\"manifold\"}}",
        quoted(mesh->name()), matrix_text(mesh->mesh().points), listed(mesh->mesh().triangles, facet_text),
        number(slope));
  }
  const auto& zero_set = dynamic_cast<const ZeroSet&>(embedded);
  const SubmanifoldDescription& manifold = zero_set.description();
  return fmt::format(
      "{{\"name\":{},\"family\":\"submanifold\",\"dimension\":{},\"variables\":{},\"equations\":{},\"box\":{},"
      "\"slope\":{},\"vertices\":\"{}\"}}",
      quoted(manifold.name), manifold.dimension.value, listed(manifold.variables, quoted),
      listed(zero_set.map().canonical_texts(), quoted), box_text(manifold.box), number(slope),
      vertices == VerticesKind::on_manifold ? "manifold" : "given");
}

template <int m>
CertificateContent<m> content_of(const ManifoldDescription& manifold, const FlatAtlas<m>& atlas,
                                 std::span<const LiftedSimplex<m>> net_simplices, const RunParameters& parameters,
                                 const RunResult<m>& run, const Claims& claims) {
  CertificateContent<m> result{manifold_object(manifold),
                               parameters,
                               atlas.sampling_radius(),
                               claims,
                               atlas.size(),
                               exactly(atlas.net()),
                               exactly(run.points),
                               placed_complex<m>(atlas, run.points, run.complex),
                               net_simplices};
  if (atlas.radii().vary()) {
    result.radii = [&atlas](Label at) { return atlas.sampling_radius(at); };
    result.radius_variation = atlas.radius_variation();
  }
  return result;
}

template <int m>
CertificateContent<m> content_of(const SpaceFormAtlas<m>& atlas, const RunParameters& parameters,
                                 const ChartRun<m>& run, const Claims& claims) {
  return {manifold_object(atlas.form()),
          parameters,
          atlas.sampling_radius(),
          claims,
          atlas.size(),
          [&atlas](Label at) { return numbers(atlas.centre(at)); },
          exactly(run.points),
          placed_complex<m>(atlas, run.complex)};
}

template <int m>
CertificateContent<m> content_of(const MetricFieldAtlas<m>& atlas, const ChartDistortion& distortion,
                                 const RunParameters& parameters, const ChartRun<m>& run, const Claims& claims) {
  return {manifold_object(atlas.field().description(), distortion, atlas.patch_radius()),
          parameters,
          atlas.sampling_radius(),
          claims,
          atlas.size(),
          [&atlas](Label at) { return numbers(atlas.centre(at)); },
          exactly(run.points),
          placed_complex<m>(run.complex),
          {},
          distortion.transition,
          [&atlas](Label at) { return upper_triangle<m>(atlas.chart(at)); }};
}

template <int m>
CertificateContent<m> content_of(const FormulaAtlas<m>& atlas, const Rational& distortion,
                                 const RunParameters& parameters, const ChartRun<m>& run, const Claims& claims) {
  const auto chart_numbers = [&atlas](Label at) {
    std::vector<Rational> result = upper_triangle<m>(atlas.chart(at));
    result.insert(result.begin(), Rational(Integer(atlas.home_chart(at))));
    return result;
  };
  return {manifold_object(atlas.gluing().description(), atlas.patch_radius()),
          parameters,
          atlas.sampling_radius(),
          claims,
          atlas.size(),
          [&atlas](Label at) { return numbers(atlas.centre(at)); },
          exactly(run.points),
          placed_complex<m>(run.complex),
          {},
          distortion,
          chart_numbers};
}

template <int m>
CertificateContent<m> content_of(const SubmanifoldAtlas<m>& atlas, const RunParameters& parameters,
                                 const ChartRun<m>& run, const Claims& claims) {
  CertificateContent<m> result{manifold_object(atlas.manifold(), atlas.slope(), VerticesKind::on_manifold),
                               parameters,
                               atlas.sampling_radius(),
                               claims,
                               atlas.size(),
                               [&atlas](Label at) { return atlas.chart(at).data().centre; },
                               exactly(run.points),
                               placed_complex<m>(run.complex),
                               {},
                               distortion_of_slope(atlas.slope()),
                               [&atlas](Label at) { return numbers(atlas.chart(at).data()); }};
  if (atlas.radii().vary()) {
    result.radii = [&atlas](Label at) { return atlas.sampling_radius(at); };
    result.radius_variation = radius_variation(atlas.charts(), atlas.radii());
  }
  return result;
}

template <int m>
CertificateContent<m> content_of(const EmbeddedManifold& manifold, const FittedCharts& charts,
                                 const Rational& sampling_radius, const std::vector<LabelSimplex<m>>& simplices,
                                 const RunParameters& parameters, const Claims& claims) {
  PlacedComplex<m> complex;
  for (const LabelSimplex<m>& simplex : simplices) {
    std::copy(simplex.begin(), simplex.end(), complex.simplices.emplace_back(PlacedSimplex<m>{}).begin());
  }
  return {manifold_object(manifold, charts.slope, VerticesKind::given),
          parameters,
          sampling_radius,
          claims,
          charts.charts.size(),
          [&charts](Label at) { return charts.charts[at.value].data().centre; },
          [](Label) { return std::vector<Rational>(static_cast<std::size_t>(m)); },
          std::move(complex),
          {},
          distortion_of_slope(charts.slope),
          [&charts](Label at) { return numbers(charts.charts[at.value].data()); }};
}

#define DELCERT_INSTANTIATE(m)                                                                          \
  template CertificateContent<m> content_of<m>(const ManifoldDescription&, const FlatAtlas<m>&,         \
                                               std::span<const LiftedSimplex<m>>, const RunParameters&, \
                                               const RunResult<m>&, const Claims&);
DELCERT_FOR_EACH_DIMENSION(DELCERT_INSTANTIATE)
#undef DELCERT_INSTANTIATE
#define DELCERT_INSTANTIATE(m)                                                                                       \
  template CertificateContent<m> content_of<m>(const SpaceFormAtlas<m>&, const RunParameters&, const ChartRun<m>&,   \
                                               const Claims&);                                                       \
  template CertificateContent<m> content_of<m>(const MetricFieldAtlas<m>&, const ChartDistortion&,                   \
                                               const RunParameters&, const ChartRun<m>&, const Claims&);             \
  template CertificateContent<m> content_of<m>(const FormulaAtlas<m>&, const Rational&, const RunParameters&,        \
                                               const ChartRun<m>&, const Claims&);                                   \
  template CertificateContent<m> content_of<m>(const EmbeddedManifold&, const FittedCharts&, const Rational&,        \
                                               const std::vector<LabelSimplex<m>>&, const RunParameters&,            \
                                               const Claims&);                                                       \
  template CertificateContent<m> content_of<m>(const SubmanifoldAtlas<m>&, const RunParameters&, const ChartRun<m>&, \
                                               const Claims&);
DELCERT_INSTANTIATE(2)
DELCERT_INSTANTIATE(3)
#undef DELCERT_INSTANTIATE
template CertificateContent<1> content_of<1>(const SubmanifoldAtlas<1>&, const RunParameters&, const ChartRun<1>&,
                                             const Claims&);

}  // namespace delcert
