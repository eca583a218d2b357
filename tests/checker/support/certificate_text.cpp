#include "tests/checker/support/certificate_text.hpp"

#include <nettle/sha2.h>
#include <zstd.h>

#include <cmath>
#include <cstdio>
#include <map>

#include "tests/checker/support/edge_path.hpp"

namespace delcert::checker_tests {
namespace {

Json texts(const std::vector<std::vector<Fraction>>& points) {
  Json rows = Json::array();
  for (const auto& point : points) {
    Json row = Json::array();
    for (const Fraction& x : point) row.push_back(x.text());
    rows.push_back(row);
  }
  return rows;
}

/// mu = 1 and rho = 1/4: C = m^(3/2) 2^e with e = 4m^2 + 5m + 21, Gamma_0^2 = rho^2/C^2 = 1/(m^3 2^(2e+4)), and
/// 2 alpha~_0 = 2^17 m^(3/2) Gamma_0 = 2^(15 - e).
std::string theory_flake(int m) {
  const int e = 4 * m * m + 5 * m + 21;
  // 1/(m^3 2^(2e+4)) as a fraction: the denominator in decimal digits, by doubling.
  std::string digits = std::to_string(m * m * m);
  for (int k = 0; k < 2 * e + 4; ++k) {
    int carry = 0;
    for (auto digit = digits.rbegin(); digit != digits.rend(); ++digit) {
      const int twice = 2 * (*digit - '0') + carry;
      *digit = static_cast<char>('0' + twice % 10);
      carry = twice / 10;
    }
    if (carry > 0) digits.insert(digits.begin(), '1');
  }
  return "1/" + digits;
}

using Shift = std::vector<int>;

/// The loops of a torus, in the order of the coordinates.
Json loops_of(const Model& model, const std::vector<MovedSimplex<Shift>>& simplices) {
  const auto m = static_cast<std::size_t>(model.m);
  Json loops = Json::array();
  for (std::size_t axis = 0; axis < m; ++axis) {
    Shift end(m, 0);
    end[axis] = 1;
    const auto step = [&](Shift h, const Shift& a, const Shift& b) {
      for (std::size_t k = 0; k < m; ++k) h[k] += b[k] - a[k];
      return h;
    };
    const auto remaining = [&](int label, const Shift& h) {
      double sum = 0;
      std::vector<double> x;
      for (std::size_t k = 0; k < m; ++k)
        x.push_back(model.points[static_cast<std::size_t>(label)][k].value() - model.points[0][k].value() + h[k] -
                    end[k]);
      for (std::size_t i = 0; i < m; ++i) {
        for (std::size_t k = 0; k < m; ++k) sum += model.gram[i][k] * x[i] * x[k];
      }
      return sum;
    };
    loops.push_back(
        edge_path<Shift>(simplices, Shift(m, 0), step, remaining, [&](const Shift& h) { return h == end; }));
  }
  return loops;
}

/// The keys from `elements` on.
void add_complex(Json& document, const Model& model) {
  const auto m = static_cast<std::size_t>(model.m);
  std::vector<MovedSimplex<Shift>> simplices;
  std::map<Shift, int> numbers;
  for (const Labels& labels : simplices_of(model.stars)) {
    MovedSimplex<Shift>& simplex = simplices.emplace_back();
    simplex.labels = labels;
    simplex.motions = {Shift(m, 0)};
    for (const Shift& shift : nearest_shifts(model, labels)) {
      simplex.motions.push_back(shift);
      if (shift != Shift(m, 0)) numbers[shift] = 0;
    }
  }
  document["elements"] = Json::array();
  for (auto& [shift, number] : numbers) {
    document["elements"].push_back(shift);
    number = static_cast<int>(document["elements"].size());
  }
  document["simplices"] = Json::array();
  for (const auto& [labels, motions] : simplices) {
    Json row = labels;
    for (std::size_t k = 1; k <= m; ++k) row.push_back(motions[k] == Shift(m, 0) ? 0 : numbers[motions[k]]);
    document["simplices"].push_back(row);
  }
  document["loops"] = model.torus ? loops_of(model, simplices) : Json::array();
}

}  // namespace

Margins roomy(const Margins& measured) {
  return {measured.protection / 2, measured.thickness / 2, measured.circumradius * 1.2};
}

Json certificate(const Model& model, const Claims& claims) {
  Json manifold{{"name", "a test"}, {"family", model.torus ? "flat-torus" : "euclidean-ball"}, {"dimension", model.m}};
  if (model.torus) {
    manifold["gram"] = Json::array();
    for (const auto& row : model.gram) {
      Json texts_of_row = Json::array();
      for (const int entry : row) texts_of_row.push_back(std::to_string(entry));
      manifold["gram"].push_back(texts_of_row);
    }
  } else {
    manifold["radius"] = model.radius.text();
  }
  const int e = 4 * model.m * model.m + 5 * model.m + 21;
  const Json parameters{{"mode", claims.hypotheses_2 ? "theory" : "measured"},
                        {"candidates", "pruned"},
                        {"seed", "7"},
                        {"sampling_radius", model.epsilon.text()},
                        {"separation", model.mu.text()},
                        {"radius_variation", "0"},
                        {"distortion", "0"},
                        {"perturbation", model.rho.text()},
                        {"flake_parameter_squared", claims.hypotheses_2 ? theory_flake(model.m) : "0x1p-120"},
                        {"tolerance", claims.hypotheses_2 ? "0x1p-" + std::to_string(e - 15) : "0x1p-40"}};
  const auto [simplices, euler] = count(model.stars);
  Json levels = Json::object();
  for (const std::string name : {"0", "1", "2", "2s", "3", "4", "5", "6"}) {
    if (!claims.levels.contains(name)) continue;
    levels[name] = Json::object();
    if (name == "0") levels[name]["hypotheses_2"] = claims.hypotheses_2;
    if (name == "1") {
      levels[name] = Json{{"protection", at_most(claims.margins.protection).text()},
                          {"thickness", at_most(claims.margins.thickness).text()},
                          {"circumradius", (at_most(claims.margins.circumradius) + Fraction{1, 1ll << 40}).text()}};
    }
    if (name == "2")
      levels[name] = Json{{"simplices", simplices}, {"euler_characteristic", euler}, {"closed", model.torus}};
    if (name == "3") levels[name]["tested"] = "P1 to P4";
    if (name == "5") levels[name]["route"] = "space-form";
    if (name == "6") levels[name] = Json{{"self_delaunay", true}, {"bilipschitz", "1"}};
  }
  const bool input = claims.levels.contains("0");
  Json result{{"format", "delcert-certificate"},
              {"version", 2},
              {"software", Json{{"delcert", "test"}}},
              {"manifold", manifold},
              {"parameters", parameters},
              {"levels", levels},
              {"net", texts(model.net)},
              {"net_simplices", input ? Json(model.net_simplices) : Json::array()},
              {"points", texts(model.points)}};
  add_complex(result, model);
  return result;
}

std::string sha256_of(const std::string& text) {
  sha256_ctx context;
  sha256_init(&context);
  sha256_update(&context, text.size(), reinterpret_cast<const std::uint8_t*>(text.data()));
  std::uint8_t digest[SHA256_DIGEST_SIZE];
  sha256_digest(&context, sizeof digest, digest);
  std::string result;
  for (const std::uint8_t byte : digest) {
    char hexadecimal[3];
    std::snprintf(hexadecimal, sizeof hexadecimal, "%02x", byte);
    result += hexadecimal;
  }
  return result;
}

std::string sealed(const Json& document) {
  std::string text = document.dump();
  text.pop_back();
  return text + ",\"sha256\":\"" + sha256_of(text) + "\"}\n";
}

std::string resealed(const std::string& text) {
  const std::string before = text.substr(0, text.rfind(",\"sha256\":\""));
  return before + ",\"sha256\":\"" + sha256_of(before) + "\"}\n";
}

std::string zstd_compressed(const std::string& text) {
  std::string result(ZSTD_compressBound(text.size()), '\0');
  result.resize(ZSTD_compress(result.data(), result.size(), text.data(), text.size(), 3));
  return result;
}

}  // namespace delcert::checker_tests
