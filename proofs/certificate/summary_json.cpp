#include "proofs/certificate/summary_json.hpp"

namespace delcert {

namespace {

nlohmann::ordered_json object_of(const std::vector<std::pair<std::string, std::string>>& entries) {
  nlohmann::ordered_json result = nlohmann::ordered_json::object();
  for (const auto& [key, value] : entries) result[key] = value;
  return result;
}

}  // namespace

nlohmann::ordered_json summary_json(const CertificateSummary& certificate) {
  nlohmann::ordered_json json;
  json["manifold"] = certificate.manifold.name;
  json["family"] = certificate.family;
  json["dimension"] = certificate.manifold.dimension.value;
  json["points"] = certificate.points.size();
  json["parameters"] = object_of(certificate.parameters);
  json["levels_claimed"] = nlohmann::ordered_json::object();
  for (const auto& [level, margins] : certificate.levels) json["levels_claimed"][level] = object_of(margins);
  json["software"] = object_of(certificate.software);
  json["sha256"] = certificate.seal;
  return json;
}

std::string ascii_text(const nlohmann::ordered_json& json, int indentation) {
  return json.dump(indentation, ' ', true, nlohmann::ordered_json::error_handler_t::replace);
}

}  // namespace delcert
