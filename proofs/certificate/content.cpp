#include "proofs/certificate/content.hpp"

#include <fmt/format.h>

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
  for (long k = 0; k <= field->degree(); ++k) {
    Rational::Wrapped coefficient;
    fmpq_poly_get_coeff_mpq(coefficient.backend().data(), field->modulus(), k);
    coefficients.emplace_back(coefficient);
  }
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

std::string manifold_object(const ZeroSet& zero_set, const Rational& slope, VerticesKind vertices) {
  const SubmanifoldDescription& manifold = zero_set.description();
  return fmt::format(
      "{{\"name\":{},\"family\":\"submanifold\",\"dimension\":{},\"variables\":{},\"equations\":{},\"box\":{},"
      "\"slope\":{},\"vertices\":\"{}\"}}",
      quoted(manifold.name), manifold.dimension.value, listed(manifold.variables, quoted),
      listed(zero_set.map().canonical_texts(), quoted),
      listed(manifold.box, [](const auto& axis) { return listed(axis, number); }), number(slope),
      vertices == VerticesKind::on_manifold ? "manifold" : "given");
}

template <int m>
CertificateContent<m> content_of(const ManifoldDescription& manifold, const FlatAtlas<m>& atlas,
                                 std::span<const LiftedSimplex<m>> net_simplices, const RunParameters& parameters,
                                 const RunResult<m>& run, const Claims& claims) {
  return {manifold_object(manifold),
          parameters,
          atlas.sampling_radius(),
          claims,
          atlas.size(),
          exactly(atlas.net()),
          exactly(run.points),
          placed_complex<m>(atlas, run.points, run.complex),
          net_simplices};
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
CertificateContent<m> content_of(const SubmanifoldAtlas<m>& atlas, const RunParameters& parameters,
                                 const ChartRun<m>& run, const Claims& claims) {
  return {manifold_object(atlas.zero_set(), atlas.slope(), VerticesKind::on_manifold),
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
}

template <int m>
CertificateContent<m> content_of(const ZeroSet& zero_set, const FittedCharts& charts, const Rational& sampling_radius,
                                 const std::vector<LabelSimplex<m>>& simplices, const RunParameters& parameters,
                                 const Claims& claims) {
  PlacedComplex<m> complex;
  for (const LabelSimplex<m>& simplex : simplices) {
    std::copy(simplex.begin(), simplex.end(), complex.simplices.emplace_back(PlacedSimplex<m>{}).begin());
  }
  return {manifold_object(zero_set, charts.slope, VerticesKind::given),
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
  template CertificateContent<m> content_of<m>(const ZeroSet&, const FittedCharts&, const Rational&,                 \
                                               const std::vector<LabelSimplex<m>>&, const RunParameters&,            \
                                               const Claims&);                                                       \
  template CertificateContent<m> content_of<m>(const SubmanifoldAtlas<m>&, const RunParameters&, const ChartRun<m>&, \
                                               const Claims&);
DELCERT_INSTANTIATE(2)
DELCERT_INSTANTIATE(3)
#undef DELCERT_INSTANTIATE

}  // namespace delcert
