#include "proofs/certificate/reader.hpp"

#include <nlohmann/json.hpp>

#include "kernel/number/exact_text.hpp"
#include "proofs/certificate/file_text.hpp"
#include "support/error.hpp"

namespace delcert {

namespace {

using Json = nlohmann::ordered_json;

/// Of a list, the texts of its elements with commas between.
std::string text_of(const Json& value) {
  if (!value.is_array()) return value.is_string() ? value.get<std::string>() : value.dump();
  std::string result;
  for (const Json& element : value) result += (result.empty() ? "" : ", ") + text_of(element);
  return result;
}

std::vector<std::pair<std::string, std::string>> entries(const Json& object) {
  std::vector<std::pair<std::string, std::string>> result;
  for (const auto& [key, value] : object.items()) result.emplace_back(key, text_of(value));
  return result;
}

ManifoldDescription manifold_of(const Json& json) {
  ManifoldDescription result;
  result.name = json.at("name").get<std::string>();
  result.dimension = Dimension(json.at("dimension").get<int>());
  const std::string family = json.at("family").get<std::string>();
  const auto size = static_cast<std::size_t>(result.dimension.value);
  if (family == name_of(ManifoldFamily::euclidean_ball)) {
    result.family = ManifoldFamily::euclidean_ball;
    result.radius = parse_exact(json.at("radius").get<std::string>());
    result.gram.assign(size, std::vector<Rational>(size));
    for (std::size_t axis = 0; axis < size; ++axis) result.gram[axis][axis] = Rational(1);
    return result;
  }
  if (family != name_of(ManifoldFamily::flat_torus)) return result;
  for (const Json& row : json.at("gram")) {
    result.gram.emplace_back();
    for (const Json& entry : row) result.gram.back().push_back(parse_exact(entry.get<std::string>()));
  }
  return result;
}

CertificateSummary summary_of(const Json& json) {
  if (json.value("version", 2) == 1) throw InputError("version 1 is read by delcert 0.1");
  CertificateSummary result;
  result.software = entries(json.at("software"));
  result.parameters = entries(json.at("parameters"));
  for (const auto& [level, margins] : json.at("levels").items()) result.levels.emplace_back(level, entries(margins));
  result.manifold = manifold_of(json.at("manifold"));
  result.family = json.at("manifold").at("family").get<std::string>();
  result.net_simplices = json.at("net_simplices").size();
  for (const Json& point : json.at("points")) {
    result.points.emplace_back();
    for (const Json& coordinate : point) result.points.back().push_back(parse_exact(coordinate.get<std::string>()));
  }
  result.simplices = json.at("simplices").get<std::vector<std::vector<std::uint32_t>>>();
  result.elements = json.at("elements").get<std::vector<std::vector<std::int32_t>>>();
  result.seal = json.at("sha256").get<std::string>();
  return result;
}

}  // namespace

CertificateSummary read_certificate(const std::filesystem::path& path) {
  const std::string bytes = read_text(path);
  try {
    return summary_of(Json::parse(bytes));
  } catch (const Json::exception& error) {
    throw InputError(path.string() + ": " + error.what());
  } catch (const InputError& error) {
    throw InputError(path.string() + ": " + error.what());
  }
}

}  // namespace delcert
