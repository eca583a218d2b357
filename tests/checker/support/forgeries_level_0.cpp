#include <algorithm>

#include "tests/checker/support/forgeries.hpp"
#include "tests/checker/support/samples.hpp"

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

}  // namespace

std::vector<Forgery> level_0_forgeries() {
  std::vector<Forgery> result;
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
  return result;
}

}  // namespace delcert::checker_tests
