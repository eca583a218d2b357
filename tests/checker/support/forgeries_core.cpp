#include <algorithm>

#include "tests/checker/support/forgeries.hpp"
#include "tests/checker/support/samples.hpp"
#include "tests/checker/support/space_form_samples.hpp"

// Complexes that are not what they are said to be.

namespace delcert::checker_tests {
namespace {

Sample with_simplices(const Sample& sample, const std::vector<Labels>& simplices) {
  Sample result = sample;
  result.model.stars = stars_of(simplices, result.model.interior);
  return result;
}

/// Two triangles with a common edge, and the two across the other diagonal.
struct Diamond {
  Labels old_1, old_2, new_1, new_2;
};

Diamond diamond(const std::vector<Labels>& simplices) {
  const Labels& first = simplices[200];
  const auto second = std::find_if(simplices.begin(), simplices.end(), [&](const Labels& s) {
    return s != first && std::find(s.begin(), s.end(), first[0]) != s.end() &&
           std::find(s.begin(), s.end(), first[1]) != s.end();
  });
  const int across =
      *std::find_if(second->begin(), second->end(), [&](int j) { return j != first[0] && j != first[1]; });
  const auto sorted = [](Labels s) {
    std::sort(s.begin(), s.end());
    return s;
  };
  return {first, *second, sorted({first[0], first[2], across}), sorted({first[1], first[2], across})};
}

Sample without(const Sample& sample, std::size_t simplex) {
  std::vector<Labels> hole = simplices_of(sample.model.stars);
  hole.erase(hole.begin() + static_cast<std::ptrdiff_t>(simplex));
  return with_simplices(sample, hole);
}

/// The circle and itself once more, a little farther on.
Sample two_circles() {
  Sample result = circle();
  const std::size_t n = result.model.points.size();
  for (std::size_t i = 0; i < n; ++i) {
    for (auto* points : {&result.model.net, &result.model.points})
      points->push_back({(*points)[i][0] + Fraction{1, 71}});
    result.model.stars.push_back(result.model.stars[i]);
    for (Labels& simplex : result.model.stars.back()) simplex[0] += static_cast<int>(n);
  }
  return result;
}

/// An edge of the wide torus is cut by a point in its middle on one side only: on the other one is a flat triangle.
Sample with_a_flat_triangle() {
  Sample result = wide_torus();
  Model& model = result.model;
  std::vector<Labels> simplices = simplices_of(model.stars);
  const auto whole = std::find_if(simplices.begin() + 300, simplices.end(), [&](const Labels& labels) {
    const auto shifts = nearest_shifts(model, labels);
    return std::all_of(shifts.begin(), shifts.end(), [](const auto& z) { return z == std::vector<int>{0, 0}; });
  });
  const Labels triangle = *whole;
  simplices.erase(whole);
  const int middle = static_cast<int>(model.points.size());
  for (auto* points : {&model.net, &model.points}) {
    std::vector<Fraction> point;
    for (std::size_t k = 0; k < 2; ++k) {
      Fraction sum =
          (*points)[static_cast<std::size_t>(triangle[0])][k] + (*points)[static_cast<std::size_t>(triangle[1])][k];
      sum.denominator *= 2;
      point.push_back(sum);
    }
    points->push_back(point);
  }
  model.interior.push_back(true);
  for (const auto& [i, j] : {std::pair(0, 1), {0, 2}, {1, 2}})
    simplices.push_back({triangle[static_cast<std::size_t>(i)], triangle[static_cast<std::size_t>(j)], middle});
  return with_simplices(result, simplices);
}

/// A sphere of points with rational coordinates, without a group.
Json spherical_document(const std::vector<std::pair<std::string, std::string>>& net, const Json& simplices) {
  Json document = icosphere().document();
  Json& manifold = document["manifold"];
  manifold["generators"] = Json::array();
  manifold["injectivity_radius"] = "0";
  document["parameters"]["mode"] = "none";
  document["parameters"]["perturbation"] = "0";
  document["net"] = document["points"] = Json::array();
  for (const auto& [x, y] : net) {
    document["net"].push_back({x, y});
    document["points"].push_back({"0", "0"});
  }
  document["levels"] = Json::object();
  document["levels"]["2"] = Json{
      {"simplices", simplices.size()}, {"euler_characteristic", 2}, {"closed", true}, {"homology", {"Z", "0", "Z"}}};
  document["levels"]["5"] = Json{{"route", "space-form"}};
  document["elements"] = document["loops"] = Json::array();
  document["simplices"] = simplices;
  return document;
}

/// Of the points (±0.6, ±0.8, 0), (±0.8, ±0.6, 0) on a great circle.
const std::vector<std::pair<std::string, std::string>> equator = {{"1", "0"}, {"6", "0"}, {"-4", "0"}, {"-2/3", "0"}};

Json octahedron() {
  auto net = equator;
  net.insert(net.end(), {{"0", "2"}, {"0", "-2"}});
  return spherical_document(net, Json::parse("[[0,1,4,0,0],[0,1,5,0,0],[0,3,4,0,0],[0,3,5,0,0],"
                                             "[1,2,4,0,0],[1,2,5,0,0],[2,3,4,0,0],[2,3,5,0,0]]"));
}

/// The sphere over the sphere that is branched at the poles 8 and 9, around which the triangles go twice.
Json branched_sphere() {
  auto net = equator;
  net.insert(net.end(), equator.begin(), equator.end());
  net.insert(net.end(), {{"0", "2"}, {"0", "-2"}});
  std::vector<std::array<int, 5>> simplices;
  for (int k = 0; k < 8; ++k) {
    const int next = (k + 1) % 8;
    for (const int pole : {8, 9}) simplices.push_back({std::min(k, next), std::max(k, next), pole, 0, 0});
  }
  std::sort(simplices.begin(), simplices.end());
  return spherical_document(net, simplices);
}

/// The octahedron, said to be the quotient by half a turn about two of its vertices, one of which one triangle sees
/// turned: all positions agree.
Json octahedron_with_a_turned_vertex() {
  Json document = octahedron();
  document["manifold"]["generators"] =
      Json::parse(R"([[[["-1"],["0"],["0"]],[["0"],["-1"],["0"]],[["0"],["0"],["1"]]]])");
  document["elements"] = Json::parse("[[0,1]]");
  document["simplices"][2] = Json::parse("[0,3,4,0,1]");
  document["loops"] = Json::parse("[[2,0,2,0,2,0]]");
  return document;
}

}  // namespace

std::pair<std::string, std::string> valid_certificate_of_a_complex() {
  Json document = octahedron();
  const Json route = document["levels"]["5"];
  document["levels"].erase("5");
  document["levels"]["4"] = Json{{"protection", "0"}, {"circumradius", "1"}};
  document["levels"]["5"] = route;
  document["levels"]["6"] = Json{{"self_delaunay", true}, {"weight", "1"}, {"bilipschitz", {"1/2", "2"}}};
  return {"octahedron", sealed(document)};
}

std::vector<Forgery> core_forgeries() {
  std::vector<Forgery> result;
  const auto forge = [&](const std::string& name, const std::string& rule, const Json& document,
                         std::set<std::string> others = {}) {
    result.push_back({name, rule, sealed(document), 1, std::move(others)});
  };
  const auto changed = [](Json document, auto change) {
    change(document);
    return document;
  };
  const Sample& wide = wide_torus();
  const std::vector<Labels> simplices = simplices_of(wide.model.stars);

  forge("a flat triangle", "core.sign", with_a_flat_triangle().claiming({"2", "5"}).document());
  forge("a vertex that one triangle sees turned", "core.edges", octahedron_with_a_turned_vertex());
  forge("a sphere around which another one goes twice", "core.stars", branched_sphere());

  forge("a simplex missing from all stars", "core.facets", without(wide, 300).document());
  forge("a tetrahedron missing from all stars", "core.facets", without(cubic_torus(), 5000).document());
  forge("an arc of the circle missing", "core.facets", without(circle().claiming({"1", "2"}), 4).document());
  // Labels 0 and 400 change places in all stars: the same complex, but its simplices reach across the torus.
  std::vector<Labels> exchanged = simplices;
  for (Labels& simplex : exchanged) {
    for (int& j : simplex) j = j == 0 ? 400 : j == 400 ? 0 : j;
  }
  forge("two labels exchanged", "core.facets", with_simplices(wide, exchanged).document(), {"core.stars"});

  const Diamond d = diamond(simplices);
  std::vector<Labels> both = simplices;
  both.push_back(d.new_1);
  both.push_back(d.new_2);
  forge("both diagonals of a quadrilateral", "core.facets", with_simplices(wide, both).document(), {"core.stars"});
  std::vector<Labels> flipped = simplices;
  std::replace(flipped.begin(), flipped.end(), d.old_1, d.new_1);
  std::replace(flipped.begin(), flipped.end(), d.old_2, d.new_2);
  Sample flip = with_simplices(wide, flipped);
  forge("a flip", "core.hinges", flip.claiming({"2", "4", "5"}).document());
  const Margins measured = measure(wide.model);
  flip.claims.margins = {measured.protection / 2, 0.1, 1.9 * measured.circumradius};
  forge("a flip in stars", "1.protection", flip.claiming({"1", "2"}).document());

  forge("the union of two disjoint circles", "core.connected", two_circles().claiming({"2", "5"}).document());
  forge("the stars of two disjoint circles", "1.protection", two_circles().claiming({"1", "2"}).document());
  forge("the loops of two translations exchanged", "core.group",
        changed(wide.claiming({"2", "5"}).document(), [](Json& j) { std::swap(j["loops"][0], j["loops"][1]); }));
  forge("a projective plane whose generator has an empty loop", "core.group",
        changed(projective_plane().claiming({"2", "5"}).document(), [](Json& j) { j["loops"][0] = Json::array(); }));
  // Classes of mistakes that several rules see.
  Sample identified = wide;
  identified.model.points[50] = identified.model.points[51];
  identified.model.net[50] = identified.model.net[51];
  forge("two vertices identified", "core.sign", identified.claiming({"0", "2"}).document(), {"0.separation"});
  // On a ball there is no core.
  std::vector<Labels> hole = simplices_of(disc().model.stars);
  hole.erase(std::find_if(hole.begin(), hole.end(), [](const Labels& labels) {
    return std::all_of(labels.begin(), labels.end(),
                       [](int j) { return disc().model.interior[static_cast<std::size_t>(j)]; });
  }));
  forge("a triangle missing from all stars of a ball", "1.facets", with_simplices(disc(), hole).document());
  return result;
}

}  // namespace delcert::checker_tests
