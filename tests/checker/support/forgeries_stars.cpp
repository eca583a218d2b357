#include <algorithm>

#include "tests/checker/support/forgeries.hpp"
#include "tests/checker/support/samples.hpp"

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

}  // namespace

std::vector<Forgery> star_forgeries() {
  std::vector<Forgery> result;
  const auto forge = [&](const std::string& name, const std::string& rule, Json document,
                         std::set<std::string> others = {}) {
    result.push_back({name, rule, sealed(document), 1, std::move(others)});
  };
  const auto changed = [](Json document, auto change) {
    change(document);
    return document;
  };
  const Sample& wide = wide_torus();
  const Margins measured = measure(wide.model);
  const auto with_margin = [&](const std::string& name, double value) {
    return changed(wide.document(), [&](Json& d) { d["levels"]["1"][name] = at_most(value).text(); });
  };
  const std::vector<Labels> simplices = simplices_of(wide.model.stars);
  const double epsilon = wide.model.epsilon.value();

  // Labels 0 and 400 change places in all stars: the same complex, but their simplices reach across the torus.
  std::vector<Labels> exchanged = simplices;
  for (Labels& simplex : exchanged) {
    for (int& j : simplex) j = j == 0 ? 400 : j == 400 ? 0 : j;
  }
  forge("two labels exchanged", "1.vertices", with_simplices(wide, exchanged).document());

  forge("protection one step too large", "1.protection", with_margin("protection", measured.protection + 0x1p-38));
  forge("circumradius one step too small", "1.radius", with_margin("circumradius", measured.circumradius - 0x1p-38));
  forge("thickness one step too good", "1.thickness", with_margin("thickness", measured.thickness + 0x1p-38));

  const Diamond d = diamond(simplices);
  Sample generous = wide;
  generous.claims.margins = {measured.protection / 2, 0.1, 1.9 * measured.circumradius};
  std::vector<Labels> flipped = simplices;
  std::replace(flipped.begin(), flipped.end(), d.old_1, d.new_1);
  std::replace(flipped.begin(), flipped.end(), d.old_2, d.new_2);
  forge("a flip", "1.protection", with_simplices(generous, flipped).document());
  std::vector<Labels> both = simplices;
  both.push_back(d.new_1);
  both.push_back(d.new_2);
  forge("both diagonals of a quadrilateral", "1.facets", with_simplices(generous, both).document(), {"1.protection"});

  std::vector<Labels> hole = simplices;
  hole.erase(hole.begin() + 300);
  forge("a simplex missing from all stars", "1.facets", with_simplices(wide, hole).document());
  std::vector<Labels> cubic = simplices_of(cubic_torus().model.stars);
  cubic.erase(cubic.begin() + 5000);
  forge("a tetrahedron missing from all stars", "1.facets", with_simplices(cubic_torus(), cubic).document());
  Sample open = circle().claiming({"1", "2"});
  std::vector<Labels> arcs = simplices_of(open.model.stars);
  arcs.erase(arcs.begin() + 4);
  forge("an arc of the circle missing", "1.facets", with_simplices(open, arcs).document());

  forge("balls larger than a chart", "1.patch", changed(wide.claiming({"0", "1", "2"}).document(), [&](Json& j) {
          j["levels"]["1"]["circumradius"] = at_most(4.01 * epsilon).text();
        }));
  forge("balls that go around the torus", "1.patch",
        changed(narrow_torus().claiming({"1", "2"}).document(), [&](Json& j) {
          j["parameters"]["sampling_radius"] = "1/10";
          j["levels"]["1"]["circumradius"] = "37/100";
        }));

  forge("one simplex too many is counted", "2.count",
        changed(wide.document(), [](Json& j) { j["levels"]["2"]["simplices"] = 28 * 28 * 2 + 1; }));
  forge("the Euler characteristic of a sphere", "2.count",
        changed(wide.document(), [](Json& j) { j["levels"]["2"]["euler_characteristic"] = 2; }));
  forge("a closed disc", "2.count", changed(disc().document(), [](Json& j) { j["levels"]["2"]["closed"] = true; }));
  forge("an open torus", "2.count", changed(wide.document(), [](Json& j) { j["levels"]["2"]["closed"] = false; }));

  const auto with_homology = [&](const Sample& sample, const std::vector<std::string>& groups) {
    return changed(sample.document(), [&](Json& j) { j["levels"]["2"]["homology"] = groups; });
  };
  forge("the homology of a Klein bottle", "2.homology", with_homology(wide, {"Z", "Z + Z/2", "0"}));
  forge("the homology of a sphere", "2.homology", with_homology(wide, {"Z", "0", "Z"}));
  forge("two circles", "2.homology", with_homology(circle(), {"Z^2", "Z^2"}));
  forge("torsion in a torus", "2.homology", with_homology(cubic_torus(), {"Z", "Z^3 + Z/2", "Z^3", "Z"}));
  forge("a disc with a hole", "2.homology", with_homology(disc(), {"Z", "Z", "0"}));

  forge("stars that other charts do not see", "2s.patch", with_margin("circumradius", 2.4 * epsilon));

  // Classes of mistakes that several rules see.
  Sample identified = wide;
  identified.model.points[50] = identified.model.points[51];
  identified.model.net[50] = identified.model.net[51];
  forge("two vertices identified", "1.protection", identified.document(), {"0.separation", "1.vertices"});
  Sample twice = circle().claiming({"1", "2"});
  const std::size_t n = twice.model.points.size();
  for (std::size_t i = 0; i < n; ++i) {
    for (auto* points : {&twice.model.net, &twice.model.points}) points->push_back({(*points)[i][0] + Fraction{1, 71}});
    twice.model.stars.push_back(twice.model.stars[i]);
    for (Labels& simplex : twice.model.stars.back()) simplex[0] += static_cast<int>(n);
  }
  forge("the union of two disjoint circles", "1.protection", twice.document());
  return result;
}

}  // namespace delcert::checker_tests
