#include "tests/checker/support/forgeries.hpp"
#include "tests/checker/support/samples.hpp"

namespace delcert::checker_tests {

std::vector<std::pair<std::string, std::string>> valid_certificates() {
  std::vector<std::pair<std::string, std::string>> result;
  for (const auto& [name, sample] : {std::pair("wide torus", wide_torus()),
                                     {"narrow torus", narrow_torus()},
                                     {"skewed torus", skewed_torus()},
                                     {"circle", circle()},
                                     {"cubic torus", cubic_torus()},
                                     {"disc", disc()},
                                     {"four-torus", four_torus()}}) {
    result.emplace_back(name, sealed(sample.document()));
  }
  using Groups = std::vector<std::string>;
  for (const auto& [name, sample, groups] :
       {std::tuple("circle with homology", circle(), Groups{"Z", "Z"}),
        {"torus with homology", wide_torus(), {"Z", "Z^2", "Z"}},
        {"cubic torus with homology", cubic_torus(), {"Z", "Z^3", "Z^3", "Z"}},
        {"four-torus with homology", four_torus(), {"Z", "Z^4", "Z^6", "Z^4", "Z"}},
        {"disc with homology", disc(), {"Z", "0", "0"}}}) {
    Json document = sample.document();
    document["levels"]["2"]["homology"] = groups;
    result.emplace_back(name, sealed(document));
  }
  return result;
}

std::vector<Forgery> form_forgeries() {
  std::vector<Forgery> result;
  const auto forge = [&](const std::string& name, const std::string& rule, Json document, auto change) {
    change(document);
    result.push_back({name, rule, sealed(document), 3});
  };
  const Json torus = wide_torus().document(), ball = disc().document(), input = wide_torus().claiming({"0"}).document();

  std::string other = sealed(torus);
  other[other.rfind('"') - 1] = other[other.rfind('"') - 1] == '0' ? '1' : '0';
  result.push_back({"one digit of the seal is another", "seal", other, 3});
  std::string changed = sealed(torus);
  changed.replace(changed.find("a test"), 6, "A test");
  result.push_back({"the name is changed after sealing", "seal", changed, 3});

  forge("gram is not symmetric", "form.gram", torus, [](Json& d) { d["manifold"]["gram"][1][0] = "-1023/1024"; });
  forge("radius_variation is not 0", "form.ranges", torus,
        [](Json& d) { d["parameters"]["radius_variation"] = "1/3"; });
  forge("distortion is not 0", "form.ranges", torus, [](Json& d) { d["parameters"]["distortion"] = "0x1p-99999"; });
  forge("tolerance is negative", "form.ranges", torus, [](Json& d) { d["parameters"]["tolerance"] = "-1"; });
  forge("perturbation is just above separation/4", "form.ranges", torus, [](Json& d) {
    d["parameters"]["perturbation"] = (wide_torus().model.rho + Fraction{1, 1ll << 40}).text();
  });
  forge("protection is 0", "form.ranges", torus, [](Json& d) { d["levels"]["1"]["protection"] = "0"; });
  forge("thickness is 0", "form.ranges", torus, [](Json& d) { d["levels"]["1"]["thickness"] = "0x0"; });
  forge("a perturbation in the mode none", "form.mode", wide_torus().claiming({"1", "2", "4"}).document(), [](Json& d) {
    d["parameters"]["mode"] = "none";
    d["points"] = d["net"];
  });
  forge("points moved in the mode none", "form.mode", wide_torus().claiming({"1", "2", "4"}).document(), [](Json& d) {
    d["parameters"]["mode"] = "none";
    d["parameters"]["perturbation"] = "0";
  });
  forge("separation is 0", "form.ranges", input, [](Json& d) { d["parameters"]["separation"] = "0"; });
  forge("level 6 without level 5", "form.levels", torus, [](Json& d) { d["levels"].erase("5"); });
  forge("level 6 of a flat torus without level 4", "form.levels", torus, [](Json& d) { d["levels"].erase("4"); });
  forge("level 1 without level 2", "form.levels", wide_torus().claiming({"1"}).document(), [](Json&) {});
  forge("level 2s without level 0", "form.levels", wide_torus().claiming({"1", "2", "2s"}).document(), [](Json&) {});
  forge("no level is claimed", "form.levels", wide_torus().claiming({}).document(), [](Json&) {});
  forge("level 5 of a ball", "form.family", ball, [](Json& d) { d["levels"]["5"]["route"] = "space-form"; });
  forge("net simplices although level 0 is not claimed", "form.net-simplices",
        wide_torus().claiming({"1", "2"}).document(), [&](Json& d) { d["net_simplices"] = torus["net_simplices"]; });

  forge("a simplex without interior label", "form.interior", disc().claiming({"0"}).document(), [](Json& d) {
    const auto far = [](const Json& row) {
      return std::none_of(row.begin(), row.end(),
                          [](const Json& j) { return disc().model.interior[j.get<std::size_t>()]; });
    };
    Json rows = d["simplices"];
    for (Labels labels : disc().model.net_simplices) {
      std::sort(labels.begin(), labels.end());
      if (!far(labels)) continue;
      labels.insert(labels.end(), {0, 0});
      rows.push_back(labels);
      break;
    }
    std::sort(rows.begin(), rows.end());
    d["simplices"] = rows;
  });
  forge("labels in no simplex", "form.interior", input, [](Json& d) {
    d["simplices"] = Json::array();
    d["loops"] = Json::parse("[[],[]]");
  });
  Sample empty = disc().claiming({"1", "2"});
  empty.model.radius = {79 * empty.model.epsilon.numerator, 10 * empty.model.epsilon.denominator};
  for (auto& star : empty.model.stars) star.clear();
  forge("stars of no label at all", "form.interior", empty.document(), [](Json&) {});
  // By form no two stars can disagree on a simplex. What is left of it: a simplex twice, seen at other lifts.
  forge("labels of a simplex out of order", "form.simplex-labels", input,
        [](Json& d) { std::swap(d["simplices"].back()[1], d["simplices"].back()[2]); });
  forge("a simplex with a label twice", "form.simplex-labels", input,
        [](Json& d) { d["simplices"].back()[1] = d["simplices"].back()[2]; });
  forge("simplices out of order", "form.simplex-order", input,
        [](Json& d) { std::swap(d["simplices"][600], d["simplices"][601]); });
  forge("a simplex twice", "form.simplex-order", input, [](Json& d) { d["simplices"][601] = d["simplices"][600]; });
  forge("a simplex twice, at other lifts", "form.simplex-order", input, [](Json& d) {
    d["simplices"][601] = d["simplices"][600];
    d["simplices"][601][4] = 1;
  });
  return result;
}

}  // namespace delcert::checker_tests
