#include <gtest/gtest.h>

#include "tests/checker/support/run_checker.hpp"
#include "tests/checker/support/space_form_samples.hpp"

namespace delcert::checker_tests {
namespace {

void expect_accepted(const SpaceFormSample& sample) {
  const CheckerRun run = run_checker(sealed(sample.document()));
  EXPECT_EQ(run.status, 0) << run.output;
  std::printf("%zu points: %s", sample.model.size(), run.output.c_str());
}

TEST(SpaceForm, an_icosphere_is_accepted) { expect_accepted(icosphere()); }
TEST(SpaceForm, a_projective_plane_is_accepted) { expect_accepted(projective_plane()); }
TEST(SpaceForm, the_600_cell_is_accepted) { expect_accepted(cell_600()); }
TEST(SpaceForm, half_of_the_600_cell_is_accepted) { expect_accepted(projective_space()); }
TEST(SpaceForm, a_klein_bottle_is_accepted) { expect_accepted(klein_bottle()); }
TEST(SpaceForm, a_bolza_surface_is_accepted) { expect_accepted(bolza_surface()); }

void expect_malformed(const std::string& name, const std::string& rule, const SpaceFormSample& sample,
                      const std::function<void(Json&)>& change) {
  SCOPED_TRACE(name);
  Json document = sample.document();
  change(document);
  const CheckerRun run = run_checker(sealed(document));
  EXPECT_EQ(run.status, 3) << run.output;
  EXPECT_EQ(run.rules, std::set<std::string>{rule}) << run.output;
}

std::function<void(Json&)> with(const std::string& key, const std::string& value) {
  return [=](Json& j) { j["manifold"][key] = Json::parse(value); };
}

TEST(SpaceForm, fields_are_given_by_irreducible_polynomials_and_one_root) {
  const SpaceFormSample& bolza = bolza_surface();
  expect_malformed("reducible", "form.field", bolza, with("field", R"(["-4","0","1"])"));
  expect_malformed("a power", "form.field", bolza, with("field", R"(["4","0","-4","0","1"])"));
  expect_malformed("constant", "form.field", bolza, with("field", R"(["1"])"));
  expect_malformed("empty", "form.field", bolza, with("field", "[]"));
  expect_malformed("zero", "form.field", bolza, with("field", R"(["0","0"])"));
  expect_malformed("no root", "form.field", bolza, with("root", R"(["2","3"])"));
  expect_malformed("two roots", "form.field", bolza, with("root", R"(["-2","2"])"));
  expect_malformed("perhaps three roots", "form.field", bolza, with("root", R"(["-1","2"])"));
  expect_malformed("ends exchanged", "form.field", bolza, with("root", R"(["2","1"])"));
  expect_malformed("one end", "form.keys", bolza, with("root", R"(["2"])"));
  expect_malformed("too many coefficients", "form.types", bolza, with("time", R"(["-56","-40","0"])"));
  expect_malformed("no coefficient", "form.types", bolza, with("time", "[]"));
  expect_malformed("a number for an element", "form.keys", bolza, with("time", "\"-56\""));
}

TEST(SpaceForm, the_manifold_block_has_its_form) {
  const SpaceFormSample& plane = projective_plane();
  expect_malformed("dimension 4", "form.types", plane, with("dimension", "4"));
  expect_malformed("another dimension", "form.keys", plane, with("dimension", "3"));
  expect_malformed("gram not symmetric", "form.gram", plane, with("gram", R"([[["1"],["1/2"]],[["0"],["1"]]])"));
  expect_malformed("gram not positive", "form.gram", plane, with("gram", R"([[["1"],["2"]],[["2"],["1"]]])"));
  expect_malformed("hyperbolic time", "form.ranges", plane, with("time", R"(["-1"])"));
  expect_malformed("a negative injectivity radius", "form.ranges", plane, with("injectivity_radius", "\"-1\""));
  expect_malformed("a generator of another order", "form.keys", plane, with("generators", R"([[[["1"]]]])"));
  expect_malformed("another key", "form.keys", plane, [](Json& j) { j["manifold"]["order"] = 2; });
  expect_malformed("a torus", "form.keys", plane, with("family", "\"flat-torus\""));
}

TEST(SpaceForm, levels_have_their_form) {
  const SpaceFormSample& sphere = icosphere();
  const auto level = [](const std::string& name, const std::string& value) {
    return [=](Json& j) { j["levels"][name] = Json::parse(value); };
  };
  expect_malformed("hypotheses", "form.keys", sphere, level("0", R"({"hypotheses_2":false})"));
  expect_malformed("no reach", "form.keys", sphere, level("2s", "{}"));
  expect_malformed("no margins", "form.keys", sphere, level("4", "{}"));
  expect_malformed("half a route", "form.keys", sphere, level("5", R"({"route":"space-form","thickness":"1"})"));
  expect_malformed("no weight", "form.keys", sphere, level("6", R"({"self_delaunay":true,"bilipschitz":["1","1"]})"));
  expect_malformed("negative density", "form.ranges", sphere,
                   level("0", R"({"density":"-1","distortion":"1","metric_distortion":"1"})"));
  expect_malformed("negative distortion", "form.ranges", sphere,
                   level("0", R"({"density":"1","distortion":"-1","metric_distortion":"1"})"));
  expect_malformed("no distortion", "form.keys", sphere, level("0", R"({"density":"1"})"));
  expect_malformed("negative protection", "form.ranges", sphere,
                   level("4", R"({"protection":"-1","circumradius":"1"})"));
  expect_malformed("half a sphere", "form.ranges", sphere, level("2s", R"({"reach":"8/5"})"));
  expect_malformed("self-Delaunay in dimension 3", "form.family", cell_600(),
                   level("6", R"({"self_delaunay":true,"weight":"0","bilipschitz":["1","1"]})"));
  expect_malformed("level 3", "form.family", sphere, [](Json& j) {
    Json levels = Json::object();
    for (const auto& [name, value] : j["levels"].items()) {
      if (name == "4") levels["3"] = Json{{"tested", ""}};
      levels[name] = value;
    }
    j["levels"] = levels;
  });
  expect_malformed("level 0 without level 4", "form.levels", sphere.claiming({"0", "1", "2"}), [](Json&) {});
  expect_malformed("no net", "form.lengths", sphere, [](Json& j) { j["net"] = Json::array(); });
}

/// Infinitely many rotations: one of the first has a fixed point. Of a lens space there are too many.
TEST(SpaceForm, groups_that_are_infinite_or_very_large_are_never_verified) {
  Json document = icosphere().document();
  document["manifold"]["generators"] =
      Json::parse(R"([[[["3/5"],["-4/5"],["0"]],[["4/5"],["3/5"],["0"]],[["0"],["0"],["1"]]]])");
  document["loops"].push_back(Json::array());
  EXPECT_EQ(run_checker(sealed(document)).rules, (std::set<std::string>{"core.group", "group.injectivity"}));
}

TEST(SpaceForm, huge_and_tiny_numbers_never_verify) {
  for (const char* number : {"0x1p99999", "-0x1p99999", "123456789012345678901234567890"}) {
    for (const SpaceFormSample* sample : {&icosphere(), &bolza_surface(), &klein_bottle()}) {
      Json document = sample->document();
      document["net"][5][0] = number;
      EXPECT_GT(run_checker(sealed(document)).status, 0) << number;
      document = sample->document();
      document["points"][5][0] = number;
      EXPECT_GT(run_checker(sealed(document)).status, 0) << number;
    }
  }
}

}  // namespace
}  // namespace delcert::checker_tests
