// Certificates of zero sets, made without the program: they are verified; and forgeries of them.

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>

#include "tests/checker/support/forgeries.hpp"
#include "tests/checker/support/run_checker.hpp"
#include "tests/checker/support/submanifold_model.hpp"
#include "tests/support/temporary_folder.hpp"

namespace delcert::checker_tests {
namespace {

const std::vector<std::string> all = {"1", "2", "2s", "4", "5", "5i", "6"}, of_given = {"1f", "2", "5", "5i", "6"};

const Json& circle_document() {
  static const Json document = certificate(circle_model(40, 1), all);
  return document;
}

const Json& sphere_document() {
  static const Json document = certificate(sphere_model(3), all);
  return document;
}

SubmanifoldModel given(SubmanifoldModel model) {
  model.given = true;
  return model;
}

const Json& polygon_document() {
  static const Json document = certificate(given(circle_model(60, 1)), of_given);
  return document;
}

/// As the numbers of charts are written.
std::string text_of(double x) { return std::to_string(static_cast<long long>(x * 0x1p30)) + "/1073741824"; }

void expect_verified(const Json& document) {
  const CheckerRun run = run_checker(sealed(document));
  EXPECT_EQ(run.status, 0) << run.output;
}

TEST(Submanifold, circles_spheres_and_tori_are_verified) {
  expect_verified(circle_document());
  expect_verified(sphere_document());
  expect_verified(polygon_document());
  expect_verified(certificate(flat_torus_model(40), {"1", "2", "5"}));
  expect_verified(certificate(given(sphere_model(3)), of_given));
  expect_verified(certificate(torus_model(90, 50, 1), all));
}

SubmanifoldModel by(const std::string& metric, SubmanifoldModel model) {
  model.metric = metric;
  return model;
}

/// Two circles so near to each other that points of one may be nearer to vertices of the other.
SubmanifoldModel near_circles(const std::string& metric, double gap) {
  SubmanifoldModel model = by(metric, nested_circles_model(400, gap));
  model.slope *= 1.25;
  model.height *= 1.25;
  model.displacement *= 4;
  model.is_low = true;
  return model;
}

/// Twelve points on a circle; what may be within density of one of them reaches to the other side.
SubmanifoldModel twelve_points() {
  SubmanifoldModel model = circle_model(12, 1);
  model.slope = 1.732;
  model.patch_radius = 0.6443;
  model.height = 0.6562;
  return model;
}

TEST(Submanifold, the_complex_is_the_Delaunay_complex_by_distances_in_space_and_in_the_manifold) {
  for (const char* metric : {"extrinsic", "intrinsic", "both"}) {
    expect_verified(certificate(by(metric, circle_model(40, 1)), all));
    expect_verified(certificate(by(metric, sphere_model(3)), all));
    expect_verified(certificate(by(metric, flat_torus_model(60)), {"1", "2", "4", "5", "6"}));
    expect_verified(certificate(by(metric, doubled(circle_model(60, 1))), all));
  }
  expect_verified(certificate(near_circles("intrinsic", 0.0065), {"1", "2", "4", "5"}));
}

TEST(Submanifold, a_place_as_near_to_one_label_as_to_others_ends_undecided_at_a_box) {
  const auto run_with = [](double gap) {
    return run_checker(sealed(certificate(near_circles("extrinsic", gap), {"1", "2", "4", "5"})), "4.patch");
  };
  const double half_edge = 0.00785396;  // from the middle of an arc to its ends
  EXPECT_EQ(run_with(half_edge + 0x1p-12).status, 0);
  EXPECT_EQ(run_with(0.0065).rules, std::set<std::string>{"4.cover"});
  const CheckerRun run = run_with(half_edge + 0x1p-21);
  EXPECT_EQ(run.status, 2) << run.output;
  EXPECT_NE(run.output.find("which labels are nearest in the chart of label"), std::string::npos) << run.output;
}

TEST(Submanifold, in_higher_codimension_are_verified) {
  for (const std::size_t dimension : {5U, 6U})
    expect_verified(certificate(given(lifted(flat_torus_model(40), dimension)), {"1f", "2", "5"}));
}

TEST(Submanifold, is_the_one_that_is_expected_whatever_its_charts_are) {
  const test::TemporaryFolder folder;
  const auto check = [&](const Json& document, const Json& expected) {
    const auto write = [&](const char* name, const Json& j) {
      std::ofstream(folder / name) << sealed(j);
      return (folder / name).string();
    };
    const std::string files = write("document", document) + " --expect-manifold " + write("expected", expected);
    return run_checker_with(files).status;
  };
  EXPECT_NE(circle_document()["manifold"]["slope"], polygon_document()["manifold"]["slope"]);
  EXPECT_EQ(check(circle_document(), polygon_document()), 0);
  EXPECT_EQ(check(circle_document(), sphere_document()), 1);
  Json other = polygon_document();
  other["manifold"]["box"][0][1] = "3";
  EXPECT_EQ(check(circle_document(), other), 1);
}

TEST(Submanifold, where_the_equations_may_not_be_defined_nothing_is_decided) {
  for (const char* term : {"+0*(1/x)", "+0*sqrt(x^2)", "+0*sqrt(0-1)", "+0/0", "+(1/x)^0-1"}) {
    Json document = circle_document();
    document["manifold"]["equations"][0] = "x^2+y^2-1" + std::string(term);
    const CheckerRun run = run_checker(sealed(document));
    EXPECT_EQ(run.status, 2) << term << run.output;
  }
  Json document = circle_document();
  document["manifold"]["equations"][0] = "x^2+y^2-1+0*(1/(x+3))+(sqrt(x+3))^0-cos(0)+exp(0*x)-1+sin(y-y)";
  expect_verified(document);
}

TEST(Submanifold, a_point_at_which_equations_are_singular_ends_undecided_at_a_box) {
  SubmanifoldModel model = circle_model(60, 1);
  model.equations = {"(x^2+y^2-1)*((2*x-3)^2+4*(y-1)^2)"};
  model.map = [](const std::vector<double>& x) {
    const double a = 2 * x[0] - 3, b = 2 * x[1] - 2;
    return std::vector<double>{(x[0] * x[0] + x[1] * x[1] - 1) * (a * a + b * b)};
  };
  model.slope *= 1.25;
  model.height *= 1.25;
  const CheckerRun run = run_checker(sealed(certificate(model, {"1", "2"})));
  EXPECT_EQ(run.status, 2) << run.output;
  EXPECT_NE(run.output.find("no chart shows in the box [1.5"), std::string::npos) << run.output;
  EXPECT_LT(run.seconds, 10);
}

TEST(Submanifold, two_sheets_in_a_cylinder_are_no_graph) {
  Json document = circle_document();
  document["manifold"]["box"] = Json::parse(R"([["-8","8"],["-8","8"]])");
  expect_verified(document);
  document["charts"][7].back() = "5/2";
  const CheckerRun run = run_checker(sealed(document));
  EXPECT_EQ(run.rules, std::set<std::string>{"sub.graph"}) << run.output;
  document = circle_document();
  document["charts"][7][2] = "1/16";  // turned by more than the slope
  EXPECT_EQ(run_checker(sealed(document)).rules, std::set<std::string>{"sub.graph"});
  // A cylinder that M does not meet.
  document = circle_document();
  document["net"][7] = Json::parse(R"(["1/4","1/4"])");
  EXPECT_EQ(run_checker(sealed(document)).status, 1);
}

TEST(Submanifold, the_document_has_its_form) {
  const auto malformed = [](const std::string& rule, const std::function<void(Json&)>& change) {
    Json document = circle_document();
    change(document);
    const CheckerRun run = run_checker(sealed(document));
    EXPECT_EQ(run.status, 3) << run.output;
    EXPECT_EQ(run.rules, std::set<std::string>{rule}) << run.output;
  };
  const std::string many(300, '-'), deep = std::string(250, '(') + "x" + std::string(250, ')'), long_number(1001, '1');
  for (const std::string& equation : {std::string(),
                                      std::string("x y"),
                                      std::string("x+"),
                                      std::string("(x"),
                                      std::string("x)"),
                                      std::string("x^-1"),
                                      std::string("x^y"),
                                      std::string("x^2^2"),
                                      std::string("x^1001"),
                                      std::string("x^"),
                                      std::string("z"),
                                      std::string("sin"),
                                      std::string("sin x"),
                                      std::string("tan(x)"),
                                      std::string("1.5"),
                                      std::string("0x1"),
                                      std::string("x=1"),
                                      std::string("X"),
                                      std::string("2x"),
                                      std::string("*x"),
                                      std::string("x,y"),
                                      std::string("()"),
                                      many + "x",
                                      deep,
                                      long_number}) {
    malformed("form.formula", [&](Json& j) { j["manifold"]["equations"][0] = equation; });
  }
  std::string long_sum = "x";
  for (int k = 0; k < 6000; ++k) long_sum += "+" + std::to_string(k) + "*y";
  malformed("form.formula", [&](Json& j) { j["manifold"]["equations"][0] = long_sum; });
  malformed("form.formula", [](Json& j) { j["manifold"]["variables"][0] = "y"; });
  for (const char* name : {"X", "", "1x", "sin", "abcdefghijklmnopq", "x-"})
    malformed("form.formula", [&](Json& j) { j["manifold"]["variables"][0] = name; });
  malformed("form.formula", [](Json& j) { j["manifold"]["equations"].push_back("x"); });
  malformed("form.formula", [](Json& j) { j["manifold"]["variables"].push_back("z"); });
  malformed("form.formula", [](Json& j) { j["manifold"]["equations"] = Json::array(); });
  malformed("form.ranges", [](Json& j) { j["manifold"]["box"][0][1] = "-2"; });
  malformed("form.ranges", [](Json& j) { j["manifold"]["slope"] = "0"; });
  malformed("form.ranges", [](Json& j) { j["levels"]["5"]["contraction"] = "1"; });
  malformed("form.ranges", [](Json& j) { j["levels"]["5"]["displacement"] = "-1"; });
  malformed("form.ranges", [](Json& j) { j["levels"]["5i"]["margin"] = "0"; });
  malformed("form.ranges", [](Json& j) { j["levels"]["2s"]["reach"] = "0"; });
  malformed("form.ranges", [](Json& j) { j["parameters"]["distortion"] = "1"; });
  malformed("form.family", [](Json& j) { j["parameters"]["mode"] = "theory"; });
  malformed("form.keys", [](Json& j) { j["manifold"]["vertices"] = "both"; });
  malformed("form.keys", [](Json& j) { j["manifold"]["box"].erase(1); });
  malformed("form.keys", [](Json& j) { j["charts"][3].erase(2); });
  malformed("form.keys", [](Json& j) { j["net"][3].erase(1); });
  malformed("form.lengths", [](Json& j) { j["net"].erase(3); });
  malformed("form.lengths", [](Json& j) { j["charts"].erase(3); });
  malformed("form.types", [](Json& j) { j["manifold"]["dimension"] = 4; });
  malformed("form.charts", [](Json& j) { j["charts"][3][0] = "3"; });
  malformed("form.charts", [](Json& j) { j["charts"][3][0] = j["charts"][3][1]; });
  malformed("form.charts", [](Json& j) { j["charts"][3][0] = "0"; });
  malformed("form.charts", [](Json& j) { j["charts"][3].back() = "0"; });
  malformed("form.charts", [](Json& j) {
    j["parameters"]["mode"] = "measured";
    j["points"][3][0] = "1/2";
  });
  malformed("form.family", [](Json& j) {
    const Json others = j["levels"];
    j["levels"] = Json::object();
    j["levels"]["1"] = others["1"];
    j["levels"]["1f"] = Json::object();
    j["levels"]["2"] = others["2"];
  });
  malformed("form.keys", [](Json& j) { j["levels"]["6"] = Json::object(); });
  malformed("form.types", [](Json& j) { j["levels"]["4"]["metric"] = "chordal"; });
  malformed("form.ranges", [](Json& j) { j["levels"]["4"]["density"] = "0"; });
  malformed("form.ranges", [](Json& j) { j["levels"]["6"]["bilipschitz"][0] = "0"; });
  malformed("form.ranges", [](Json& j) { j["levels"]["6"]["normal"] = "1"; });
  malformed("form.ranges", [](Json& j) { j["levels"]["6"]["normal"] = "0"; });
  malformed("form.family", [](Json& j) {
    const Json value = j["levels"]["6"];
    j["levels"]["6"] = {{"self_delaunay", true}, {"weight", "0"}};
    j["levels"]["6"].update(value);
    j["levels"]["6"]["self_delaunay"] = true;
  });
  malformed("form.levels", [](Json& j) { j["levels"].erase("5"); });
  Json flat = polygon_document();
  flat["levels"] = {{"1f", flat["levels"]["1f"]},
                    {"2", flat["levels"]["2"]},
                    {"4", circle_document()["levels"]["4"]},
                    {"5", flat["levels"]["5"]}};
  EXPECT_EQ(run_checker(sealed(flat)).rules, std::set<std::string>{"form.family"});
  Json moved = polygon_document();
  moved["parameters"]["mode"] = "measured";
  moved["points"][3][0] = "1/1000";
  EXPECT_EQ(run_checker(sealed(moved)).rules, std::set<std::string>{"form.charts"});
}

TEST(Submanifold, huge_and_tiny_numbers_never_verify) {
  for (const char* number : {"0x1p99999", "-0x1p99999", "0x1p-99999", "123456789012345678901234567890"}) {
    for (const char* key : {"net", "charts"}) {
      for (const std::size_t at : {std::size_t{0}, std::size_t{1}, std::size_t{2}, std::size_t{3}}) {
        if (at > 1 && std::string(key) == "net") continue;
        if (at == 2 && std::string(number) == "0x1p-99999") continue;  // a frame that is turned by nearly nothing
        Json document = circle_document();
        document[key][5][at] = number;
        const CheckerRun run = run_checker(sealed(document));
        EXPECT_GT(run.status, 0) << key << " " << number << run.output;
        EXPECT_LT(run.seconds, 10);
      }
    }
    for (const std::string& equation : {"x^2+y^2-" + std::string(999, '9'), std::string("x^1000+y^1000-1")}) {
      Json document = circle_document();
      document["manifold"]["equations"][0] = equation;
      EXPECT_GT(run_checker(sealed(document)).status, 0);
    }
  }
}

}  // namespace

std::vector<Forgery> submanifold_forgeries() {
  const auto forged = [](const char* name, const char* rule, const Json& valid,
                         const std::function<void(Json&)>& change) {
    Json document = valid;
    change(document);
    return Forgery{name, rule, sealed(document)};
  };
  const auto claim = [](const char* level, const char* key, const char* value) {
    return [=](Json& j) { j["levels"][level][key] = value; };
  };
  const auto as_it_is = [](Json&) {};
  const auto without_a_simplex = [](Json& j) {
    j["simplices"].erase(4);
    j["levels"]["2"]["simplices"] = j["simplices"].size();
    j["levels"]["2"]["euler_characteristic"] = 1;
  };
  const SubmanifoldModel circle = circle_model(40, 1);
  SubmanifoldModel zigzag = given(circle_model(60, 1)), lined = given(circle_model(60, 1));
  for (auto& edge : zigzag.simplices) {  // 3 and 4 exchanged
    for (int& label : edge) label = label == 3 ? 4 : label == 4 ? 3 : label;
  }
  for (auto& edge : zigzag.simplices) std::sort(edge.begin(), edge.end());
  std::sort(zigzag.simplices.begin(), zigzag.simplices.end());
  lined.equations = {"(x^2+y^2-1)*(2*x-3)"};
  lined.map = [](const std::vector<double>& x) {
    return std::vector<double>{(x[0] * x[0] + x[1] * x[1] - 1) * (2 * x[0] - 3)};
  };
  lined.slope *= 1.25;
  lined.height *= 1.25;
  SubmanifoldModel wound = given(torus_model(181, 50, 2));
  wound.patch_radius = 0.375;
  wound.slope = 0.5;
  wound.height = 0.125;
  const Json& round = circle_document();
  Forgery near = forged("two circles nearer to each other than their points", "4.cover",
                        certificate(near_circles("extrinsic", 0.0065), {"1", "2", "4", "5"}), as_it_is);
  near.others = {"4.patch"};
  return {
      near,
      forged("a box whose rim cuts the circle", "sub.box", round, [](Json& j) { j["manifold"]["box"][0][1] = "1"; }),
      forged("a slope too small", "sub.graph", round,
             [&](Json& j) { j["manifold"]["slope"] = text_of(circle.slope * 0.75); }),
      forged("a lid too low", "sub.graph", round,
             [&](Json& j) { j["charts"][3].back() = text_of(circle.slope * circle.patch_radius * 0.55); }),
      forged("distortion less than slope", "sub.distortion", round,
             [&](Json& j) { j["parameters"]["distortion"] = text_of(circle.slope * circle.slope * 0.4); }),
      forged("one of two circles left out", "sub.cover",
             certificate(first_component(doubled(circle_model(60, 1))), all), as_it_is),
      forged("one of two spheres left out", "sub.cover", certificate(first_component(doubled(sphere_model(4))), all),
             as_it_is),
      forged("an equation multiplied by one with further zeros", "sub.cover", certificate(lined, {"1f", "2"}),
             as_it_is),
      forged("balls larger than a patch", "1.patch", certificate(circle, {"1", "2"}),
             claim("1", "circumradius", "1/5")),
      forged("balls smaller than any edge", "1.vertices", certificate(circle, {"1", "2"}),
             claim("1", "circumradius", "1/64")),
      forged("circumradius too small", "1.radius", round, claim("1", "circumradius", "5/64")),
      forged("thickness too large", "1.thickness", sphere_document(), claim("1", "thickness", "7/8")),
      forged("protection too large", "1.protection", certificate(circle, {"1", "2"}), claim("1", "protection", "5/32")),
      forged("points moved although none should be", "1.perturbation", round,
             [](Json& j) {
               j["parameters"]["mode"] = "measured";
               j["points"][5][0] = "1/1000";
             }),
      forged("an edge missing", "1.facets", certificate(circle, {"1", "2"}),
             [](Json& j) {
               j["simplices"].erase(4);
               j["levels"]["2"]["simplices"] = 39;
               j["levels"]["2"]["euler_characteristic"] = 1;
             }),
      forged("a reach beyond the patch", "2s.patch", round, claim("2s", "reach", "1/2")),
      forged("a reach that does not show enough", "2s.reach", round, claim("2s", "reach", "1/4")),
      forged("a triangle missing from a given sphere", "1f.facets", certificate(given(sphere_model(3)), {"1f", "2"}),
             without_a_simplex),
      forged("two vertices of a polygon exchanged", "1f.sides", certificate(zigzag, {"1f", "2"}), as_it_is),
      forged("a sphere that goes around its poles twice", "1f.ray",
             certificate(branched_sphere_model(13, 41), {"1f", "2"}), as_it_is),
      forged("displacement too small", "5.fibre", round, claim("5", "displacement", "1/4096")),
      forged("contraction too small", "5.contract", round, claim("5", "contraction", "1/4096")),
      forged("a polygon that goes around twice", "5.clear", certificate(given(circle_model(81, 2)), {"1f", "2", "5"}),
             as_it_is),
      forged("a torus that goes around twice", "5.clear", certificate(wound, {"1f", "2", "5"}), as_it_is),
      forged("a density smaller than any circumradius", "4.density", certificate(circle, {"1", "2", "4", "5"}),
             claim("4", "density", "1/16")),
      forged("a density beyond the lid", "4.patch", certificate(circle, {"1", "2", "4", "5"}),
             claim("4", "density", "1/5")),
      forged("a density that reaches to the other side", "4.clear", certificate(twelve_points(), {"1", "2", "4", "5"}),
             [](Json& j) {
               j["parameters"]["distortion"] = "1048575/1048576";
               j["levels"]["1"]["circumradius"] = "17/64";
               j["levels"]["1"]["protection"] = "1/64";
               j["levels"]["4"]["density"] = text_of(0.64429);
             }),
      forged("stretched more than stated", "6.bilipschitz", round,
             [](Json& j) { j["levels"]["6"]["bilipschitz"][0] = "1"; }),
      forged("angles to tangent planes too small", "6.normal", sphere_document(), claim("6", "normal", "1/4096")),
      forged("a weight that no angles have", "6.self-delaunay", sphere_document(), claim("6", "weight", "2")),
      forged("a displacement that leaves the patches", "5i.lid", round, claim("5", "displacement", "3/64")),
      forged("a margin too large", "5i.embedded", round, claim("5i", "margin", "1/16")),
      forged("another Euler characteristic", "2.count", round,
             [](Json& j) { j["levels"]["2"]["euler_characteristic"] = 2; }),
  };
}

}  // namespace delcert::checker_tests
