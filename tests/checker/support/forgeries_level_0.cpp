#include <algorithm>

#include "tests/checker/support/forgeries.hpp"
#include "tests/checker/support/graded_torus.hpp"

namespace delcert::checker_tests {
namespace {

/// The narrow torus without the net point of the label; the hexagon around it is cut into triangles from one corner.
Sample without_point(int label) {
  Sample result = narrow_torus().claiming({"0"});
  result.claims.hypotheses_2 = false;
  Model& model = result.model;
  std::vector<Labels> kept;
  std::vector<std::pair<int, int>> sides;  // of the hexagon, counterclockwise
  for (Labels simplex : model.net_simplices) {
    const auto place = std::find(simplex.begin(), simplex.end(), label);
    if (place == simplex.end()) {
      kept.push_back(simplex);
    } else {
      std::rotate(simplex.begin(), place, simplex.end());
      sides.emplace_back(simplex[1], simplex[2]);
    }
  }
  const int corner = sides[0].first;
  for (const auto& [from, to] : sides) {
    if (from != corner && to != corner) kept.push_back({corner, from, to});
  }
  for (Labels& simplex : kept) {
    for (int& j : simplex) j -= j > label ? 1 : 0;
  }
  model.net_simplices = kept;
  for (auto* points : {&model.net, &model.points}) points->erase(points->begin() + label);
  model.interior.pop_back();
  model.stars = stars_of(kept, model.interior);
  return result;
}

/// Half of all radii, and for that twice the bounds: nine tenths of the protection that there is.
Json graded_stars() {
  const Sample sample = graded_torus();
  Json result = graded_document(sample.claiming({"1", "2"}));
  for (Json& radius : result["radii"]) radius = radius_text(sample, 1, 2);
  result["levels"]["1"]["protection"] = at_most(sample.claims.margins.protection * 3.6).text();
  result["levels"]["1"]["circumradius"] = at_most(sample.claims.margins.circumradius * 2).text();
  return result;
}

/// Of radii that vary.
std::vector<Forgery> graded_forgeries() {
  std::vector<Forgery> result;
  const auto forge = [&](const std::string& name, const std::string& rule, Json document, auto change) {
    change(document);
    result.push_back({name, rule, sealed(document)});
  };
  const Sample sample = graded_torus();
  const Json whole = graded_document(sample), input = graded_document(sample.claiming({"0"}));
  forge("a radius that differs a little too much", "0.radii", input,
        [&](Json& d) { d["radii"][lesser_label] = radius_text(sample, 7999, 9000); });
  forge("a radius_variation a little too small", "0.radii", input,
        [](Json& d) { d["parameters"]["radius_variation"] = "124999/1000000"; });
  forge("separation a little too large for radii that vary", "0.separation", input,
        [&](Json& d) { d["parameters"]["separation"] = at_most(sample.model.mu.value() * 1.03).text(); });
  forge("radii a little too small for their net simplices", "0.ball", input, [&](Json& d) {
    // 1.7 times the covering radius, by 9/8, and by 9/8 again at the lesser label, is 1.34 times that.
    for (std::size_t i = 0; i < d["radii"].size(); ++i)
      d["radii"][i] = radius_text(sample, i == lesser_label ? 8 * 74 : 9 * 74, 900);
    d["parameters"]["perturbation"] = "1/20";
  });
  forge("a perturbation that is too large in charts of lesser radii", "0.perturbation", whole,
        [&](Json& d) { d["parameters"]["perturbation"] = at_most(sample.model.mu.value() / 4).text(); });
  forge("patches that reach farther than the lattice allows", "0.patch", input, [&](Json& d) {
    // 30 epsilon is more than the square root of 2, as 26.25 epsilon is not.
    d["parameters"]["radius_variation"] = "1/3";
    d["parameters"]["separation"] = "1/2";
    d["parameters"]["perturbation"] = "1/16";
  });
  forge("a circumradius too large for the lesser radius", "1.radius", graded_document(sample.claiming({"1", "2"})),
        [&](Json& d) { d["radii"][lesser_label] = radius_text(sample, 39, 50); });
  forge("a protection too large for the greater radii", "1.protection", graded_stars(), [&](Json& d) {
    // Of one simplex the radii are twice those of the others: what is claimed counts twice there.
    for (std::size_t k = 0; k < 3; ++k) d["radii"][d["simplices"][0][k].get<std::size_t>()] = radius_text(sample, 1, 1);
  });
  return result;
}

/// In theory mode, for mu = 1/4 and rho = 1/64, so that all constants are powers of 2: Gamma_0^2 = 2^-12 2^-6e/m^3,
/// 2 alpha~_0 = 2^17 2^-6 2^-3e 2^6 with e = 4m^2 + 5m + 21.
Json graded_theory() {
  Sample sample = graded_torus(72, 2.6).claiming({"0"});
  sample.claims.hypotheses_2 = true;
  sample.model.mu = {1, 4};
  sample.model.rho = {1, 64};
  Json result = graded_document(sample);
  result["parameters"]["flake_parameter_squared"] = "0x1p-297";
  result["parameters"]["tolerance"] = "0x1p-124";
  return result;
}

/// The sharper Hypotheses 2 for mu = 1, rho = 1/4, m = 2: Gamma_0 = 2^-49, 2 alpha~_0 = 34820 Gamma_0 = 17410/2^48.
Json sharper_theory() {
  Json result = narrow_torus().claiming({"0"}).document();
  result["levels"]["0"]["hypotheses"] = "sharper";
  result["parameters"]["flake_parameter_squared"] = "0x1p-98";
  result["parameters"]["tolerance"] = "17410/281474976710656";
  return result;
}

}  // namespace

std::vector<std::pair<std::string, std::string>> valid_graded_certificates() {
  const Sample sample = graded_torus();
  return {{"radii that vary, with equality", sealed(graded_document(sample))},
          {"radii that vary, without level 0", sealed(graded_stars())},
          {"four points on a circle that is large at the radius of one of them",
           sealed(graded_document_with_rectangle(5, 0))},
          {"radii that vary, in theory mode", sealed(graded_theory())},
          {"the sharper Hypotheses 2, with equality", sealed(sharper_theory())}};
}

std::vector<Forgery> level_0_forgeries() {
  std::vector<Forgery> result = graded_forgeries();
  const auto forge = [&](const std::string& name, const std::string& rule, Json document, auto change,
                         std::set<std::string> others = {}) {
    change(document);
    result.push_back({name, rule, sealed(document), 1, std::move(others)});
  };
  const Json wide = wide_torus().document(), narrow = narrow_torus().document(), ball = disc().document();
  const double epsilon = wide_torus().model.epsilon.value(), mu = wide_torus().model.mu.value();

  forge("separation a little too large", "0.separation", wide,
        [&](Json& d) { d["parameters"]["separation"] = at_most(mu * 1.002).text(); });
  forge("sampling radius a little too small", "0.ball", wide_torus().claiming({"0"}).document(), [&](Json& d) {
    d["parameters"]["sampling_radius"] = at_most(epsilon / 1.9001).text();
    d["parameters"]["perturbation"] = "1/10";
    d["parameters"]["separation"] = "1";
  });
  forge("a net point removed, the hole cut into triangles", "0.ball", without_point(100).document(), [](Json&) {},
        {"0.degree"});
  forge("a flat net simplex too many", "0.cycle", wide, [](Json& d) { d["net_simplices"].push_back({1, 0, 2}); });
  forge("a net simplex too few", "0.cycle", wide, [](Json& d) { d["net_simplices"].erase(17); }, {"0.degree"});
  forge("a net simplex turned over", "0.cycle", wide,
        [](Json& d) { std::swap(d["net_simplices"][3][0], d["net_simplices"][3][1]); }, {"0.degree"});
  forge("a net simplex of the ball too few", "0.cycle", ball, [](Json& d) {
    const Labels inner = disc().model.net_simplices[disc().model.net_simplices.size() / 2];
    d["net_simplices"].erase(disc().model.net_simplices.size() / 2);
  });
  forge("two copies of one net simplex instead of all", "0.degree", wide, [](Json& d) {
    const Json simplex = d["net_simplices"][0];
    d["net_simplices"] = Json::array({simplex, {simplex[1], simplex[0], simplex[2]}});
  });
  forge("no net simplices", "0.degree", wide, [](Json& d) { d["net_simplices"] = Json::array(); });
  forge("a double cover", "0.degree", wide, [](Json& d) {
    const Json once = d["net_simplices"];
    for (const Json& simplex : once) d["net_simplices"].push_back(simplex);
  });
  forge("the torus turned over", "0.degree", wide, [](Json& d) {
    for (Json& simplex : d["net_simplices"]) std::swap(simplex[0], simplex[1]);
  });
  forge("the ball turned over", "0.degree", ball, [](Json& d) {
    for (Json& simplex : d["net_simplices"]) std::swap(simplex[0], simplex[1]);
  });
  forge("no net simplices in a ball", "0.degree", ball, [](Json& d) { d["net_simplices"] = Json::array(); });
  forge("a point shifted by a generator of the lattice", "0.perturbation", wide_torus().claiming({"0"}).document(),
        [](Json& d) {
          Model model = wide_torus().model;
          d["points"][40][0] = (model.points[40][0] + Fraction{1, 1}).text();
        });
  forge("perturbation radius too small", "0.perturbation", wide,
        [](Json& d) { d["parameters"]["perturbation"] = "1/200"; });
  forge("short lattice vectors", "0.patch", wide, [&](Json& d) {
    // 24 epsilon is a little more than the square root of 2
    d["parameters"]["sampling_radius"] = at_most(1.41422 / 24).text();
    d["parameters"]["separation"] = "4/5";
    d["parameters"]["perturbation"] = "1/5";
  });
  Sample empty = disc().claiming({"0"});
  empty.model.radius = {79 * empty.model.epsilon.numerator, 10 * empty.model.epsilon.denominator};
  for (auto& star : empty.model.stars) star.clear();
  forge("no interior label", "0.patch", empty.document(), [](Json&) {});
  forge("tolerance a little too small", "0.hypotheses-2", narrow,
        [](Json& d) { d["parameters"]["tolerance"] = "0x1.ffffffffffffp-33"; });
  forge("flake parameter a little too small", "0.hypotheses-2", narrow, [](Json& d) {
    d["parameters"]["flake_parameter_squared"] = d["parameters"]["flake_parameter_squared"].get<std::string>() + "1";
  });
  forge("hypotheses of theory mode in measured mode", "0.hypotheses-2", narrow,
        [](Json& d) { d["parameters"]["mode"] = "measured"; });
  forge("the printed constants under the sharper hypotheses", "0.hypotheses-2",
        narrow_torus().claiming({"0"}).document(), [](Json& d) { d["levels"]["0"]["hypotheses"] = "sharper"; });
  forge("the sharper constants under the printed hypotheses", "0.hypotheses-2", sharper_theory(),
        [](Json& d) { d["levels"]["0"].erase("hypotheses"); });
  forge("tolerance a little too small for the sharper hypotheses", "0.hypotheses-2", sharper_theory(),
        [](Json& d) { d["parameters"]["tolerance"] = "17409/281474976710656"; });
  forge("radii of which some are more than twice others", "0.hypotheses-2", graded_theory(),
        [](Json& d) { d["parameters"]["radius_variation"] = "5/4"; });
  return result;
}

}  // namespace delcert::checker_tests
