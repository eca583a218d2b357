#include "tests/checker/support/forgeries.hpp"
#include "tests/checker/support/samples.hpp"

namespace delcert::checker_tests {

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
  const double epsilon = wide.model.epsilon.value();

  forge("protection one step too large", "1.protection", with_margin("protection", measured.protection + 0x1p-38));
  forge("circumradius one step too small", "1.radius", with_margin("circumradius", measured.circumradius - 0x1p-38));
  forge("thickness one step too good", "1.thickness", with_margin("thickness", measured.thickness + 0x1p-38));
  forge("balls smaller than any simplex", "1.vertices", with_margin("circumradius", 0.6 * measured.circumradius));

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
  return result;
}

}  // namespace delcert::checker_tests
