// Runs on metric fields, verified by the checker; and forgeries of them: one for each rule of their own.

#include <gtest/gtest.h>

#include "kernel/sample/separation.hpp"
#include "tests/checker/support/forgeries.hpp"
#include "tests/checker/support/metric_field_documents.hpp"

namespace delcert::checker_tests {
namespace {

Change stated(const std::string& block, const std::string& key, const Rational& factor) {
  return [=](Json& j) { j[block][key] = times(j[block][key], factor); };
}

TEST(MetricField, a_run_on_a_sheared_torus_is_accepted) {
  const CheckerRun run = run_checker(sealed(sheared_document()));
  EXPECT_EQ(run.status, 0) << run.output;
  std::printf("%zu points: %s", test::sheared_run().atlas.size(), run.output.c_str());
}

TEST(MetricField, a_lattice_of_dimension_3_is_accepted) {
  const MetricFieldSample<3> sample = lattice_sample(ratio(1, 50));
  ASSERT_TRUE(sample.run.is_certified());
  std::vector<std::string> reasons;
  const auto claims = sample.claims(reasons, {"1", "2", "5"});
  EXPECT_EQ(group_text(claims.manifold->homology[1]), "Z^3");
  const CheckerRun checked = run_checker(bytes_of<3>(sample, claims));
  EXPECT_EQ(checked.status, 0) << checked.output;
}

TEST(MetricField, another_metric_has_other_charts) {
  Json document = sheared_document();
  document["manifold"]["waves"][0]["sine"][1][1] = "1/9";
  const CheckerRun run = run_checker(sealed(document));
  EXPECT_EQ(run.status, 1);
  EXPECT_TRUE(run.rules.contains("field.chart")) << run.output;
  document = sheared_document();
  document["manifold"]["waves"][0]["frequency"] = Json::parse("[0,1]");
  EXPECT_TRUE(run_checker(sealed(document)).rules.contains("field.chart"));
}

TEST(MetricField, patches_are_small_enough) {
  const Json& document = flat_document();
  EXPECT_EQ(run_checker(sealed(document)).status, 0);
  EXPECT_EQ(document["parameters"]["distortion"], "0");
  // A patch that holds no ball; nothing else looks at it here.
  expect_forgery("1.patch", document, [&](Json& j) {
    j["levels"].erase("2s");
    j["manifold"]["patch_radius"] = times(j["parameters"]["sampling_radius"], ratio(11, 10));
  });
  expect_forgery("2s.patch", document, [&](Json& j) { j["levels"]["2s"]["reach"] = j["manifold"]["patch_radius"]; });
}

TEST(MetricField, margins_hold_and_little_more_does_not) {
  const auto& sample = test::sheared_run();
  const Rational more = ratio(1001, 1000);
  const auto expect = [&](const std::string& rule, const auto& change) {
    auto claims = claims_of<2>(sample);
    change(claims);
    const CheckerRun run = run_checker(bytes_of<2>(sample, claims));
    EXPECT_EQ(run.status, 1) << rule;
    EXPECT_EQ(run.rules, std::set<std::string>{rule}) << run.output;
  };
  expect("1.protection", [&](auto& claims) { claims.stars->protection *= more; });
  expect("1.thickness", [&](auto& claims) { claims.stars->thickness *= more; });
  expect("1.radius", [&](auto& claims) { claims.stars->circumradius /= more; });
  expect("2s.reach", [&](auto& claims) { *claims.stable_stars->reach *= ratio(99, 100); });
  expect("2.count", [&](auto& claims) { ++claims.manifold->simplices; });
  expect("2.homology", [&](auto& claims) { claims.manifold->homology.back() = {}; });
}

TEST(MetricField, points_are_perturbed_by_no_more_than_is_said) {
  expect_forgery("1.perturbation", sheared_document(), stated("parameters", "perturbation", ratio(9, 10)));
}

/// The last label whose net point is no neighbour of the first one's.
std::size_t far_from_first(const Json& net) {
  const auto coordinate = [&net](std::size_t label, std::size_t axis) {
    return parse_exact(net[label][axis].get<std::string>());
  };
  std::size_t label = net.size();
  while (--label > 0) {
    const Rational across = square(coordinate(label, 0) - coordinate(0, 0));
    if (across > ratio(1, 9) && across < ratio(4, 9)) break;
  }
  return label;
}

TEST(MetricField, stars_are_complete_and_their_labels_are_seen) {
  const auto rules = [](const Change& change) {
    Json document = sheared_document();
    change(document);
    return run_checker(sealed(document)).rules;
  };
  const auto incomplete = rules([](Json& j) { j["simplices"].erase(4); });
  EXPECT_TRUE(incomplete.contains("1.facets"));
  EXPECT_TRUE(incomplete.contains("2.count"));
  const auto far = rules([](Json& j) {
    std::size_t last = 0;  // of label 0
    while (j["simplices"][last + 1][0] == 0) ++last;
    j["simplices"][last][2] = far_from_first(j["net"]);
  });
  EXPECT_TRUE(far.contains("1.vertices")) << testing::PrintToString(far);
  // A point that is moved is in balls, or its star is another.
  const auto moved = rules([](Json& j) { j["points"][9] = Json::parse(R"(["0x3p-6","0"])"); });
  EXPECT_TRUE(moved.contains("1.protection")) << testing::PrintToString(moved);
}

TEST(MetricField, stars_that_differ_in_other_charts_are_not_stable) {
  // A metric that varies much, and a perturbation that asks for little.
  auto description = test::constant_field({{Rational(1), Rational(0)}, {Rational(0), Rational(2)}});
  description.waves.push_back(
      {{1, 0}, test::zero_matrix(2), {{Rational(0), ratio(3, 10)}, {ratio(3, 10), Rational(0)}}});
  description.waves.push_back({{0, 1}, {{ratio(1, 5), Rational(0)}, {Rational(0), Rational(0)}}, test::zero_matrix(2)});
  MetricField<2> field(description);
  const Rational radius = ratio(1, 24);
  MetricFieldAtlas<2> atlas(field, metric_field_net<2>(field, radius, 1, no_progress()).centres, radius);
  const auto distortion = fit_patches<2>(atlas, no_progress());
  ParameterChoice choice;
  choice.mode = RunMode::measured;
  const auto parameters = parameters_for(Dimension(2), measure_separation<2>(atlas), choice);
  RunRequest request;
  request.certify_model = false;
  const auto geometry = geometry_of<2>(atlas, distortion);
  auto run = run_in_charts<2>(atlas, geometry, parameters.algorithm, request, no_progress());
  ASSERT_TRUE(run.is_certified());
  const auto stability = check_stability<2>(atlas, run.points, geometry, run.complex, no_progress());
  ASSERT_GT(stability.differing, 0U);
  const auto triangulation = check_affine_triangulation<2>(atlas, run.points, run.complex);
  MetricFieldSample<2> sample{std::move(atlas), distortion, parameters, std::move(run), {stability, triangulation}};
  auto claims = claims_of<2>(sample);
  EXPECT_EQ(claims.names(), (std::vector<std::string>{"1", "2", "5"}));
  EXPECT_EQ(run_checker(bytes_of<2>(sample, claims)).status, 0);
  claims.stable_stars = StableStarsClaim{sample.atlas.patch_radius() * ratio(999, 1000)};
  const CheckerRun forged = run_checker(bytes_of<2>(sample, claims));
  EXPECT_EQ(forged.status, 1);
  EXPECT_TRUE(forged.rules.contains("2s.protection")) << forged.output;
}

TEST(MetricField, the_document_has_its_form) {
  const Json& valid = sheared_document();
  const auto malformed = [&](const std::string& rule, const Change& change) { expect_forgery(rule, valid, change, 3); };
  const auto manifold = [](const std::string& key, const std::string& value) {
    return [=](Json& j) { j["manifold"][key] = Json::parse(value); };
  };
  malformed("form.charts", [](Json& j) { j["charts"][3][2] = "0"; });
  malformed("form.charts", [](Json& j) { j["charts"][3][0] = "-1"; });
  malformed("form.lengths", [](Json& j) { j["charts"].erase(3); });
  malformed("form.lengths", [](Json& j) { j["net"] = Json::array(); });
  malformed("form.keys", [](Json& j) { j["charts"][3].erase(2); });
  malformed("form.keys", [](Json& j) { j.erase("charts"); });
  malformed("form.keys", manifold("family", "\"flat-torus\""));
  malformed("form.types", manifold("dimension", "4"));
  malformed("form.gram", manifold("constant", R"([["1","0"],["1","2"]])"));
  malformed("form.gram", [](Json& j) { j["manifold"]["waves"][1]["cosine"][0][1] = "1/100"; });
  malformed("form.types", [](Json& j) { j["manifold"]["waves"][0]["frequency"][0] = 1001; });
  malformed("form.ranges", manifold("rounding", "\"0\""));
  malformed("form.ranges", manifold("rounding", "\"1\""));
  malformed("form.ranges", manifold("metric_distortion", "\"1\""));
  malformed("form.ranges", manifold("patch_radius", "\"0\""));
  malformed("form.ranges", [](Json& j) { j["parameters"]["distortion"] = "1"; });
  malformed("form.ranges", [](Json& j) { j["parameters"]["distortion"] = "-1/100"; });
  malformed("form.ranges", [](Json& j) { j["levels"]["2s"]["reach"] = "0"; });
  malformed("form.family", [](Json& j) { j["parameters"]["mode"] = "theory"; });
  malformed("form.keys", [](Json& j) { j["levels"]["5"]["route"] = "space-form"; });
  malformed("form.family", [](Json& j) {
    const Json last = j["levels"]["5"];
    j["levels"].erase("5");
    j["levels"]["3"] = Json::parse(R"({"tested":"nothing"})");
    j["levels"]["5"] = last;
  });
  malformed("form.levels", [](Json& j) {
    for (const char* level : {"1", "2", "2s"}) j["levels"].erase(level);
  });
}

TEST(MetricField, huge_and_tiny_numbers_never_verify) {
  for (const char* number : {"0x1p99999", "-0x1p99999", "0x1p-99999", "123456789012345678901234567890"}) {
    for (const char* key : {"net", "charts", "points"}) {
      if (std::string(number) == "0x1p-99999" && std::string(key) != "charts") continue;
      Json document = sheared_document();
      document[key][5][0] = number;
      EXPECT_GT(run_checker(sealed(document)).status, 0) << key << " " << number;
    }
  }
}

}  // namespace

std::vector<Forgery> metric_field_forgeries() {
  const auto forged = [](const char* name, const char* rule, const Json& valid, const Change& change) {
    Json document = valid;
    change(document);
    return Forgery{name, rule, sealed(document)};
  };
  const Json& sheared = sheared_document();
  return {
      forged("charts said to be rounded better", "field.chart", sheared,
             stated("manifold", "rounding", Rational::power_of_two(-6))),
      forged("another chart", "field.chart", sheared,
             [](Json& j) { j["charts"][7][0] = times(j["charts"][7][0], Rational(1) + Rational::power_of_two(-24)); }),
      forged("larger patches", "field.patch", flat_document(), stated("manifold", "patch_radius", Rational(2))),
      // So much less that it is refuted everywhere at once: without the rule nothing else is left to decide.
      forged("a tenth of the distortion of the metric", "field.metric", sheared,
             stated("manifold", "metric_distortion", ratio(1, 10))),
      forged("half the distortion of transitions", "field.distortion", sheared,
             stated("parameters", "distortion", ratio(1, 2))),
      forged("no distortion of transitions", "field.distortion", sheared,
             [](Json& j) { j["parameters"]["distortion"] = "0"; }),
  };
}

}  // namespace delcert::checker_tests
