// Certificates of zero sets, made without the program: they are verified; and forgeries of them.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>

#include "tests/checker/merge.hpp"
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

/// A sphere by 1280 triangles, on one by 5120.
SubmanifoldModel remeshed(const SubmanifoldModel& polyhedron = sphere_model(4)) {
  SubmanifoldModel model = on_mesh(sphere_model(3), polyhedron);
  model.displacement *= 1.25;
  return model;
}

const Json& remeshed_document() {
  static const Json document = certificate(remeshed(), all);
  return document;
}

/// As the numbers of charts are written.
std::string text_of(double x) { return std::to_string(static_cast<long long>(x * 0x1p30)) + "/1073741824"; }

/// The same with radii: the sampling radius times what this says of a label.
template <class Units>
Json with_radii(const Json& document, const char* variation, const Units& unit_of) {
  Json result;
  const std::string radius = document["parameters"]["sampling_radius"];
  const double whole = std::stod(radius.substr(0, radius.find('/'))) /
                       (radius.find('/') == std::string::npos ? 1 : std::stod(radius.substr(radius.find('/') + 1)));
  for (const auto& [key, value] : document.items()) {
    result[key] = value;
    if (key != "charts") continue;
    for (std::size_t i = 0; i < document["points"].size(); ++i) result["radii"].push_back(text_of(whole * unit_of(i)));
  }
  result["parameters"]["radius_variation"] = variation;
  return result;
}

/// Every second radius is a little less than the others.
double every_second(std::size_t label) { return label % 2 == 0 ? 1 : 31.0 / 32; }

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

TEST(Submanifold, in_parts_says_what_the_whole_says) {
  expect_the_same_in_parts(sealed(circle_document()), {3});
  expect_the_same_in_parts(sealed(certificate(given(sphere_model(3)), of_given)), {2});
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

/// Two circles that are near, with lids so low that none of their labels is roomy.
SubmanifoldModel close_circles() {
  SubmanifoldModel model = near_circles("extrinsic", 0.0065);
  model.margin = 0.005;
  return model;
}

TEST(Submanifold, simplices_that_are_apart_are_embedded_where_labels_are_not_roomy) {
  expect_verified(certificate(close_circles(), {"1", "2", "5", "5i"}));
  // Half an edge is not as much as this; pairs of simplices have more.
  for (const Json& document : {circle_document(), sphere_document()}) {
    Json more = document;
    more["levels"]["5i"]["margin"] = "3/32";
    expect_verified(more);
  }
}

/// Along the vectors that are tried all edges are as far apart as this, but not by what they are moved, too.
constexpr double apart_unmoved = 0.00638;

TEST(Submanifold, simplices_are_not_apart_if_that_is_less_than_they_are_moved_by) {
  Json document = certificate(close_circles(), {"1", "2", "5", "5i"});
  document["levels"]["5i"]["margin"] = text_of(apart_unmoved);
  const CheckerRun run = run_checker(sealed(document));
  EXPECT_EQ(run.status, 1);
  EXPECT_NE(run.output.find("5i.apart"), std::string::npos) << run.output;
}

TEST(Submanifold, a_star_is_not_wide_if_its_edges_swing_too_far) {
  Json document = circle_document();
  document["levels"]["5i"]["margin"] = "309/2000";
  const CheckerRun run = run_checker(sealed(document));
  EXPECT_EQ(run.status, 1);
  EXPECT_NE(run.output.find("5i.star"), std::string::npos) << run.output;
}

/// Claims level 5i by normals.
Json by_normals(Json document, const std::string& cosine) {
  document["levels"]["5i"] = {{"cosine", cosine}};
  return document;
}

TEST(Submanifold, is_embedded_where_its_normals_are_those_of_the_manifold) {
  for (const Json& document : {circle_document(), sphere_document()}) {
    expect_verified(by_normals(document, "63/64"));
    const CheckerRun run = run_checker(sealed(by_normals(document, "1")));
    EXPECT_EQ(run.status, 1);
    EXPECT_NE(run.output.find("5i.normal"), std::string::npos) << run.output;
  }
}

TEST(Submanifold, of_dimension_3_is_embedded_by_normals) {
  const SubmanifoldModel model = sphere_of_cells_model();
  ASSERT_EQ(model.points.size(), 840);
  ASSERT_EQ(model.simplices.size(), 4800);
  const Json document = certificate(model, {"1f", "2", "5"});
  expect_verified(by_normals(document, "15/16"));
  const CheckerRun run = run_checker(sealed(by_normals(document, "63/64")));
  EXPECT_EQ(run.status, 1);
  EXPECT_EQ(run.rules, std::set<std::string>{"5i.normal"}) << run.output;
}

TEST(Submanifold, is_embedded_by_normals_where_edges_are_too_short_for_a_margin) {
  // One more vertex, very near to vertex 0: the edges to both sides of the short edge nearly meet.
  SubmanifoldModel model = given(circle_model(40, 1));
  const double turn = 0x1p-16;
  model.points.push_back({std::sqrt(1 - turn * turn), turn});
  model.simplices.erase(std::find(model.simplices.begin(), model.simplices.end(), std::vector<int>{0, 1}));
  model.simplices.push_back({0, 40});
  model.simplices.push_back({1, 40});
  std::sort(model.simplices.begin(), model.simplices.end());
  model.margin = turn / 8;
  const Json document = certificate(model, {"1f", "2", "5", "5i"});
  const CheckerRun run = run_checker(sealed(document));
  EXPECT_EQ(run.status, 1);
  EXPECT_EQ(run.rules, std::set<std::string>{"5i.apart"}) << run.output;
  expect_verified(by_normals(document, "63/64"));
}

/// A circle in charts that are tilted, with one more vertex very near to vertex 0. The edge between them is so steep
/// that a gradient is within a few degrees of it: on one side of the edge if it rises in the chart, on the other if it
/// falls.
Json with_steep_edge(double steepness) {
  SubmanifoldModel model = given(circle_model(60, 1));
  model.tilt = -0.15;
  model.slope = 1.6;
  model.patch_radius = 0.2;
  model.height = 0.2;
  model.contraction = 0.9;
  model.displacement = 0.02;
  const double length = 0x1p-12, along = std::sin(model.tilt), up = std::cos(model.tilt);
  model.points.push_back({1 + length * (along + steepness * up), length * (up - steepness * along)});
  model.simplices.erase(std::find(model.simplices.begin(), model.simplices.end(), std::vector<int>{0, 1}));
  model.simplices.push_back({0, 60});
  model.simplices.push_back({1, 60});
  std::sort(model.simplices.begin(), model.simplices.end());
  return by_normals(certificate(model, {"1f", "2", "5", "5i"}), "1/16");
}

TEST(Submanifold, normals_and_gradients_are_on_the_same_side_of_steep_edges) {
  expect_verified(with_steep_edge(20));
  const CheckerRun run = run_checker(sealed(with_steep_edge(-20)));
  EXPECT_EQ(run.status, 1);
  EXPECT_EQ(run.rules, std::set<std::string>{"5i.normal"}) << run.output;
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

TEST(Submanifold, a_lid_has_to_be_above_what_may_be_nearest_to_its_label_only) {
  Json document = certificate(circle_model(80, 1), {"1", "2", "4", "5"});
  document["levels"]["4"]["density"] = "1/4";  // more than the lids
  expect_verified(document);
  document["charts"][3].back() = "1/32";  // less than half an edge
  const CheckerRun run = run_checker(sealed(document));
  EXPECT_EQ(run.status, 1);
  EXPECT_EQ(run.rules, std::set<std::string>{"4.patch"}) << run.output;
  document["levels"]["4"]["metric"] = "intrinsic";
  expect_verified(document);
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

TEST(Submanifold, a_mesh_is_verified_as_the_manifold) {
  expect_verified(remeshed_document());
  // On other facets, over whose edges and vertices no points are.
  SubmanifoldModel turned = sphere_model(4);
  for (auto& x : turned.points) x = {0.8 * x[0] - 0.6 * x[1], 0.6 * x[0] + 0.8 * x[1], x[2]};
  expect_verified(certificate(remeshed(turned), all));
}

TEST(Submanifold, of_a_mesh_the_complex_is_Delaunay_by_distances_in_it_where_slopes_are_nearly_affine) {
  for (const char* metric : {"intrinsic", "both"}) expect_verified(certificate(by(metric, remeshed()), all));
}

TEST(Submanifold, a_mesh_that_is_not_one_is_malformed) {
  const auto rules = [](const std::function<void(Json&)>& change) {
    Json document = remeshed_document();
    change(document);
    const CheckerRun run = run_checker(sealed(document));
    EXPECT_EQ(run.status, 3) << run.output;
    return run.rules;
  };
  using Rules = std::set<std::string>;
  EXPECT_EQ(rules([](Json& j) { j["manifold"]["facets"][7][1] = 2562; }), Rules{"form.ranges"});
  EXPECT_EQ(rules([](Json& j) { j["manifold"]["facets"] = Json::array(); }), Rules{"form.ranges"});
  EXPECT_EQ(rules([](Json& j) { j["manifold"]["vertices"] = "given"; }).size(), 1U);
  EXPECT_EQ(rules([](Json& j) { j["manifold"]["dimension"] = 3; }).size(), 1U);
}

TEST(Submanifold, lengths_of_radii_that_vary_are_said_to_be_in_proportion) {
  constexpr const char* words = "(lengths, of the greatest radius; elsewhere in proportion)";
  const auto says_so = [&](const Json& document) {
    return run_checker(sealed(document)).output.find(words) != std::string::npos;
  };
  EXPECT_TRUE(says_so(with_radii(circle_document(), "1/16", every_second)));
  EXPECT_FALSE(says_so(circle_document()));
}

TEST(Submanifold, with_radii_that_vary_are_verified) {
  expect_verified(with_radii(circle_document(), "1/16", every_second));
  expect_verified(with_radii(polygon_document(), "1/16", every_second));
  expect_verified(with_radii(sphere_document(), "1/16", every_second));
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
  malformed("form.ranges", [](Json& j) { j["levels"]["5"]["displacement"] = "0"; });
  malformed("form.ranges", [](Json& j) { j["levels"]["5i"]["margin"] = "0"; });
  malformed("form.ranges", [](Json& j) { j = by_normals(j, "0"); });
  malformed("form.ranges", [](Json& j) { j["levels"]["2s"]["reach"] = "0"; });
  malformed("form.ranges", [](Json& j) { j["parameters"]["distortion"] = "1"; });
  malformed("form.ranges", [](Json& j) { j["parameters"]["radius_variation"] = "1/16"; });
  malformed("form.ranges", [](Json& j) { j = with_radii(j, "0", [](std::size_t i) { return i == 3 ? 0 : 1; }); });
  malformed("form.ranges", [](Json& j) { j = with_radii(j, "-1", every_second); });
  malformed("form.lengths", [](Json& j) {
    j = with_radii(j, "1/16", every_second);
    j["radii"].erase(3);
  });
  malformed("form.lengths", [](Json& j) {
    j = with_radii(j, "1/16", every_second);
    j["radii"] = Json::array();
  });
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
  // Gradients are normals of M where there is one equation, and facets have none.
  for (const Json& document : {certificate(flat_torus_model(20), {"1", "2", "5", "5i"}), remeshed_document()})
    EXPECT_EQ(run_checker(sealed(by_normals(document, "1/2"))).rules, std::set<std::string>{"form.family"});
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
  const Json& meshed = remeshed_document();
  const auto crack = [](Json& j) {  // of a unit in the last place
    Json& vertices = j["manifold"]["mesh"];
    Json& corner = j["manifold"]["facets"][100][0];
    const Json twin = vertices[corner.get<std::size_t>()];
    vertices.push_back(twin);
    const std::string x = vertices.back()[0].get<std::string>();
    std::string other = x == "0" ? "0x1p-53" : x;
    if (x != "0") other[x.find('p') - 1] = x[x.find('p') - 1] == '1' ? '2' : '1';
    vertices.back()[0] = other;
    corner = vertices.size() - 1;
  };
  Forgery reversed = forged("a facet that shows its other side", "mesh.closed", meshed, [](Json& j) {
    Json& facet = j["manifold"]["facets"][100];
    std::swap(facet[0], facet[1]);
  });
  reversed.others = {"sub.graph"};
  Forgery flat = forged("a facet without an area", "mesh.closed", meshed, [](Json& j) {
    j["manifold"]["facets"].push_back({5, 5, 6});
  });
  flat.others = {"sub.graph"};
  SubmanifoldModel first = on_mesh(first_component(doubled(sphere_model(3))), sphere_model(4));
  first.mesh.clear();
  first.facets.clear();
  {
    const SubmanifoldModel one = on_mesh(sphere_model(3), sphere_model(4));
    for (const double at : {2.0, -2.0}) {
      for (auto facet : one.facets) {
        for (int& vertex : facet) vertex += static_cast<int>(first.mesh.size());
        first.facets.push_back(facet);
      }
      for (auto x : one.mesh) {
        x[0] += at;
        first.mesh.push_back(x);
      }
    }
  }
  SubmanifoldModel steep = remeshed();
  steep.slope *= 0.75;
  Forgery near = forged("two circles nearer to each other than their points", "4.cover",
                        certificate(near_circles("extrinsic", 0.0065), {"1", "2", "4", "5"}), as_it_is);
  near.others = {"4.patch"};
  const auto with_a_flip = [](Json& j) {
    // The first triangle and one at its first side give way to those at the other diagonal.
    Json& simplices = j["simplices"];
    const int a = simplices[0][0], b = simplices[0][1], c = simplices[0][2];
    for (std::size_t k = 1; k < simplices.size(); ++k) {
      std::vector<int> rest;
      for (std::size_t at = 0; at < 3; ++at) {
        if (simplices[k][at] != a && simplices[k][at] != b) rest.push_back(simplices[k][at]);
      }
      if (rest.size() != 1) continue;
      std::vector<std::vector<int>> rows = {{a, c, rest[0]}, {b, c, rest[0]}};
      simplices.erase(k);
      simplices.erase(0);
      for (const Json& row : simplices) rows.push_back({row[0], row[1], row[2]});
      for (auto& row : rows) std::sort(row.begin(), row.end());
      std::sort(rows.begin(), rows.end());
      simplices = Json::array();
      for (auto& row : rows) {
        row.insert(row.end(), {0, 0});
        simplices.push_back(row);
      }
      return;
    }
    throw std::logic_error("no second triangle");
  };
  Forgery turned_fibres = forged("fibres that go the other way at one vertex", "5.fibre", meshed,
                                 [](Json& j) { j["charts"][3][6] = "-" + j["charts"][3][6].get<std::string>(); });
  turned_fibres.others = {"5.contract"};
  Forgery flipped =
      forged("two triangles flipped", "1.protection", certificate(sphere_model(3), {"1", "2"}), [&](Json& j) {
        with_a_flip(j);
        j["levels"]["1"]["thickness"] = "1/1024";
      });
  flipped.others = {"1.radius", "1.vertices"};
  // Point 7 of a circle and that of another, of which it is three times as far away as points are moved.
  SubmanifoldModel glued = given(near_circles("intrinsic", 0.0065));
  for (auto& edge : glued.simplices) {
    for (int& label : edge) label = label == 7 ? 407 : label == 407 ? 7 : label;
    std::sort(edge.begin(), edge.end());
  }
  std::sort(glued.simplices.begin(), glued.simplices.end());
  Forgery exchanged =
      forged("two circles that are exchanged at one label", "5.fibre", certificate(glued, {"1f", "2", "5"}), as_it_is);
  exchanged.others = {"5.contract"};
  Forgery crowded = forged("a mesh with less room than stated", "5i.star", meshed, claim("5i", "margin", "1/4"));
  crowded.others = {"5i.apart"};
  const SubmanifoldModel close = close_circles();
  const auto with_one_radius = [](double unit) {
    return [=](Json& j) { j = with_radii(j, "100", [=](std::size_t i) { return i == 5 ? unit : 1; }); };
  };
  return {
      near,
      forged("edges that are longer than the other diagonals, seen at a slant", "4.cover",
             certificate(tilted_torus_model(), {"1", "2", "4", "5"}), as_it_is),
      reversed,
      forged("a crack in a mesh, of a unit in the last place", "mesh.closed", meshed, crack),
      forged("a mesh with a facet less", "mesh.closed", meshed, [](Json& j) { j["manifold"]["facets"].erase(5); }),
      forged("a facet of a mesh twice", "mesh.closed", meshed,
             [](Json& j) {
               const Json twin = j["manifold"]["facets"][5];
               j["manifold"]["facets"].push_back(twin);
             }),
      flat,
      forged("a mesh that goes around its poles twice", "sub.graph",
             certificate(on_mesh(sphere_model(3), branched_sphere_model(25, 81)), {"1", "2"}), as_it_is),
      forged("a mesh steeper than stated", "sub.graph", certificate(steep, {"1", "2"}), as_it_is),
      forged("a lid below facets", "sub.graph", certificate(remeshed(), {"1", "2"}),
             [&](Json& j) { j["charts"][3].back() = text_of(0.5 * steep.patch_radius * steep.patch_radius); }),
      forged("a chart without a preconditioner", "sub.graph", certificate(remeshed(), {"1", "2"}),
             [](Json& j) { j["charts"][3][6] = "0"; }),
      forged("one of two components of a mesh left out", "sub.cover", certificate(first, {"1", "2"}), as_it_is),
      forged("a mesh farther away than stated", "5.fibre", meshed, claim("5", "displacement", "1/4096")),
      forged("a mesh more turned than stated", "5.contract", meshed, claim("5", "contraction", "1/4096")),
      forged("angles to facets too small", "6.normal", meshed, claim("6", "normal", "1/4096")),
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
      forged("a lid below what may be nearest to its label", "4.patch",
             certificate(circle_model(80, 1), {"1", "2", "4", "5"}), [](Json& j) { j["charts"][3].back() = "1/32"; }),
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
      forged("points that may leave the patches", "1.patch", certificate(circle, {"1", "2"}),
             [&](Json& j) {
               j["parameters"]["mode"] = "measured";
               j["parameters"]["separation"] = "1";
               j["parameters"]["perturbation"] = "1/4";
               j["levels"]["1"]["protection"] = "1/1024";
               j["levels"]["1"]["circumradius"] = text_of(circle.patch_radius / 2 - 0x1p-7);
             }),
      forged("a chart turned by more than the slope", "sub.graph", certificate(circle, {"1", "2"}),
             [](Json& j) { j["charts"][7][2] = "1/16"; }),
      forged("a preconditioner of the other sign", "sub.graph", certificate(circle, {"1", "2"}),
             [](Json& j) { j["charts"][3][3] = "-" + j["charts"][3][3].get<std::string>(); }),
      turned_fibres,
      flipped,
      exchanged,
      forged("the homology of a torus", "2.homology", sphere_document(),
             [](Json& j) {
               j["levels"]["2"]["homology"] = {"Z", "Z^2", "Z"};
             }),
      forged("a mesh less dense than stated", "4.density", meshed, claim("4", "density", "1/64")),
      crowded,
      forged("a mesh stretched more than stated", "6.bilipschitz", meshed,
             [](Json& j) { j["levels"]["6"]["bilipschitz"][0] = "1"; }),
      forged("a margin too large", "5i.star", round, claim("5i", "margin", "309/2000")),
      forged("normals that are nearer to gradients than they are", "5i.normal", round,
             [](Json& j) { j = by_normals(j, "1"); }),
      forged("an edge on the other side of a gradient", "5i.normal", with_steep_edge(20),
             [](Json& j) { j = with_steep_edge(-20); }),
      forged("two circles nearer to each other than stated", "5i.apart", certificate(close, {"1", "2", "5", "5i"}),
             [](Json& j) { j["levels"]["5i"]["margin"] = text_of(apart_unmoved); }),
      forged("radii that differ by more than stated", "sub.radii", round,
             [](Json& j) { j = with_radii(j, "1/64", every_second); }),
      forged("radii exchanged between two circles", "sub.radii", certificate(doubled(circle_model(60, 1)), {"1", "2"}),
             [](Json& j) {
               j = with_radii(j, "1/1024", [](std::size_t i) { return (i < 60) == (i % 60 != 5) ? 1 : 31.0 / 32; });
             }),
      forged("a radius too small at one label", "1.radius", certificate(circle, {"1", "2"}), with_one_radius(0.875)),
      forged("a radius that is four times too large", "1.patch", certificate(circle, {"1", "2"}), with_one_radius(4)),
      forged("a radius for which points move too far", "5.fibre",
             certificate(given(circle_model(60, 1)), {"1f", "2", "5"}), with_one_radius(1.0 / 64)),
      forged("a radius too small for the density", "4.density", certificate(circle, {"1", "2", "4", "5"}),
             [with_one_radius](Json& j) {
               j["levels"]["4"]["density"] = text_of(0.086);  // enough with the radius of the others
               with_one_radius(0.92)(j);
             }),
      forged("another Euler characteristic", "2.count", round,
             [](Json& j) { j["levels"]["2"]["euler_characteristic"] = 2; }),
  };
}

}  // namespace delcert::checker_tests
