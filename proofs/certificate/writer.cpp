#include "proofs/certificate/writer.hpp"

#include <fmt/format.h>

#include "kernel/simplex/dimensions.hpp"
#include "proofs/certificate/document.hpp"
#include "proofs/certificate/placed_complex.hpp"

namespace delcert {

namespace {

std::string manifold_object(const ManifoldDescription& manifold) {
  const std::string head = fmt::format("{{\"name\":{},\"family\":\"{}\",\"dimension\":{},", quoted(manifold.name),
                                       name_of(manifold.family), manifold.dimension.value);
  if (manifold.family == ManifoldFamily::euclidean_ball)
    return head + fmt::format("\"radius\":{}}}", number(manifold.radius));
  return head + "\"gram\":" + listed(manifold.gram, [](const auto& row) { return listed(row, number); }) + "}";
}

std::string levels_object(const Claims& claims) {
  std::vector<std::string> levels;
  if (claims.input) levels.push_back(fmt::format("\"0\":{{\"hypotheses_2\":{}}}", *claims.input));
  if (claims.stars) levels.push_back("\"1\":" + star_margins_object(*claims.stars));
  if (claims.manifold) levels.push_back("\"2\":" + manifold_claim_object(*claims.manifold));
  if (claims.stable_stars) levels.emplace_back("\"2s\":{}");
  if (claims.no_forbidden) levels.push_back(fmt::format("\"3\":{{\"tested\":{}}}", quoted(*claims.no_forbidden)));
  if (claims.delaunay) levels.emplace_back("\"4\":{}");
  if (claims.triangulation) levels.emplace_back("\"5\":{\"route\":\"space-form\"}");
  if (claims.metric) levels.emplace_back("\"6\":{\"self_delaunay\":true,\"bilipschitz\":\"1\"}");
  std::string result = "{";
  for (const std::string& level : levels) result += (result.size() > 1 ? "," : "") + level;
  return result + "}";
}

}  // namespace

template <int m>
void write_certificate(const std::filesystem::path& path, const CertificateContent<m>& content,
                       const Progress& progress) {
  const std::size_t count = content.atlas.size();
  const std::size_t net_simplices = content.claims.input ? content.net_simplices.size() : 0;
  const PlacedComplex<m> complex = placed_complex<m>(content.atlas, content.run.points, content.run.complex);
  Document document(path, 2 * count + net_simplices + complex.simplices.size(), progress);
  document.add(R"({"format":"delcert-certificate","version":2,"software":)" + software_object());
  document.add(",\"manifold\":" + manifold_object(content.manifold));
  document.add(",\"parameters\":" + parameters_object(content.parameters, content.atlas.sampling_radius()));
  document.add(",\"levels\":" + levels_object(content.claims));
  document.add_array("net", count,
                     [&](std::size_t at) { return listed(content.atlas.net().exact(Label(at)), number); });
  document.add_array("net_simplices", net_simplices, [&](std::size_t at) {
    return listed(content.net_simplices[at], [](const Lift<m>& lift) { return std::to_string(lift.index); });
  });
  document.add_array("points", count,
                     [&](std::size_t at) { return listed(content.run.points.exact(Label(at)), number); });
  add_complex<m>(document, complex);
  document.seal();
}

#define DELCERT_INSTANTIATE(m) \
  template void write_certificate<m>(const std::filesystem::path&, const CertificateContent<m>&, const Progress&);
DELCERT_FOR_EACH_DIMENSION(DELCERT_INSTANTIATE)
#undef DELCERT_INSTANTIATE

}  // namespace delcert
