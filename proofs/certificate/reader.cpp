#include "proofs/certificate/reader.hpp"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <set>

#include "kernel/number/exact_text.hpp"
#include "proofs/certificate/file_text.hpp"
#include "proofs/certificate/json_text.hpp"
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

std::vector<Rational> exact_row(JsonText& text) {
  std::vector<Rational> result;
  text.list([&] { result.push_back(parse_exact(text.string())); });
  return result;
}

std::vector<std::vector<Rational>> exact_rows(JsonText& text) {
  std::vector<std::vector<Rational>> result;
  text.list([&] { result.push_back(exact_row(text)); });
  return result;
}

template <class Integer>
std::vector<std::vector<Integer>> integer_rows(JsonText& text) {
  std::vector<std::vector<Integer>> result;
  std::size_t length = 0;
  text.list([&] {
    std::vector<Integer>& row = result.emplace_back();
    row.reserve(length);
    text.list([&] { row.push_back(text.integer<Integer>()); });
    length = row.size();
  });
  return result;
}

Json tree_of(JsonText& text) { return Json::parse(text.skip()); }

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

void read_manifold(JsonText& text, CertificateSummary& result) {
  const std::string_view manifold = text.skip();
  const Json json = Json::parse(manifold);
  result.manifold = manifold_of(json);
  result.family = json.at("family").get<std::string>();
  result.manifold_text = manifold;
}

struct KeyOfCertificate {
  std::string_view key;
  bool is_required;
  void (*read)(JsonText&, CertificateSummary&);
};

constexpr std::array<KeyOfCertificate, 13> keys_of_certificates{{
    {"version", false,
     [](JsonText& text, CertificateSummary&) {
       if (tree_of(text) == 1) throw InputError("version 1 is read by delcert 0.1");
     }},
    {"software", true, [](JsonText& text, CertificateSummary& result) { result.software = entries(tree_of(text)); }},
    {"manifold", true, read_manifold},
    {"parameters", true,
     [](JsonText& text, CertificateSummary& result) { result.parameters = entries(tree_of(text)); }},
    {"levels", true,
     [](JsonText& text, CertificateSummary& result) {
       result.levels.clear();
       const Json levels = tree_of(text);
       for (const auto& [level, margins] : levels.items()) result.levels.emplace_back(level, entries(margins));
     }},
    {"net", true, [](JsonText& text, CertificateSummary& result) { result.net_text = text.skip(); }},
    {"charts", false, [](JsonText& text, CertificateSummary& result) { result.charts = exact_rows(text); }},
    {"radii", false, [](JsonText& text, CertificateSummary& result) { result.radii = exact_row(text); }},
    {"net_simplices", true,
     [](JsonText& text, CertificateSummary& result) {
       result.net_simplices = 0;
       text.list([&] {
         (void)text.skip();
         ++result.net_simplices;
       });
     }},
    {"points", true, [](JsonText& text, CertificateSummary& result) { result.points = exact_rows(text); }},
    {"elements", true,
     [](JsonText& text, CertificateSummary& result) { result.elements = integer_rows<std::int32_t>(text); }},
    {"simplices", true,
     [](JsonText& text, CertificateSummary& result) { result.simplices = integer_rows<std::uint32_t>(text); }},
    {"sha256", true, [](JsonText& text, CertificateSummary& result) { result.seal = text.string(); }},
}};

CertificateSummary summary_of(std::string_view bytes) {
  CertificateSummary result;
  std::set<std::string_view> found;
  JsonText text(bytes);
  text.object([&](std::string_view key) {
    const auto known = std::find_if(keys_of_certificates.begin(), keys_of_certificates.end(),
                                    [key](const KeyOfCertificate& each) { return each.key == key; });
    if (known == keys_of_certificates.end()) {
      (void)text.skip();
      return;
    }
    found.insert(known->key);
    try {
      known->read(text, result);
    } catch (const Json::exception& error) {
      throw InputError(std::string(key) + ": " + error.what());
    }
  });
  text.expect_end();
  for (const KeyOfCertificate& each : keys_of_certificates) {
    if (each.is_required && !found.contains(each.key))
      throw InputError("there is no key \"" + std::string(each.key) + "\"");
  }
  return result;
}

}  // namespace

std::vector<std::vector<Rational>> CertificateSummary::net() const {
  JsonText text(net_text);
  return exact_rows(text);
}

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
    CertificateSummary result = summary_of(bytes);
    result.sealed_bytes = digest_of_sealed(bytes);
    return result;
  } catch (const InputError& error) {
    throw InputError(path.string() + ": " + error.what());
  }
}

}  // namespace delcert
