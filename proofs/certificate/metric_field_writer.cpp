#include "proofs/certificate/metric_field_writer.hpp"

#include <fmt/format.h>

#include "proofs/certificate/placed_complex.hpp"

namespace delcert {

namespace {

std::string matrix_text(const MetricFieldDescription::Square& matrix) {
  return listed(matrix, [](const auto& row) { return listed(row, number); });
}

std::string wave_text(const MetricFieldDescription::Term& wave) {
  return "{\"frequency\":" + listed(wave.frequency, [](int k) { return std::to_string(k); }) +
         ",\"cosine\":" + matrix_text(wave.cosine) + ",\"sine\":" + matrix_text(wave.sine) + "}";
}

template <int m>
std::string manifold_text(const MetricFieldContent<m>& content) {
  const MetricFieldDescription& field = content.atlas.field().description();
  return fmt::format(
      "{{\"name\":{},\"family\":\"metric-field\",\"dimension\":{},\"constant\":{},\"waves\":{},\"rounding\":{},"
      "\"patch_radius\":{},\"metric_distortion\":{}}}",
      quoted(field.name), m, matrix_text(field.constant), listed(field.waves, wave_text),
      number(content.distortion.rounding), number(content.atlas.patch_radius()), number(content.distortion.metric));
}

std::string levels_text(const MetricFieldClaims& claims) {
  std::vector<std::string> levels;
  if (claims.stars) levels.push_back("\"1\":" + star_margins_object(*claims.stars));
  if (claims.manifold) levels.push_back("\"2\":" + manifold_claim_object(*claims.manifold));
  if (claims.reach) levels.push_back(fmt::format("\"2s\":{{\"reach\":{}}}", number(*claims.reach)));
  if (claims.delaunay)
    levels.push_back(fmt::format("\"4\":{{\"edge\":{},\"margin\":{}}}", number(claims.delaunay->edge),
                                 number(claims.delaunay->margin)));
  if (claims.triangulation) levels.emplace_back("\"5\":{\"route\":\"affine-charts\"}");
  return "{" + fmt::format("{}", fmt::join(levels, ",")) + "}";
}

/// The entries on and above the diagonal, row by row.
template <int m>
std::string chart_text(const AffineChart<m>& chart) {
  std::vector<Rational> entries;
  for (std::size_t row = 0; row < m; ++row) {
    for (std::size_t column = row; column < m; ++column) entries.push_back(chart.matrix()[row][column]);
  }
  return listed(entries, number);
}

}  // namespace

template <int m>
void write_metric_field_certificate(const std::filesystem::path& path, const MetricFieldContent<m>& content,
                                    const Progress& progress) {
  const MetricFieldAtlas<m>& atlas = content.atlas;
  const std::size_t count = atlas.size();
  const PlacedComplex<m> complex = placed_complex<m>(atlas, content.complex);
  Document document(path, 3 * count + complex.simplices.size(), progress);
  document.add(R"({"format":"delcert-certificate","version":2,"software":)" + software_object());
  document.add(",\"manifold\":" + manifold_text(content));
  document.add(",\"parameters\":" +
               parameters_object(content.parameters, atlas.sampling_radius(), content.distortion.transition));
  document.add(",\"levels\":" + levels_text(content.claims));
  document.add_array("net", count, [&](std::size_t at) { return listed(atlas.centre(Label(at)), number); });
  document.add_array("charts", count, [&](std::size_t at) { return chart_text<m>(atlas.chart(Label(at))); });
  document.add(",\"net_simplices\":[]");
  document.add_array("points", count, [&](std::size_t at) { return listed(content.points.exact(Label(at)), number); });
  add_complex<m>(document, complex);
  document.seal();
}

template void write_metric_field_certificate<2>(const std::filesystem::path&, const MetricFieldContent<2>&,
                                                const Progress&);
template void write_metric_field_certificate<3>(const std::filesystem::path&, const MetricFieldContent<3>&,
                                                const Progress&);

}  // namespace delcert
