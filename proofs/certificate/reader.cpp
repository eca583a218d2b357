#include "proofs/certificate/reader.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "kernel/number/exact_text.hpp"
#include "proofs/certificate/file_text.hpp"
#include "proofs/certificate/sha256.hpp"
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

std::vector<Rational> exact_row(const Json& numbers) {
  std::vector<Rational> result;
  for (const Json& number : numbers) result.push_back(parse_exact(number.get<std::string>()));
  return result;
}

std::vector<std::vector<Rational>> exact_rows(const Json& rows) {
  std::vector<std::vector<Rational>> result;
  for (const Json& row : rows) result.push_back(exact_row(row));
  return result;
}

/// Of the bytes that the seal is said to be of.
std::string digest_of_sealed(const std::string& bytes) {
  const std::size_t end = bytes.rfind(",\"sha256\":\"");
  Sha256 hash;
  hash.update(std::string_view(bytes).substr(0, end));
  return hash.digest();
}

const std::string* value_of(const std::vector<std::pair<std::string, std::string>>& entries, const std::string& key) {
  const auto found =
      std::find_if(entries.begin(), entries.end(), [&](const auto& entry) { return entry.first == key; });
  return found == entries.end() ? nullptr : &found->second;
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
  result.manifold_text = json.at("manifold").dump();
  result.points = exact_rows(json.at("points"));
  result.net = exact_rows(json.at("net"));
  if (json.contains("charts")) result.charts = exact_rows(json.at("charts"));
  if (json.contains("radii")) result.radii = exact_row(json.at("radii"));
  result.simplices = json.at("simplices").get<std::vector<std::vector<std::uint32_t>>>();
  result.elements = json.at("elements").get<std::vector<std::vector<std::int32_t>>>();
  result.seal = json.at("sha256").get<std::string>();
  return result;
}

}  // namespace

Rational CertificateSummary::parameter(const std::string& key) const {
  const std::string* value = value_of(parameters, key);
  if (value == nullptr) throw InputError("parameters: no key \"" + key + "\"");
  return parse_exact(*value);
}

std::optional<Rational> CertificateSummary::margin(const std::string& level, const std::string& key) const {
  for (const auto& [name, margins] : levels) {
    if (name != level) continue;
    const std::string* value = value_of(margins, key);
    if (value != nullptr) return parse_exact(*value);
  }
  return std::nullopt;
}

CertificateSummary read_certificate(const std::filesystem::path& path) {
  const std::string bytes = read_text(path);
  try {
    CertificateSummary result = summary_of(Json::parse(bytes));
    result.sealed_bytes = digest_of_sealed(bytes);
    return result;
  } catch (const Json::exception& error) {
    throw InputError(path.string() + ": " + error.what());
  } catch (const InputError& error) {
    throw InputError(path.string() + ": " + error.what());
  }
}

}  // namespace delcert
