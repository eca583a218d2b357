#include "proofs/certificate/writer.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "delcert_version.hpp"
#include "kernel/number/exact_text.hpp"
#include "kernel/number/self_test.hpp"
#include "kernel/simplex/dimensions.hpp"
#include "proofs/certificate/byte_sink.hpp"

namespace delcert {

namespace {

constexpr std::size_t buffer_size = std::size_t{1} << 16U;

std::string quoted(const std::string& text) { return nlohmann::json(text).dump(); }
std::string number(const Rational& x) { return '"' + exact_text(x) + '"'; }

/// Elements separated by commas between brackets.
template <class Range, class Text>
std::string listed(const Range& range, const Text& text) {
  std::string result = "[";
  for (const auto& element : range) {
    if (result.size() > 1) result += ',';
    result += text(element);
  }
  return result + "]";
}

/// Writes long arrays without holding them.
class Document {
 public:
  /// `elements`: how many there are in all arrays, for the progress.
  Document(const std::filesystem::path& path, std::size_t elements, const Progress& progress)
      : sink_(path), elements_(elements), progress_(progress) {}

  void add(std::string_view text) {
    buffer_ += text;
    if (buffer_.size() >= buffer_size) flush();
  }
  template <class Text>
  void add_array(std::string_view key, std::size_t count, const Text& text) {
    add(fmt::format(",\"{}\":[", key));
    for (std::size_t at = 0; at < count; ++at) {
      if (at > 0) add(",");
      add(text(at));
      if (++written_ % 256 == 0) report();
    }
    add("]");
  }
  void seal() {
    flush();
    add(fmt::format(",\"sha256\":\"{}\"}}\n", sink_.digest()));
    flush();
    report();
    sink_.commit();
  }

 private:
  void report() const { progress_("write the certificate", written_, elements_); }
  void flush() {
    sink_.write(buffer_);
    buffer_.clear();
  }
  ByteSink sink_;
  std::string buffer_;
  std::size_t written_ = 0;
  std::size_t elements_;
  const Progress& progress_;
};

std::string software_object() {
  std::string result = fmt::format("{{\"delcert\":{}", quoted(version));
  for (const auto& [name, value] : library_versions()) result += fmt::format(",{}:{}", quoted(name), quoted(value));
  return result + "}";
}

std::string manifold_object(const ManifoldDescription& manifold) {
  const std::string head = fmt::format("{{\"name\":{},\"family\":\"{}\",\"dimension\":{},", quoted(manifold.name),
                                       name_of(manifold.family), manifold.dimension.value);
  if (manifold.family == ManifoldFamily::euclidean_ball)
    return head + fmt::format("\"radius\":{}}}", number(manifold.radius));
  return head + "\"gram\":" + listed(manifold.gram, [](const auto& row) { return listed(row, number); }) + "}";
}

std::string parameters_object(const RunParameters& parameters, const Rational& sampling_radius) {
  const PerturbationParameters& algorithm = parameters.algorithm;
  return fmt::format(
      "{{\"mode\":\"{}\",\"candidates\":\"{}\",\"seed\":\"{}\",\"sampling_radius\":{},\"separation\":{},"
      "\"radius_variation\":\"0\",\"distortion\":\"0\",\"perturbation\":{},\"flake_parameter_squared\":{},"
      "\"tolerance\":{}}}",
      name_of(parameters.mode), name_of(algorithm.candidates), algorithm.seed, number(sampling_radius),
      number(algorithm.separation), number(algorithm.perturbation), number(parameters.squared_flake_parameter),
      number(algorithm.tolerance));
}

std::string levels_object(const Claims& claims) {
  std::vector<std::string> levels;
  if (claims.input) levels.push_back(fmt::format("\"0\":{{\"hypotheses_2\":{}}}", *claims.input));
  if (claims.stars) {
    levels.push_back(fmt::format("\"1\":{{\"protection\":{},\"thickness\":{},\"circumradius\":{}}}",
                                 number(claims.stars->protection), number(claims.stars->thickness),
                                 number(claims.stars->circumradius)));
  }
  if (claims.manifold) {
    const auto group = [](const AbelianGroup& g) { return quoted(group_text(g)); };
    levels.push_back(fmt::format("\"2\":{{\"simplices\":{},\"euler_characteristic\":{},\"closed\":{},\"homology\":{}}}",
                                 claims.manifold->simplices, claims.manifold->euler_characteristic,
                                 claims.manifold->closed, listed(claims.manifold->homology, group)));
  }
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

std::string_view name_of(RunMode mode) {
  return mode == RunMode::theory ? "theory" : mode == RunMode::measured ? "measured" : "none";
}

std::string_view name_of(CandidateRule rule) {
  return rule == CandidateRule::pruned ? "pruned" : rule == CandidateRule::whole ? "whole" : "printed";
}

template <int m>
void write_certificate(const std::filesystem::path& path, const CertificateContent<m>& content,
                       const Progress& progress) {
  const auto label = [](std::uint32_t index) { return std::to_string(index); };
  const std::size_t count = content.atlas.size();
  const std::size_t net_simplices = content.claims.input ? content.net_simplices.size() : 0;
  Document document(path, 3 * count + net_simplices, progress);
  document.add(R"({"format":"delcert-certificate","version":1,"software":)" + software_object());
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
  document.add_array("stars", count, [&](std::size_t at) {
    return listed(content.run.complex.star(Label(at)), [&](const auto& simplex) { return listed(simplex, label); });
  });
  document.seal();
}

#define DELCERT_INSTANTIATE(m) \
  template void write_certificate<m>(const std::filesystem::path&, const CertificateContent<m>&, const Progress&);
DELCERT_FOR_EACH_DIMENSION(DELCERT_INSTANTIATE)
#undef DELCERT_INSTANTIATE

}  // namespace delcert
