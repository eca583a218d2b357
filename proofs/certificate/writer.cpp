#include "proofs/certificate/writer.hpp"

#include <fmt/format.h>

#include "delcert_version.hpp"
#include "kernel/number/self_test.hpp"
#include "kernel/simplex/dimensions.hpp"
#include "proofs/certificate/document.hpp"

namespace delcert {

namespace {

std::string software_object(const RunParameters& parameters) {
  std::string result = fmt::format("{{\"delcert\":{}", quoted(version));
  for (const auto& [name, value] : library_versions()) result += fmt::format(",{}:{}", quoted(name), quoted(value));
  for (const auto& [name, value] : parameters.origin) result += fmt::format(",{}:{}", quoted(name), quoted(value));
  return result + "}";
}

template <int m>
std::string parameters_object(const CertificateContent<m>& content) {
  const RunParameters& parameters = content.parameters;
  const PerturbationParameters& algorithm = parameters.algorithm;
  return fmt::format(
      "{{\"mode\":\"{}\",\"candidates\":\"{}\",\"seed\":\"{}\",\"sampling_radius\":{},\"separation\":{},"
      "\"radius_variation\":{},\"distortion\":{},\"perturbation\":{},\"flake_parameter_squared\":{},"
      "\"tolerance\":{}}}",
      name_of(parameters.mode), name_of(algorithm.candidates), algorithm.seed, number(content.sampling_radius),
      number(algorithm.separation), number(content.radius_variation), number(content.distortion),
      number(algorithm.perturbation), number(parameters.squared_flake_parameter), number(algorithm.tolerance));
}

std::string levels_object(const Claims& claims) {
  const auto entry = [](const LevelEntry& stated) { return quoted(stated.key) + ":" + stated.json; };
  std::vector<std::string> levels;
  for (const ClaimedLevel& level : claimed_levels(claims)) {
    std::vector<std::string> entries;
    for (const LevelEntry& stated : level.entries) entries.push_back(entry(stated));
    levels.push_back(fmt::format("{}:{{{}}}", quoted(level.name), fmt::join(entries, ",")));
  }
  return fmt::format("{{{}}}", fmt::join(levels, ","));
}

/// The keys `elements`, `simplices` and `loops`.
template <int m>
void add_complex(Document& document, const PlacedComplex<m>& complex) {
  const auto row = [](const auto& integers) {
    return listed(integers, [](std::int64_t integer) { return std::to_string(integer); });
  };
  document.add_array("elements", complex.elements.size(), [&](std::size_t at) { return row(complex.elements[at]); });
  document.add_array("simplices", complex.simplices.size(), [&](std::size_t at) { return row(complex.simplices[at]); });
  document.add_array("loops", complex.loops.size(), [&](std::size_t at) {
    std::vector<std::uint32_t> integers;
    for (const LoopStep& step : complex.loops[at]) integers.insert(integers.end(), {step.simplex, step.from, step.to});
    return row(integers);
  });
}

}  // namespace

template <int m>
std::string certificate_head(const CertificateContent<m>& content) {
  return ",\"software\":" + software_object(content.parameters) + ",\"manifold\":" + content.manifold +
         ",\"parameters\":" + parameters_object(content) + ",\"levels\":" + levels_object(content.claims);
}

template <int m>
void write_certificate(const std::filesystem::path& path, const CertificateContent<m>& content,
                       const Progress& progress) {
  const std::size_t net_simplices = content.claims.input ? content.net_simplices.size() : 0;
  Document document(path, (content.charts ? 3 : 2) * content.labels + net_simplices + content.complex.simplices.size(),
                    progress);
  const auto add_numbers = [&](std::string_view key, const auto& row) {
    document.add_array(key, content.labels, [&](std::size_t at) { return listed(row(Label(at)), number); });
  };
  document.add(R"({"format":"delcert-certificate","version":2)" + certificate_head(content));
  add_numbers("net", content.net);
  if (content.charts) add_numbers("charts", content.charts);
  if (content.radii)
    document.add_array("radii", content.labels, [&](std::size_t at) { return number(content.radii(Label(at))); });
  document.add_array("net_simplices", net_simplices, [&](std::size_t at) {
    return listed(content.net_simplices[at], [](const Lift<m>& lift) { return std::to_string(lift.index); });
  });
  add_numbers("points", content.points);
  add_complex<m>(document, content.complex);
  document.seal();
}

#define DELCERT_INSTANTIATE(m)                                            \
  template std::string certificate_head<m>(const CertificateContent<m>&); \
  template void write_certificate<m>(const std::filesystem::path&, const CertificateContent<m>&, const Progress&);
DELCERT_FOR_EACH_DIMENSION(DELCERT_INSTANTIATE)
#undef DELCERT_INSTANTIATE

}  // namespace delcert
