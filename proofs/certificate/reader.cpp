#include "proofs/certificate/reader.hpp"

#include <zstd.h>

#include <fstream>
#include <iterator>
#include <memory>
#include <nlohmann/json.hpp>

#include "kernel/error.hpp"
#include "kernel/number/exact_text.hpp"

namespace delcert {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::string_view zstd_magic("\x28\xB5\x2F\xFD", 4);

std::string file_bytes(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  if (!in) throw InputError(path.string() + ": cannot be opened");
  std::string bytes{std::istreambuf_iterator<char>(in), {}};
  if (in.bad()) throw InputError(path.string() + ": cannot be read");
  return bytes;
}

std::string decompressed(const std::string& bytes, const std::filesystem::path& path) {
  const std::unique_ptr<ZSTD_DCtx, std::size_t (*)(ZSTD_DCtx*)> context(ZSTD_createDCtx(), ZSTD_freeDCtx);
  if (!context) throw std::bad_alloc();
  std::string result;
  std::string chunk(ZSTD_DStreamOutSize(), '\0');
  ZSTD_inBuffer in{bytes.data(), bytes.size(), 0};
  std::size_t left = 1;
  while (left != 0) {
    const std::size_t before = in.pos;
    ZSTD_outBuffer out{chunk.data(), chunk.size(), 0};
    left = ZSTD_decompressStream(context.get(), &out, &in);
    if (ZSTD_isError(left) != 0) throw InputError(path.string() + ": zstd: " + ZSTD_getErrorName(left));
    result.append(chunk, 0, out.pos);
    if (left != 0 && out.pos == 0 && in.pos == before)
      throw InputError(path.string() + ": zstd: the file ends too early");
  }
  return result;
}

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
  result.stars = json.at("stars").get<std::vector<std::vector<std::vector<std::uint32_t>>>>();
  result.seal = json.at("sha256").get<std::string>();
  return result;
}

}  // namespace

CertificateSummary read_certificate(const std::filesystem::path& path) {
  std::string bytes = file_bytes(path);
  if (bytes.starts_with(zstd_magic)) bytes = decompressed(bytes, path);
  try {
    return summary_of(Json::parse(bytes));
  } catch (const Json::exception& error) {
    throw InputError(path.string() + ": " + error.what());
  } catch (const InputError& error) {
    throw InputError(path.string() + ": " + error.what());
  }
}

}  // namespace delcert
