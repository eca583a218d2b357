#include "tests/checker/support/forgeries.hpp"
#include "tests/checker/support/samples.hpp"

namespace delcert::checker_tests {

std::vector<Forgery> configuration_forgeries() {
  std::vector<Forgery> result;
  const auto forge = [&](const std::string& name, const std::string& rule, Json document, auto change) {
    change(document);
    result.push_back({name, rule, sealed(document), 1});
  };
  // The neighbours on the circle are so far apart that no three points are a candidate, whatever Gamma_0 is.
  forge("flake parameter too large for the lemma", "3.flake-parameter", circle().document(),
        [](Json& d) { d["parameters"]["flake_parameter_squared"] = "1"; });
  forge("flake parameter at which everything is a flake", "3.configuration", wide_torus().document(),
        [](Json& d) { d["parameters"]["flake_parameter_squared"] = "1/10000"; });

  // The rectangle with sides e_1 and e_1 + 2 e_2 (perpendicular in this metric) unperturbed: four points on a circle,
  // with a fifth at its centre, so that no star has anything to do with it.
  const auto unperturb = [](const Sample& sample, std::vector<std::size_t> labels) {
    Sample changed = sample;
    for (const std::size_t label : labels) changed.model.points[label] = changed.model.net[label];
    return changed;
  };
  const auto at = [](std::size_t x, std::size_t y) { return x % 28 + 28 * (y % 28); };
  for (const auto& [name, sample] : {std::pair("in the plane", wide_torus()), {"in a skewed basis", skewed_torus()}}) {
    forge(std::string("four points on a circle ") + name, "3.configuration",
          unperturb(sample, {at(26, 10), at(27, 10), at(27, 12), at(28, 12)}).document(), [](Json&) {});
  }
  return result;
}

}  // namespace delcert::checker_tests
