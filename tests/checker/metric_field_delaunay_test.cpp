// Level 4 of metric fields: what is claimed where the metric varies little, and forgeries of it.

#include <gtest/gtest.h>

#include "tests/checker/support/forgeries.hpp"
#include "tests/checker/support/metric_field_documents.hpp"

namespace delcert::checker_tests {
namespace {

const Json& nearly_flat_document() {
  static const Json document = document_of<2>(test::nearly_flat_run());
  return document;
}

Change stated(const std::string& key, const Rational& factor) {
  return [=](Json& j) { j["levels"]["4"][key] = times(j["levels"]["4"][key], factor); };
}

Change with_level_4(const std::string& value) {
  return [=](Json& j) {
    const Json last = j["levels"]["5"];
    j["levels"].erase("5");
    j["levels"]["4"] = Json::parse(value);
    j["levels"]["5"] = last;
  };
}

/// The metric may do nearly anything there.
Json no_margin() {
  Json document = sheared_document();
  with_level_4(R"({"edge":"0x1p-10","margin":"0"})")(document);
  return document;
}

TEST(MetricFieldDelaunay, is_accepted_where_the_metric_varies_little) {
  for (const Json& document : {flat_document(), nearly_flat_document()}) {
    ASSERT_TRUE(document["levels"].contains("4"));
    const CheckerRun run = run_checker(sealed(document));
    EXPECT_EQ(run.status, 0) << run.output;
    EXPECT_NE(run.output.find("the Delaunay complex for the distance of the metric"), std::string::npos) << run.output;
  }
  EXPECT_FALSE(nearly_flat_document()["manifold"]["waves"].empty());
}

TEST(MetricFieldDelaunay, is_accepted_in_dimension_3) {
  const MetricFieldSample<3> sample = lattice_sample(ratio(1, 2000));
  ASSERT_TRUE(sample.run.is_certified());
  std::vector<std::string> reasons;
  const auto claims = sample.claims(reasons, {"1", "2", "4", "5"});
  EXPECT_EQ(claims.names(), (std::vector<std::string>{"1", "2", "4", "5"})) << testing::PrintToString(reasons);
  const CheckerRun checked = run_checker(bytes_of<3>(sample, claims));
  EXPECT_EQ(checked.status, 0) << checked.output;
}

TEST(MetricFieldDelaunay, margins_hold_and_little_more_does_not) {
  const auto& sample = test::nearly_flat_run();
  const Rational more = ratio(1001, 1000);
  const auto expect = [&](const std::string& rule, const auto& change) {
    auto claims = claims_of<2>(sample);
    ASSERT_TRUE(claims.delaunay.has_value());
    change(*claims.delaunay->stability);
    const CheckerRun run = run_checker(bytes_of<2>(sample, claims));
    EXPECT_EQ(run.status, 1) << rule;
    EXPECT_EQ(run.rules, std::set<std::string>{rule}) << run.output;
  };
  expect("4.edge", [&](DelaunayClaim::Stability& claim) { claim.edge *= more; });
  expect("4.stability", [&](DelaunayClaim::Stability& claim) { claim.margin *= more; });
}

/// Both programs compute the margin from the same numbers.
TEST(MetricFieldDelaunay, margin_is_the_same_exact_number_on_both_sides) {
  const auto& sample = test::nearly_flat_run();
  auto claims = claims_of<2>(sample);
  claims.delaunay->stability->margin = claims.delaunay_margin->value();
  EXPECT_EQ(run_checker(bytes_of<2>(sample, claims)).status, 0);
  claims.delaunay->stability->margin += Rational::power_of_two(-200);
  EXPECT_EQ(run_checker(bytes_of<2>(sample, claims)).rules, std::set<std::string>{"4.stability"});
}

TEST(MetricFieldDelaunay, is_refused_where_the_metric_varies_too_much) {
  EXPECT_EQ(run_checker(sealed(no_margin())).rules, std::set<std::string>{"4.stability"});
  // Protection, thickness and circumradius of level 1 are what it rests on.
  expect_forgery("4.stability", nearly_flat_document(),
                 [](Json& j) { j["levels"]["1"]["protection"] = times(j["levels"]["1"]["protection"], ratio(1, 9)); });
  expect_forgery("4.stability", nearly_flat_document(),
                 [](Json& j) { j["levels"]["1"]["thickness"] = times(j["levels"]["1"]["thickness"], ratio(1, 99)); });
  expect_forgery("4.stability", nearly_flat_document(), [](Json& j) { j["manifold"]["metric_distortion"] = "1/2"; });
}

TEST(MetricFieldDelaunay, has_its_form) {
  const auto malformed = [&](const std::string& rule, const Change& change) {
    expect_forgery(rule, flat_document(), change, 3);
  };
  malformed("form.keys", [](Json& j) { j["levels"]["4"] = Json::object(); });
  malformed("form.keys", [](Json& j) { j["levels"]["4"].erase("margin"); });
  malformed("form.ranges", stated("edge", Rational(0)));
  malformed("form.ranges", stated("edge", Rational(-1)));
  malformed("form.ranges", stated("margin", Rational(-1)));
  malformed("form.levels", [](Json& j) {
    for (const char* level : {"1", "2", "2s", "5"}) j["levels"].erase(level);
  });
}

}  // namespace

std::vector<Forgery> metric_field_delaunay_forgeries() {
  const auto forged = [](const char* name, const char* rule, const Json& valid, const Change& change) {
    Json document = valid;
    change(document);
    return Forgery{name, rule, sealed(document)};
  };
  const auto nothing = [](Json&) {};
  return {
      forged("edges longer than they are", "4.edge", nearly_flat_document(), stated("edge", Rational(2))),
      forged("edges a little longer than they are", "4.edge", flat_document(), stated("edge", ratio(1001, 1000))),
      forged("a margin larger than there is", "4.stability", nearly_flat_document(),
             stated("margin", ratio(1001, 1000))),
      forged("Delaunay for a metric that varies too much", "4.stability", no_margin(), nothing),
  };
}

}  // namespace delcert::checker_tests
