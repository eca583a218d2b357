#include <algorithm>
#include <iterator>

#include "tests/checker/support/forgeries.hpp"
#include "tests/checker/support/space_form_samples.hpp"

namespace delcert::checker_tests {

std::vector<std::pair<std::string, std::string>> valid_space_form_certificates() {
  std::vector<std::pair<std::string, std::string>> result;
  for (const auto& [name, sample] : {std::pair("icosphere", icosphere()),
                                     {"projective plane", projective_plane()},
                                     {"600-cell", cell_600()},
                                     {"projective space", projective_space()},
                                     {"Bolza surface", bolza_surface()},
                                     {"Klein bottle", klein_bottle()},
                                     {"unstable Bolza surface", unstable_bolza_surface()},
                                     {"surface with a crosscap far from o", far_crosscap()}}) {
    result.emplace_back(name, sealed(sample.document()));
  }
  using Groups = std::vector<std::string>;
  for (const auto& [name, sample, groups] :
       {std::tuple("sphere with homology", icosphere(), Groups{"Z", "0", "Z"}),
        {"projective plane with homology", projective_plane(), {"Z", "Z/2", "0"}},
        {"projective space with homology", projective_space(), {"Z", "Z/2", "0", "Z"}},
        {"Bolza surface with homology", bolza_surface(), {"Z", "Z^4", "Z"}},
        {"Klein bottle with homology", klein_bottle(), {"Z", "Z + Z/2", "0"}}}) {
    Json document = sample.document();
    document["levels"]["2"]["homology"] = groups;
    result.emplace_back(name, sealed(document));
  }
  result.push_back(valid_certificate_of_a_complex());
  SpaceFormSample riemannian = klein_bottle();
  riemannian.levels.insert("5r");
  result.emplace_back("Klein bottle of Riemannian simplices", sealed(riemannian.document()));
  return result;
}

namespace {

std::vector<Forgery> forgeries_of_groups() {
  std::vector<Forgery> result;
  const auto forge = [&](const std::string& name, const std::string& rule, const SpaceFormSample& sample, auto change) {
    Json document = sample.document();
    change(document);
    result.push_back({name, rule, sealed(document)});
  };
  const auto generators = [](Json& j) -> Json& { return j["manifold"]["generators"]; };
  forge("the identity as a generator", "group.generator", icosphere(), [&](Json& j) {
    generators(j).push_back(j["manifold"]["gram"]);
    Json& g = generators(j).back();
    for (Json& row : g) row.push_back(Json::array({"0"}));
    g.push_back(Json::array({Json::array({"0"}), Json::array({"0"}), Json::array({"1"})}));
    j["loops"].push_back(Json::array());
  });
  forge("a sphere wider than it is", "group.injectivity", icosphere(),
        [](Json& j) { j["manifold"]["injectivity_radius"] = "22/7"; });
  forge("a projective plane wider than it is", "group.injectivity", projective_plane(),
        [](Json& j) { j["manifold"]["injectivity_radius"] = "11/7"; });
  forge("a Klein bottle wider than it is", "group.injectivity", klein_bottle(),
        [](Json& j) { j["manifold"]["injectivity_radius"] = "501/1000"; });
  forge("a Bolza surface wider than it is", "group.injectivity", bolza_surface(),
        [](Json& j) { j["manifold"]["injectivity_radius"] = "153/100"; });
  // The element that moves a point by 2 log 2 is no side of the octagon, nor near to one.
  forge("a crosscap far from o wider than it is", "group.injectivity", far_crosscap(),
        [](Json& j) { j["manifold"]["injectivity_radius"] = "7/10"; });
  // The square of the first generator: in the group, but no side of the octagon.
  forge("a generator too many", "group.polyhedron", bolza_surface(), [&](Json& j) {
    const auto entry = [](const std::string& a, const std::string& b) { return Json::array({a, b}); };
    const Json zero = Json::array({"0"}), one = Json::array({"1"});
    // cosh 2l = 2c^2 - 1 = 113 + 80t; sinh 2l = 2cS: 2c = 10 + 8t in the first row, times S^2 in the first column.
    generators(j).push_back(
        Json::array({Json::array({entry("113", "80"), entry("10", "8"), zero}),
                     Json::array({entry("1200", "848"), entry("113", "80"), zero}), Json::array({zero, zero, one})}));
    Json twice = j["loops"][0];
    for (const Json& number : j["loops"][0]) twice.push_back(number);
    j["loops"].push_back(twice);
  });
  return result;
}

/// The same labels under other names.
SpaceFormSample renamed(const SpaceFormSample& sample, const std::function<int(int)>& name) {
  SpaceFormSample result = sample;
  for (std::size_t i = 0; i < sample.model.size(); ++i) {
    std::vector<Labels> star = sample.model.stars[i];
    for (Labels& simplex : star) {
      std::transform(simplex.begin(), simplex.end(), simplex.begin(), name);
      std::sort(simplex.begin(), simplex.end());
    }
    std::sort(star.begin(), star.end());
    result.model.stars[static_cast<std::size_t>(name(static_cast<int>(i)))] = star;
  }
  return result;
}

/// The first simplex of star(i) is left out of all stars.
SpaceFormSample pierced(const SpaceFormSample& sample, int i) {
  SpaceFormSample result = sample;
  Labels all = sample.model.stars[static_cast<std::size_t>(i)][0];
  all.push_back(i);
  for (const int j : all) {
    Labels others;
    std::copy_if(all.begin(), all.end(), std::back_inserter(others), [j](int k) { return k != j; });
    std::sort(others.begin(), others.end());
    std::erase(result.model.stars[static_cast<std::size_t>(j)], others);
  }
  return result;
}

/// Of levels 1 and 2: what stars are, and what they make together.
std::vector<Forgery> forgeries_of_stars() {
  std::vector<Forgery> result;
  const auto forge = [&](
                         const std::string& name, const std::string& rule, const SpaceFormSample& sample,
                         const std::function<void(Json&)>& change = [](Json&) {}) {
    Json document = sample.document();
    change(document);
    result.push_back({name, rule, sealed(document)});
  };
  const auto homology = [](const std::vector<std::string>& groups) {
    return [=](Json& j) { j["levels"]["2"]["homology"] = groups; };
  };
  const int other = static_cast<int>(icosphere().model.size()) / 2;
  const SpaceFormSample exchanged = renamed(icosphere().claiming({"1", "2"}), [other](int j) {
    return j == 0 ? other : j == other ? 0 : j;
  });
  result.push_back(
      {"two points of the sphere exchanged", "core.facets", sealed(exchanged.document()), 1, {"core.stars"}});
  forge("a hole in the sphere", "core.facets", pierced(icosphere(), 20));
  forge("a hole in the projective space", "core.facets", pierced(projective_space(), 20));
  forge("a hole in the Klein bottle", "core.facets", pierced(klein_bottle(), 20));
  forge("the Euler characteristic of a sphere", "2.count", bolza_surface(),
        [](Json& j) { j["levels"]["2"]["euler_characteristic"] = 2; });
  forge("a tetrahedron too few is counted", "2.count", cell_600(),
        [](Json& j) { j["levels"]["2"]["simplices"] = 599; });
  forge("the homology of a sphere", "2.homology", projective_plane(), homology({"Z", "0", "Z"}));
  forge("the homology of a torus", "2.homology", klein_bottle(), homology({"Z", "Z^2", "Z"}));
  forge("the homology of another genus", "2.homology", bolza_surface(), homology({"Z", "Z^6", "Z"}));
  forge("the homology of a lens space", "2.homology", projective_space(), homology({"Z", "Z/5", "0", "Z"}));
  return result;
}

/// What charts do to distances, stated a little too well.
std::vector<Forgery> forgeries_of_distortion() {
  std::vector<Forgery> result;
  for (const auto& of : {std::pair("the sphere", icosphere()),
                         {"the projective plane", projective_plane()},
                         {"the Bolza surface", bolza_surface()}}) {
    const SpaceFormSample& sample = of.second;
    const auto forge = [&](const std::string& rule, const std::string& key, double value) {
      Json document = sample.document();
      document["levels"]["0"][key] = at_most(value / 1.003).text();
      result.push_back({"charts of " + std::string(of.first) + " better than they are", rule, sealed(document)});
    };
    forge("0.distortion", "distortion", transition_distortion(sample.model));
    forge("0.metric-distortion", "metric_distortion", metric_distortion(sample.model));
  }
  return result;
}

}  // namespace

std::vector<Forgery> space_form_forgeries() {
  std::vector<Forgery> result = forgeries_of_groups();
  for (const auto& part : {forgeries_of_stars(), forgeries_of_distortion()})
    result.insert(result.end(), part.begin(), part.end());
  const auto forge = [&](const std::string& name, const std::string& rule, const SpaceFormSample& sample, auto change,
                         int status = 1) {
    Json document = sample.document();
    change(document);
    result.push_back({name, rule, sealed(document), status});
  };
  const auto level = [](const std::string& name, const std::string& key, double value) {
    return [=](Json& j) { j["levels"][name][key] = at_most(value).text(); };
  };
  const auto parameter = [](const std::string& key, double value) {
    return [=](Json& j) { j["parameters"][key] = at_most(value).text(); };
  };
  const SpaceFormMargins &sphere = icosphere().margins, &solid = cell_600().margins, &bolza = bolza_surface().margins,
                         &klein = klein_bottle().margins;

  forge("points closer than stated", "0.separation", bolza_surface(), parameter("separation", 0.92));
  forge("a density too good", "0.density", icosphere(), level("0", "density", sphere.ball));
  forge("charts too large for the Klein bottle", "0.patch", klein_bottle(), [](Json& j) {
    j["parameters"]["sampling_radius"] = "42/1000";
    j["parameters"]["separation"] = "8/9";
    j["levels"]["0"]["density"] = "1";
  });
  forge("charts too large for the sphere", "0.patch", icosphere(), [](Json& j) {
    // 9 epsilon is more than pi/2, and 12 epsilon less than the injectivity radius.
    j["parameters"]["sampling_radius"] = "7/40";
    j["parameters"]["separation"] = "2/5";
    j["levels"]["0"]["density"] = "1";
    j["levels"]["0"]["distortion"] = "2";
    j["levels"]["0"]["metric_distortion"] = "1";
  });
  forge("points moved farther than stated", "1.perturbation", klein_bottle(), parameter("perturbation", 0.19));
  forge("points moved although none should be", "1.perturbation", projective_space(), parameter("perturbation", 0));
  forge("protection too large in a chart", "1.protection", icosphere(),
        level("1", "protection", 2.1 * sphere.protection));
  // Flat charts, in which a simplex is looked at once.
  forge("protection too large in a chart of the Klein bottle", "1.protection", klein_bottle(),
        level("1", "protection", 2.1 * klein.protection));
  forge("thickness too large in a chart of the Klein bottle", "1.thickness", klein_bottle(),
        level("1", "thickness", 1.6 * klein.thickness));
  forge("a circumradius too small in a chart of the Klein bottle", "1.radius", klein_bottle(),
        level("1", "circumradius", klein.circumradius / 1.011));
  forge("balls smaller than any simplex", "1.vertices", icosphere(),
        level("1", "circumradius", 0.3 * sphere.circumradius));
  forge("charts of a Klein bottle that may be thin", "1.patch", klein_bottle().claiming({"1", "2"}),
        [](Json& j) { j["manifold"]["injectivity_radius"] = "0"; });
  forge("thickness too large in a chart", "1.thickness", cell_600(), level("1", "thickness", 1.6 * solid.thickness));
  forge("a circumradius too small in a chart", "1.radius", bolza_surface(),
        level("1", "circumradius", bolza.circumradius / 1.011));
  forge("balls larger than a chart of the sphere", "1.patch", icosphere(), level("1", "circumradius", 0.49));
  forge("a star that differs in another chart", "2s.protection", unstable_bolza_surface(), [](Json& j) {
    Json levels = Json::object();
    for (const auto& [name, value] : j["levels"].items()) {
      if (name == "4") levels["2s"] = Json{{"reach", "0x1p-1"}};
      levels[name] = value;
    }
    j["levels"] = levels;
  });
  forge("charts that need not show so much", "2s.reach", bolza_surface(), level("2s", "reach", bolza.reach / 1.02));
  forge("charts of the Klein bottle that need not show so much", "2s.reach", klein_bottle(),
        level("2s", "reach", klein.reach / 1.02));
  forge("charts that show too much", "2s.patch", icosphere(), level("2s", "reach", 1));
  forge("balls as large as half a sphere", "4.ball", projective_space(), level("4", "circumradius", 1.6));
  forge("circumballs larger than stated", "4.ball", cell_600(), level("4", "circumradius", solid.ball / 1.011));
  forge("circumballs of the Bolza surface larger than stated", "4.ball", bolza_surface(),
        level("4", "circumradius", bolza.ball / 1.011));
  forge("circumballs less empty than stated", "4.empty", cell_600(), level("4", "protection", 8 * solid.empty));
  forge("circumballs of the Klein bottle less empty than stated", "4.empty", klein_bottle(),
        level("4", "protection", 8 * klein.empty));

  SpaceFormSample riemannian = klein_bottle(), curved = icosphere();
  riemannian.levels.insert("5r");
  curved.levels.insert("5r");
  forge("thickness too large for Riemannian simplices", "5.thickness", riemannian,
        level("5", "thickness", 1.02 * klein.riemannian_thickness));
  forge("Riemannian simplices larger than stated", "5.radius", riemannian,
        level("5", "radius", klein.riemannian_radius / 1.02));
  forge("simplices too large for the curvature", "5.radius", curved, [](Json&) {});
  forge("cotangents greater than stated", "6.self-delaunay", bolza_surface(),
        level("6", "weight", 1.002 * bolza.weight + 1e-4));
  forge("distances stretched more than stated", "6.bilipschitz", icosphere(),
        [](Json& j) { j["levels"]["6"]["bilipschitz"][0] = "1"; });
  forge("distances of the Bolza surface stretched more than stated", "6.bilipschitz", bolza_surface(),
        [](Json& j) { j["levels"]["6"]["bilipschitz"][1] = "1"; });
  forge("an isometry that shrinks", "6.bilipschitz", klein_bottle(),
        [](Json& j) { j["levels"]["6"]["bilipschitz"][1] = "0x1.fffp-1"; });

  forge(
      "a perturbation of a sphere in the mode none", "form.mode", icosphere(),
      [](Json& j) { j["parameters"]["mode"] = "none"; }, 3);
  forge(
      "net simplices on a sphere", "form.net-simplices", icosphere(),
      [](Json& j) { j["net_simplices"] = Json::parse("[[0,1,2]]"); }, 3);
  forge(
      "the mode theory on a sphere", "form.family", icosphere(), [](Json& j) { j["parameters"]["mode"] = "theory"; },
      3);
  return result;
}

}  // namespace delcert::checker_tests
