// Every strict rule at exact equality, and every other just beyond it: on configurations of which all margins are known
// exactly. What the rule asks for is compared with what a sentence of a page says.

#include <gtest/gtest.h>

#include <functional>

#include "tests/checker/support/certificate_text.hpp"
#include "tests/checker/support/run_checker.hpp"
#include "tests/checker/support/words.hpp"

namespace delcert::checker_tests {
namespace {

using Change = std::function<void(Json&)>;

Change state(const std::string& level, const std::string& key, const std::string& value) {
  return [=](Json& d) { d["levels"][level][key] = value; };
}
Change parameter(const std::string& key, const std::string& value) {
  return [=](Json& d) { d["parameters"][key] = value; };
}
Change manifold(const std::string& key, const std::string& value) {
  return [=](Json& d) { d["manifold"][key] = value; };
}
Change only(const std::set<std::string>& levels) {
  return [=](Json& d) {
    for (const char* level : {"0", "1", "2", "2s", "3", "4", "5", "6"}) {
      if (!levels.contains(level)) d["levels"].erase(level);
    }
    if (!levels.contains("0")) d["net_simplices"] = Json::array();
  };
}

Json parameters(const std::string& sampling_radius, const std::string& separation) {
  return Json{{"mode", "none"},
              {"candidates", "pruned"},
              {"seed", "7"},
              {"sampling_radius", sampling_radius},
              {"separation", separation},
              {"radius_variation", "0"},
              {"distortion", "0"},
              {"perturbation", "0"},
              {"flake_parameter_squared", "0x1p-120"},
              {"tolerance", "0x1p-40"}};
}

/// 32 points with distances 1 on a circle of length 32.
Json circle_of_units() {
  Model model;
  model.m = 1;
  for (int i = 0; i < 32; ++i) {
    model.net.push_back({Fraction{i, 32} + Fraction{}});
    model.net_simplices.push_back({i, (i + 1) % 32});
  }
  model.points = model.net;
  model.interior.assign(32, true);
  model.stars = stars_of(model.net_simplices, model.interior);
  model.gram = {{1024}};
  model.epsilon = {1, 1};
  model.mu = {1, 1};
  Json document = certificate(model, {{"0", "1", "2", "2s", "3", "4", "5", "6"}, {}, false});
  document["parameters"] = parameters("1", "1");
  document["levels"]["1"] = Json{{"protection", "1/2"}, {"thickness", "1/2"}, {"circumradius", "1"}};
  return document;
}

/// Rows of 16 points, an even number, each second one shifted by half a step.
Model rows(int number) {
  Model model;
  model.m = 2;
  const auto label = [=](int row, int column) { return 16 * (row % number) + (column + 16) % 16; };
  for (int row = 0; row < number; ++row) {
    const int odd = row % 2;
    for (int column = 0; column < 16; ++column) {
      model.net.push_back({Fraction{2 * column + odd, 32} + Fraction{}, Fraction{row, number} + Fraction{}});
      // Above the step from this point to the next, and below the step of the row above.
      model.net_simplices.push_back({label(row, column), label(row, column + 1), label(row + 1, column + odd)});
      model.net_simplices.push_back(
          {label(row, column), label(row + 1, column + odd), label(row + 1, column + odd - 1)});
    }
  }
  model.points = model.net;
  model.interior.assign(model.net.size(), true);
  model.stars = stars_of(model.net_simplices, model.interior);
  model.gram = {{1, 0}, {0, 1}};
  model.epsilon = model.mu = {1, 1};
  return model;
}

Json zeros(const Json& net) {
  Json result = Json::array();
  for (std::size_t i = 0; i < net.size(); ++i) result.push_back({"0", "0"});
  return result;
}

/// Steps of length sqrt(6/7) in rows at distance 1: all circumradii are 17/28, and the next points are 31/28 from the
/// centres. The flat torus, and the same as a space form.
Json triangles() {
  Json document = certificate(rows(16), {{"1", "2", "4", "5", "6"}, {}, false});
  document["manifold"]["gram"] = Json::parse(R"([["1536/7","0"],["0","256"]])");
  document["parameters"] = parameters("617/1000", "1");
  document["levels"]["1"] = Json{{"protection", "1/4"}, {"thickness", "1/4"}, {"circumradius", "1"}};
  return document;
}

/// A square grid with steps of length 1 and this product of the steps in both directions, halved into triangles by the
/// diagonals that are the shorter ones if it is positive.
void set_product_of_steps(Json& document, const std::string& product) {
  document["manifold"]["gram"] = Json::array({Json::array({"256", product}), Json::array({product, "256"})});
}

Json grid() {
  Model model = rows(16);
  model.net_simplices.clear();
  for (int label = 0; label < 256; ++label) {
    const int row = label / 16, column = label % 16;
    const int next = 16 * row + (column + 1) % 16, above = (label + 16) % 256, across = (next + 16) % 256;
    model.net[static_cast<std::size_t>(label)][0] = Fraction{column, 16} + Fraction{};
    model.net_simplices.push_back({label, next, above});
    model.net_simplices.push_back({next, above, across});
  }
  model.points = model.net;
  model.stars = stars_of(model.net_simplices, model.interior);
  Json document = certificate(model, {{"1", "2", "4", "5", "6"}, {}, false});
  document["parameters"] = parameters("617/1000", "1");
  document["levels"]["1"] = Json{{"protection", "0x1p-30"}, {"thickness", "1/8"}, {"circumradius", "1"}};
  return document;
}

Json space_form(const Model& model, const std::string& gram_x, const std::string& gram_y,
                const std::string& injectivity_radius) {
  Json document = certificate(model, {{"1", "2"}, {}, false});
  const auto element = [](const std::string& x) { return Json::array({x}); };
  document["manifold"] = Json{{"name", "a test"},
                              {"family", "flat"},
                              {"dimension", 2},
                              {"field", {"0", "1"}},
                              {"root", {"-1", "1"}},
                              {"time", element("0")},
                              {"gram", {{element(gram_x), element("0")}, {element("0"), element(gram_y)}}},
                              {"generators", Json::array()},
                              {"injectivity_radius", injectivity_radius}};
  const Json counted = document["levels"]["2"];
  document["levels"] = Json::object();
  document["levels"]["0"] = Json{{"density", "2"}, {"distortion", "0"}, {"metric_distortion", "0"}};
  document["levels"]["1"] = Json{{"protection", "1/4"}, {"thickness", "1/4"}, {"circumradius", "1"}};
  document["levels"]["2"] = counted;
  document["levels"]["2s"] = Json{{"reach", "4"}};
  document["levels"]["4"] = Json{{"protection", "1/4"}, {"circumradius", "1"}};
  document["levels"]["5"] = Json{{"route", "space-form"}};
  document["levels"]["6"] = Json{{"self_delaunay", true}, {"weight", "1/100"}, {"bilipschitz", {"1", "1"}}};
  document["points"] = zeros(document["net"]);
  document["parameters"] = parameters("61/100", "1");
  write_elements_as_words(document);
  return document;
}

Json triangles_of_space_form() { return space_form(rows(16), "1536/7", "256", "37/5"); }

/// 18 rows of 16 points in a square of side 128, with steps of length 8; the first point of the second row is moved up,
/// so that one triangle has the circumradius 5, with a centre at (4, 3), and all others a smaller one. The coordinates
/// of that triangle are dyadic, and so is all that is computed of it: the tie is decided.
Json special_triangle() {
  Model model = rows(18);
  model.net[16][1] = model.points[16][1] = {1, 16};
  Json document = space_form(model, "16384", "16384", "64");
  document["parameters"] = parameters("16/3", "1");
  document["levels"]["0"]["density"] = "5";
  document["levels"]["1"] = Json{{"protection", "1"}, {"thickness", "1/4"}, {"circumradius", "6"}};
  document["levels"]["2s"]["reach"] = "40";
  document["levels"]["4"] = Json{{"protection", "1"}, {"circumradius", "5"}};
  return document;
}

/// 16 rows with steps of length 8 at distance 8: all triangles have angles with the cotangents 1/2, 1/2 and 3/4, so
/// that the sums at edges are 1 and 3/2.
Json equal_triangles() {
  Json document = space_form(rows(16), "16384", "16384", "64");
  document["parameters"] = parameters("16/3", "1");
  document["levels"]["0"]["density"] = "6";
  document["levels"]["1"] = Json{{"protection", "1"}, {"thickness", "1/4"}, {"circumradius", "6"}};
  document["levels"]["2s"]["reach"] = "40";
  document["levels"]["4"] = Json{{"protection", "1"}, {"circumradius", "6"}};
  return document;
}

/// 16 rows as a constant metric field, 64 in all directions, in charts that stretch by 72.
Json field_of_triangles() {
  Json document = certificate(rows(16), {{"1", "2"}, {}, false});
  document["manifold"] = Json{{"name", "a test"},       {"family", "metric-field"},
                              {"dimension", 2},         {"constant", Json::parse(R"([["4096","0"],["0","4096"]])")},
                              {"waves", Json::array()}, {"rounding", "1/2"},
                              {"patch_radius", "20"},   {"metric_distortion", "1/8"}};
  document["parameters"] = parameters("3", "1");
  document["levels"]["1"] = Json{{"protection", "2"}, {"thickness", "1/4"}, {"circumradius", "45/16"}};
  const Json counted = document["levels"]["2"];
  document["levels"]["2s"] = Json{{"reach", "15"}};
  document["levels"]["5"] = Json{{"route", "affine-charts"}};
  document["points"] = zeros(document["net"]);
  document["loops"] = Json::array();
  Json charts = Json::array();
  for (int i = 0; i < 256; ++i) charts.push_back({"72", "0", "72"});
  Json result = Json::object();
  for (const auto& [key, value] : document.items()) {
    if (key == "net_simplices") result["charts"] = charts;
    result[key] = key == "net_simplices" ? Json::array() : value;
  }
  return result;
}

struct Boundary {
  std::string rule;
  Json document;
  Change good;  // by exactly as much as the rule permits, or a little within what a strict one permits
  Change bad;   // at equality, if the rule is strict; a little beyond it, if not
  bool is_strict;
};

std::vector<Boundary> boundaries() {
  std::vector<Boundary> all;
  const Json circle = circle_of_units();
  const auto on_circle = [&](const std::string& rule, bool strict, const Change& good, const Change& bad,
                             const std::set<std::string>& levels = {"0", "1", "2", "2s", "3", "4", "5", "6"}) {
    Json document = circle;
    only(levels)(document);
    all.push_back({rule, document, good, bad, strict});
  };
  const std::string less_one = "0x0.ffffffffp0", more_one = "0x1.00000001p0";
  on_circle("1.protection", true, state("1", "protection", less_one), state("1", "protection", "1"));
  on_circle("1.thickness", false, state("1", "thickness", "1"), state("1", "thickness", more_one));
  on_circle("0.separation", false, parameter("separation", "1"),
            [](Json& d) { d["parameters"]["sampling_radius"] = "0x1.00000001p0"; }, {"0"});
  on_circle("0.ball", true, parameter("sampling_radius", "0x0.80000001p0"), parameter("sampling_radius", "1/2"), {"0"});
  const auto coarse = [](const std::string& epsilon) {
    return [=](Json& d) {
      d["parameters"]["separation"] = "1/2";
      d["parameters"]["sampling_radius"] = epsilon;
    };
  };
  on_circle("0.patch", false, coarse("4/3"), coarse("0x1.5555555556p0"), {"0"});
  const auto balls = [](const std::string& epsilon, const std::string& radius, const std::string& protection) {
    return [=](Json& d) {
      d["parameters"]["sampling_radius"] = epsilon;
      d["levels"]["1"]["circumradius"] = radius;
      d["levels"]["1"]["protection"] = protection;
    };
  };
  // Chart: 2r + delta <= 8 epsilon. Lattice: 4r + 2 delta < 32.
  on_circle("1.patch", false, balls("1", "15/4", "1/2"), balls("1", "15/4", "0x0.80000001p0"), {"1", "2"});
  on_circle("1.patch", true, balls("4", "31/4", "0x0.7fffffffp0"), balls("4", "31/4", "1/2"), {"1", "2"});
  on_circle("2s.patch", true, balls("1", "0x2.3fffffffp0", "1/2"), balls("1", "9/4", "1/2"));
  // Gamma_0 = 2 mu^2 / 75, so that delta_0 = 4/5625 and P3 is at equality where the ends of three
  // points are 2 apart: 5/2 (1 + 2/5625) 4500/5627 = 2.
  const auto flakes = [](const std::string& squared, const std::string& epsilon) {
    return [=](Json& d) {
      d["parameters"]["flake_parameter_squared"] = squared;
      d["parameters"]["sampling_radius"] = epsilon;
    };
  };
  on_circle("3.flake-parameter", false, flakes("4/5625", "3/4"), flakes("401/562500", "3/4"), {"0", "3"});
  on_circle("3.configuration", true, flakes("4/5625", "4500/5627"), flakes("4/5625", "4501/5627"), {"0", "3"});
  all.back().is_strict = false;  // a configuration at equality is not forbidden

  const Json torus = triangles();
  const auto on_torus = [&](const std::string& rule, bool strict, const Change& good, const Change& bad) {
    all.push_back({rule, torus, good, bad, strict});
  };
  on_torus("1.protection", true, state("1", "protection", "0x0.7fffffffp0"), state("1", "protection", "1/2"));
  on_torus("1.radius", false, state("1", "circumradius", "17/28"), state("1", "circumradius", "1699999/2800000"));
  // Four points on a circle.
  const auto steps = [](const std::string& product) { return [=](Json& d) { set_product_of_steps(d, product); }; };
  for (const char* rule : {"1.protection", "core.hinges"})
    all.push_back({rule, grid(), steps("0x1p-20"), steps("0"), true});

  const Json form = triangles_of_space_form();
  const auto on_form = [&](const std::string& rule, bool strict, const Change& good, const Change& bad,
                           const std::set<std::string>& levels = {"1", "2", "4", "5", "6"}) {
    Json document = form;
    only(levels)(document);
    all.push_back({rule, document, good, bad, strict});
  };
  on_form("1.protection", true, state("1", "protection", "0x0.7fffffffp0"), state("1", "protection", "1/2"));
  on_form("4.empty", true, state("4", "protection", "0x0.7fffffffp0"), state("4", "protection", "1/2"));

  const Json special = special_triangle(), equal = equal_triangles();
  const auto on_special = [&](const std::string& rule, bool strict, const Change& good, const Change& bad,
                              const std::set<std::string>& levels = {"0", "1", "2", "2s", "4", "5", "6"}) {
    Json document = special;
    only(levels)(document);
    all.push_back({rule, document, good, bad, strict});
  };
  on_special("0.density", false, state("0", "density", "5"), state("0", "density", "0x4.ffffffffp0"));
  on_special("4.ball", false, state("4", "circumradius", "5"), state("4", "circumradius", "0x4.ffffffffp0"));
  on_special("0.patch", false, parameter("sampling_radius", "16/3"), parameter("sampling_radius", "0x5.5555555556p0"));
  on_special("group.injectivity", false, manifold("injectivity_radius", "64"),
             manifold("injectivity_radius", "0x40.00000001p0"));
  on_special("1.patch", true, state("1", "circumradius", "0x17.7fffffffp0"), state("1", "circumradius", "47/2"));
  on_special("2s.patch", true, state("2s", "reach", "0x2f.ffffffffp0"), state("2s", "reach", "48"));
  on_special(
      "6.bilipschitz", false, [](Json&) {}, [](Json& d) { d["levels"]["6"]["bilipschitz"][0] = "0x1.00000001p0"; });
  all.push_back({"6.self-delaunay", equal, state("6", "weight", "0x0.ffffffffp0"), state("6", "weight", "1"), true});

  const Json field = field_of_triangles();
  const auto on_field = [&](const std::string& rule, bool strict, const Change& good, const Change& bad,
                            const std::set<std::string>& levels = {"1", "2", "2s", "5"}) {
    Json document = field;
    only(levels)(document);
    all.push_back({rule, document, good, bad, strict});
  };
  on_field("field.chart", true, manifold("rounding", "0x1.10000001p-2"), manifold("rounding", "17/64"));
  on_field("field.metric", true, manifold("metric_distortion", "11112/100000"), manifold("metric_distortion", "1/9"));
  on_field("field.patch", true, manifold("patch_radius", "0x17.ffffffffp0"), manifold("patch_radius", "24"));
  on_field("1.patch", true, manifold("patch_radius", "0x7.a0000001p0"), manifold("patch_radius", "61/8"),
           {"1", "2", "5"});
  on_field("2s.patch", true, state("2s", "reach", "0x13.ffffffffp0"), state("2s", "reach", "20"));
  return all;
}

TEST(Equality, is_rejected_by_strict_rules_and_accepted_by_the_others) {
  for (const Boundary& boundary : boundaries()) {
    SCOPED_TRACE(boundary.rule + (boundary.is_strict ? ", strict, on " : ", on ") +
                 boundary.document["manifold"]["family"].get<std::string>());
    Json document = boundary.document;
    boundary.good(document);
    const CheckerRun good = run_checker(sealed(document));
    EXPECT_EQ(good.status, 0) << good.output;
    document = boundary.document;
    boundary.bad(document);
    const CheckerRun bad = run_checker(sealed(document));
    // A tie may be left open by enclosures, and values of a metric at equality by boxes.
    if (bad.status == 2) {
      EXPECT_TRUE(boundary.is_strict && boundary.document["manifold"]["family"] != "flat-torus") << bad.output;
    } else {
      EXPECT_EQ(bad.status, 1) << bad.output;
      EXPECT_TRUE(bad.rules.contains(boundary.rule)) << bad.output;
    }
  }
}

/// The centre (4, 3) of the special triangle is at the distance 5 from the nearest points, and 5 is the density: the
/// sentence has to be "at most", in the report as on the page.
TEST(Equality, of_density_and_circumradius_is_at_most_and_not_less) {
  const CheckerRun run = run_checker_with(temporary_file(sealed(special_triangle())));
  EXPECT_EQ(run.status, 0) << run.output;
  EXPECT_NE(run.output.find("density <= 5, below the sampling radius"), std::string::npos) << run.output;
}

/// A sampling radius that the density does not reach is claimed by nothing.
TEST(Equality, of_density_and_sampling_radius_shows_no_sampling_radius) {
  for (const std::string radius : {"5", "4", "2"}) {
    Json document = special_triangle();
    only({"0", "1", "2", "4"})(document);
    document["parameters"]["sampling_radius"] = radius;
    const CheckerRun run = run_checker_with(temporary_file(sealed(document)));
    EXPECT_EQ(run.status, 0) << run.output;
    EXPECT_NE(run.output.find("density <= 5, not below the sampling radius"), std::string::npos) << run.output;
  }
}

}  // namespace
}  // namespace delcert::checker_tests
