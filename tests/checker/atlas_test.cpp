// Runs on atlases by formulas, verified by the checker; and forgeries of them: one for each rule of their own.

#include <gtest/gtest.h>

#include <functional>

#include "kernel/number/exact_text.hpp"
#include "tests/checker/atlas_documents.hpp"
#include "tests/checker/merge.hpp"
#include "tests/checker/support/certificate_text.hpp"
#include "tests/checker/support/forgeries.hpp"
#include "tests/checker/support/run_checker.hpp"
#include "tests/support/ratio.hpp"

namespace delcert::checker_tests {
namespace {

using test::ratio;

/// The first transition between these charts, by their numbers.
Json& transition_of(Json& j, int from, int to) {
  for (Json& transition : j["manifold"]["transitions"]) {
    if (transition["from"] == from && transition["to"] == to) return transition;
  }
  throw std::logic_error("no such transition");
}

TEST(Atlas, runs_are_accepted) {
  for (const Json* document : {&sphere_document(), &torus_document(), &cone_document()}) {
    const CheckerRun run = run_checker(sealed(*document));
    EXPECT_EQ(run.status, 0) << run.output;
  }
}

TEST(Atlas, in_parts_says_what_the_whole_says) {
  expect_the_same_in_parts(sealed(sphere_document()), {3});
  expect_the_same_in_parts(sealed(torus_document()), {2});
}

TEST(Atlas, what_it_is_of_is_said) {
  const CheckerRun run = run_checker(sealed(torus_document()));
  const Json manifold = Json::parse(run.output)["manifold"];
  EXPECT_EQ(manifold["family"], "atlas");
  EXPECT_EQ(manifold["size"], "4 charts, 16 transitions");
  EXPECT_EQ(manifold["orientability"], "orientable");
  EXPECT_EQ(manifold["first_homology"], "Z^2");
}

/// Two squares that are glued to a sphere, if a circle around the pole is left out: limits on it are not unique.
void leave_out_a_ring(Json& j) {
  j["levels"].erase("5");
  j["manifold"]["transitions"][0]["where"] = Json::parse(R"json(["(x^2+y^2-2/5)*(x^2+y^2-9/20)"])json");
  for (Json& chart : j["manifold"]["charts"]) chart["core"] = Json::parse(R"([["-15/8","15/8"],["-15/8","15/8"]])");
}

TEST(Atlas, a_map_without_an_inverse_is_not_looked_at_further) {
  // x/y goes to a line: what is put into the inverse divides by 0 everywhere.
  Json document = sphere_document();
  document["manifold"]["transitions"][0]["map"] = Json::parse(R"(["x","x"])");
  document["manifold"]["transitions"][0]["inverse"] = Json::parse(R"json(["1/(u-v)","v"])json");
  const CheckerRun run = run_checker(sealed(document));
  EXPECT_EQ(run.status, 1) << run.output;
  EXPECT_EQ(run.rules, std::set<std::string>{"atlas.inverse"}) << run.output;
}

TEST(Atlas, folds_fit_their_inverses_and_other_transitions_on_both_sides) {
  const auto rules = [](const std::function<void(Json & transition)>& change) {
    Json document = cone_document();
    change(transition_of(document, 1, 3));
    const CheckerRun run = run_checker(sealed(document));
    EXPECT_EQ(run.status, 1) << run.output;
    return run.rules;
  };
  // Both sides of the inverse are what one of them was.
  EXPECT_EQ(rules([](Json& transition) {
              std::string text = transition["inverse"][0].get<std::string>();
              text.replace(text.find("abs("), 3, "");
              transition["inverse"][0] = text;
            }),
            std::set<std::string>{"atlas.inverse"});
  // The second coordinate goes to itself and a trillionth of its positive part, which the inverse undoes.
  EXPECT_EQ(rules([](Json& transition) {
              const auto times = [](const Json& formula, const std::string& factor, const std::string& other) {
                const std::string text = "(" + formula.get<std::string>() + ")";
                return factor + "*" + text + other + "*abs" + text;
              };
              const std::string out = "2000000000001/2000000000000";
              transition["map"][1] = times(transition["map"][1], out, "+1/2000000000000");
              const std::string t = "(1-1/2000000000002)*t-1/2000000000002*abs(t)";
              for (Json& formula : transition["inverse"]) {
                std::string text;
                for (const char c : formula.get<std::string>()) text += c == 't' ? "(" + t + ")" : std::string(1, c);
                formula = text;
              }
            }),
            std::set<std::string>{"atlas.cocycle"});
}

// Defect: an absolute value of a constant ended the checker with an internal error.
TEST(Atlas, absolute_values_of_constants_are_numbers) {
  const auto run = [](const std::string& map) {
    Json document = sphere_document();
    document["manifold"]["transitions"][0]["map"][0] = map;
    return run_checker(sealed(document));
  };
  EXPECT_EQ(run("abs(-1)*x/(x^2+abs(y-y-1)*y^2)").status, 0);
  // More of them than a map may have folds.
  std::string ones;
  for (int k = 1; k <= 12; ++k) ones += "abs(-" + std::to_string(k) + ")/" + std::to_string(k) + "*";
  EXPECT_EQ(run(ones + "x/(x^2+y^2)").status, 0);
  EXPECT_EQ(run("abs(-2)*x/(x^2+y^2)").rules, std::set<std::string>{"atlas.inverse"});
  // With a fold all has to be linear.
  EXPECT_EQ(run("abs(-1)*x/(x^2+y^2)+abs(y)-abs(y)").rules, std::set<std::string>{"form.formula"});
}

TEST(Atlas, stars_are_complete_and_their_labels_are_seen) {
  Json document = sphere_document();
  document["simplices"].erase(4);
  EXPECT_TRUE(run_checker(sealed(document)).rules.contains("1.facets"));
  // A label in another chart is somewhere else.
  document = sphere_document();
  const int home = std::stoi(document["charts"][9][0].get<std::string>());
  document["charts"][9][0] = std::to_string(1 - home);
  const auto rules = run_checker(sealed(document)).rules;
  EXPECT_TRUE(rules.contains("1.vertices") || rules.contains("atlas.distortion")) << testing::PrintToString(rules);
}

TEST(Atlas, blends_that_are_no_contractions_may_keep_volumes) {
  Json document = sphere_document();
  Json& stated = document["levels"]["5"]["contraction"];
  ASSERT_GT(parse_exact(stated.get<std::string>()), ratio(1, 2));
  // No longer a contraction with that, but parts of simplices keep nine sixteenths of their areas.
  stated = "1/4";
  EXPECT_EQ(run_checker(sealed(document)).status, 0);
  stated = "1/128";
  EXPECT_EQ(run_checker(sealed(document)).rules, std::set<std::string>{"5.blend"});
}

TEST(Atlas, the_document_has_its_form) {
  const auto malformed = [](const std::string& rule, const std::function<void(Json&)>& change) {
    Json document = sphere_document();
    change(document);
    const CheckerRun run = run_checker(sealed(document));
    EXPECT_EQ(run.status, 3) << run.output;
    EXPECT_EQ(run.rules, std::set<std::string>{rule}) << run.output;
  };
  const auto transition = [](const std::string& key, const std::string& value) {
    return [=](Json& j) { j["manifold"]["transitions"][0][key] = Json::parse(value); };
  };
  malformed("form.charts", [](Json& j) { j["charts"][3][0] = "2"; });
  malformed("form.charts", [](Json& j) { j["charts"][3][0] = "1/2"; });
  malformed("form.charts", [](Json& j) { j["charts"][3][1] = "0"; });
  malformed("form.formula", transition("map", R"json(["x+abs(x*y)","y"])json"));
  malformed("form.formula", transition("map", R"json(["x+abs(y)","y^2"])json"));
  malformed("form.formula", transition("map", R"json(["x+abs","y"])json"));
  malformed("form.formula", transition("where", R"json(["abs(x)"])json"));
  malformed("form.ranges", transition("to", "2"));
  malformed("form.ranges", transition("to", "0"));
  malformed("form.formula", transition("map", R"json(["x/sqrt(x^2+y^2)","y"])json"));
  malformed("form.formula", transition("map", R"json(["x/(y-y)","y"])json"));
  malformed("form.formula", transition("map", R"(["x"])"));
  malformed("form.formula", transition("map", R"(["u","y"])"));
  malformed("form.formula", transition("where", R"(["1/x"])"));
  malformed("form.formula", [](Json& j) { j["manifold"]["charts"][0]["variables"] = Json::parse(R"(["x","x"])"); });
  malformed("form.ranges", [](Json& j) { j["manifold"]["charts"][0]["domain"][1][0] = "2"; });
  malformed("form.ranges", [](Json& j) { j["manifold"]["charts"][0]["core"][1][0] = "-2"; });
  malformed("form.ranges", [](Json& j) { j["manifold"]["patch_radius"] = "0"; });
  malformed("form.family", [](Json& j) { j["parameters"]["mode"] = "theory"; });
}

}  // namespace

std::vector<Forgery> atlas_forgeries() {
  const auto scale = [](Json& stated, const Rational& by) {
    stated = exact_text(parse_exact(stated.get<std::string>()) * by);
  };
  const auto forged = [](const char* name, const char* rule, const Json& valid,
                         const std::function<void(Json&)>& change) {
    Json document = valid;
    change(document);
    return Forgery{name, rule, sealed(document)};
  };
  const std::string little = "1/1000000000000000000000000000000";
  return {forged("an inverse that is wrong in its thirtieth digit", "atlas.inverse", sphere_document(),
                 [&](Json& j) { j["manifold"]["transitions"][0]["inverse"][0] = "u/(u^2+v^2)+" + little; }),
          forged("one transition of the torus that is a little off", "atlas.cocycle", torus_document(),
                 [&](Json& j) {
                   Json& transition = j["manifold"]["transitions"][0];
                   transition["map"][0] = "x+" + little;
                   transition["inverse"][0] = "x-" + little;
                 }),
          forged("a ring where charts are not glued", "atlas.hausdorff", sphere_document(), leave_out_a_ring),
          forged("cores that leave a ring between them", "atlas.compact", sphere_document(),
                 [](Json& j) {
                   for (Json& chart : j["manifold"]["charts"])
                     chart["core"] = Json::parse(R"([["-9/10","9/10"],["-9/10","9/10"]])");
                 }),
          forged("cones whose sides no core holds", "atlas.compact", cone_document(),
                 [](Json& j) {
                   for (Json& chart : j["manifold"]["charts"])
                     chart["core"] = Json::parse(R"([["-1/8","1/8"],["-1/8","1/8"]])");
                 }),
          forged("patches that reach beyond their boxes", "atlas.patch", sphere_document(),
                 [](Json& j) {
                   j["parameters"]["distortion"] = "1000000";
                   j["manifold"]["patch_radius"] = "2";
                 }),
          forged("blends that fold less than they do", "5.blend", sphere_document(),
                 [](Json& j) {
                   Json& stated = j["levels"]["5"]["contraction"];
                   stated = exact_text(parse_exact(stated.get<std::string>()) * ratio(1, 64));
                 }),
          forged("folds that blends do not show", "5.blend", cone_document(),
                 [](Json& j) {
                   Json& stated = j["levels"]["5"]["displacement"];
                   stated = exact_text(parse_exact(stated.get<std::string>()) * ratio(1, 2));
                 }),
          // In charts that show nearly all of the torus.
          forged("simplices moved so far that they may meet every point", "5.clear", torus_document(),
                 [](Json& j) {
                   j["levels"]["5"]["displacement"] = "1000";
                   for (Json& chart : j["manifold"]["charts"]) {
                     for (Json& side : chart["domain"])
                       side = side[0] == "1/16" ? Json::parse(R"(["1/1000","999/1000"])")
                                                : Json::parse(R"(["-499/1000","499/1000"])");
                   }
                 }),
          forged("a sphere more than there are simplices of", "5.components", sphere_document(),
                 [](Json& j) {
                   Json& charts = j["manifold"]["charts"];
                   for (int k = 0; k < 2; ++k) charts.push_back(Json(charts[static_cast<std::size_t>(k)]));
                   Json other = j["manifold"]["transitions"][0];
                   other["from"] = 2;
                   other["to"] = 3;
                   j["manifold"]["transitions"].push_back(other);
                 }),
          forged("half the distortion of transitions", "atlas.distortion", sphere_document(),
                 [&](Json& j) { scale(j["parameters"]["distortion"], ratio(1, 2)); }),
          forged("eight times the protection in charts", "1.protection", sphere_document(),
                 [&](Json& j) { scale(j["levels"]["1"]["protection"], Rational(8)); }),
          forged("nine tenths of the circumradius in charts", "1.radius", sphere_document(),
                 [&](Json& j) { scale(j["levels"]["1"]["circumradius"], ratio(9, 10)); }),
          forged("twice the thickness in charts", "1.thickness", sphere_document(),
                 [&](Json& j) { scale(j["levels"]["1"]["thickness"], Rational(2)); }),
          forged("balls that leave the charts", "1.patch", sphere_document(),
                 [&](Json& j) { scale(j["levels"]["1"]["circumradius"], Rational(4)); }),
          forged("balls smaller than any triangle", "1.vertices", sphere_document(),
                 [&](Json& j) { scale(j["levels"]["1"]["circumradius"], ratio(1, 16)); }),
          forged("points moved farther than stated", "1.perturbation", sphere_document(),
                 [&](Json& j) { scale(j["parameters"]["perturbation"], ratio(1, 2)); }),
          forged("a triangle missing", "1.facets", sphere_document(), [](Json& j) {
            for (const char* level : {"2s", "5"}) j["levels"].erase(level);
            j["simplices"].erase(4);
            j["levels"]["2"]["simplices"] = j["simplices"].size();
            j["levels"]["2"]["euler_characteristic"] = 1;
            j["levels"]["2"].erase("homology");
          })};
}

}  // namespace delcert::checker_tests
