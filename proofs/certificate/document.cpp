#include "proofs/certificate/document.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "delcert_version.hpp"
#include "kernel/number/exact_text.hpp"
#include "kernel/number/self_test.hpp"

namespace delcert {

namespace {
constexpr std::size_t buffer_size = std::size_t{1} << 16U;
}

std::string quoted(const std::string& text) { return nlohmann::json(text).dump(); }

std::string number(const Rational& x) { return '"' + exact_text(x) + '"'; }

std::string software_object() {
  std::string result = fmt::format("{{\"delcert\":{}", quoted(version));
  for (const auto& [name, value] : library_versions()) result += fmt::format(",{}:{}", quoted(name), quoted(value));
  return result + "}";
}

std::string parameters_object(const RunParameters& parameters, const Rational& sampling_radius,
                              const Rational& distortion) {
  const PerturbationParameters& algorithm = parameters.algorithm;
  return fmt::format(
      "{{\"mode\":\"{}\",\"candidates\":\"{}\",\"seed\":\"{}\",\"sampling_radius\":{},\"separation\":{},"
      "\"radius_variation\":\"0\",\"distortion\":{},\"perturbation\":{},\"flake_parameter_squared\":{},"
      "\"tolerance\":{}}}",
      name_of(parameters.mode), name_of(algorithm.candidates), algorithm.seed, number(sampling_radius),
      number(algorithm.separation), number(distortion), number(algorithm.perturbation),
      number(parameters.squared_flake_parameter), number(algorithm.tolerance));
}

std::string star_margins_object(const StarMargins& margins) {
  return fmt::format(R"({{"protection":{},"thickness":{},"circumradius":{}}})", number(margins.protection),
                     number(margins.thickness), number(margins.circumradius));
}

std::string manifold_claim_object(const ManifoldClaim& claim) {
  const auto group = [](const AbelianGroup& g) { return quoted(group_text(g)); };
  return fmt::format("{{\"simplices\":{},\"euler_characteristic\":{},\"closed\":{},\"homology\":{}}}", claim.simplices,
                     claim.euler_characteristic, claim.closed, listed(claim.homology, group));
}

std::string_view name_of(RunMode mode) {
  return mode == RunMode::theory ? "theory" : mode == RunMode::measured ? "measured" : "none";
}

std::string_view name_of(CandidateRule rule) {
  return rule == CandidateRule::pruned ? "pruned" : rule == CandidateRule::whole ? "whole" : "printed";
}

void Document::add(std::string_view text) {
  buffer_ += text;
  if (buffer_.size() >= buffer_size) flush();
}

void Document::seal() {
  flush();
  add(fmt::format(",\"sha256\":\"{}\"}}\n", sink_.digest()));
  flush();
  report();
  sink_.commit();
}

void Document::flush() {
  sink_.write(buffer_);
  buffer_.clear();
}

}  // namespace delcert
