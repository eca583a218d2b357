#include "tests/checker/support/forgeries.hpp"
#include "tests/checker/support/graded_torus.hpp"
#include "tests/checker/support/samples.hpp"

namespace delcert::checker_tests {

namespace {

Sample unperturbed(Sample sample, const std::vector<std::size_t>& labels) {
  for (const std::size_t label : labels) sample.model.points[label] = sample.model.net[label];
  return sample;
}
std::size_t label_at(std::size_t x, std::size_t y) { return x % 28 + 28 * (y % 28); }

}  // namespace

Json graded_document_with_rectangle(std::size_t x, std::size_t y) {
  return graded_document(unperturbed(
      graded_torus(), {label_at(x, y), label_at(x + 2, y), label_at(x + 1, y + 2), label_at(x + 3, y + 2)}));
}

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
  for (const auto& [name, sample] : {std::pair("in the plane", wide_torus()), {"in a skewed basis", skewed_torus()}}) {
    forge(std::string("four points on a circle ") + name, "3.configuration",
          unperturbed(sample, {label_at(26, 10), label_at(27, 10), label_at(27, 12), label_at(28, 12)}).document(),
          [](Json&) {});
  }
  // The rectangle with sides 2 e_1 and e_1 + 2 e_2: its diagonals are longer than 5/2 epsilon, and shorter than that
  // times 1 + radius_variation.
  forge("four points on a circle that is large, but not where radii vary", "3.configuration",
        graded_document_with_rectangle(20, 10), [](Json&) {});
  return result;
}

}  // namespace delcert::checker_tests
