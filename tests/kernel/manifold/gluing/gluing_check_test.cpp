#include "kernel/manifold/gluing/gluing_check.hpp"

#include <gtest/gtest.h>

#include "tests/kernel/manifold/gluing/atlas_samples.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

/// "" if it is an atlas; what is thrown otherwise.
std::string verdict(const FormulaAtlasDescription& description) {
  try {
    (void)check_gluing(ChartGluing(description));
    return "";
  } catch (const Rejection& rejection) {
    return std::string("rejected: ") + rejection.what();
  } catch (const Undecided& undecided) {
    return std::string("undecided: ") + undecided.what();
  }
}

TEST(GluingCheck, accepts_all_that_is_built_in) {
  for (const auto& builtin : builtin_atlases()) {
    const ChartGluing gluing(parse_atlas(builtin.text, builtin.name));
    const GluingReport report = check_gluing(gluing);
    EXPECT_GE(report.hausdorff_cells, gluing.transitions().size() / 2) << builtin.name;
    EXPECT_GE(report.compact_cells, gluing.chart_count()) << builtin.name;
    EXPECT_LE(report.cocycle_cells + report.hausdorff_cells + report.compact_cells, 200000U) << builtin.name;
  }
}

TEST(GluingCheck, refuses_a_chain_that_no_transition_closes) {
  auto torus = atlas_named("torus-2-by-charts");
  ASSERT_EQ(verdict(torus), "");
  // One transition is not listed, so that two others, one after the other, do what none does.
  const auto missing = torus.transitions[4];
  torus.transitions.erase(torus.transitions.begin() + 4);
  EXPECT_TRUE(mentions(verdict(torus), "rejected: torus-2-by-charts: atlas.cocycle: ")) << verdict(torus);
  EXPECT_TRUE(mentions(verdict(torus), ": no transition does the same; chart ")) << verdict(torus);
  // One is wrong in one place.
  torus.transitions.push_back(missing);
  torus.transitions.back().map[0] += " + 1/1000000";
  torus.transitions.back().inverse[0] += " - 1/1000000";
  EXPECT_TRUE(mentions(verdict(torus), "rejected: torus-2-by-charts: atlas.cocycle: ")) << verdict(torus);
}

TEST(GluingCheck, refuses_transitions_that_identify_points_of_one_chart) {
  // Both are right for themselves: together they take x to x + 1/4 in the chart.
  auto description = two_charts(Rational(2), Rational(1), {0, 1, {"x", "y"}, {"u", "v"}, {}});
  description.transitions.push_back({0, 1, {"x + 1/4", "y"}, {"u - 1/4", "v"}, {}});
  EXPECT_TRUE(mentions(verdict(description), "rejected: two: atlas.cocycle: ")) << verdict(description);
}

TEST(GluingCheck, sees_that_a_condition_keeps_transitions_apart) {
  auto description = two_charts(Rational(2), Rational(1), {0, 1, {"x", "y"}, {"u", "v"}, {"x - 1"}});
  description.transitions.push_back({0, 1, {"x + 1/4", "y"}, {"u - 1/4", "v"}, {"-x - 1"}});
  // No chain is wrong, but the two pieces are cut off in the middle of both charts.
  EXPECT_TRUE(mentions(verdict(description), "undecided: two: atlas.hausdorff: ")) << verdict(description);
  description.transitions[1].where = {"x - 1"};
  EXPECT_TRUE(mentions(verdict(description), "rejected: two: atlas.cocycle: ")) << verdict(description);
}

TEST(GluingCheck, does_not_take_a_plane_with_two_origins) {
  // Two squares glued to one another without their centres.
  auto description = two_charts(Rational(2), Rational(1), {0, 1, {"x", "y"}, {"u", "v"}, {"x^2 + y^2"}});
  const std::string found = verdict(description);
  EXPECT_TRUE(mentions(found, "undecided: two: atlas.hausdorff: transition 1, from n to s: ")) << found;
  EXPECT_TRUE(mentions(found, "; chart n: x in [")) << found;
  EXPECT_TRUE(mentions(found, "; chart s: u in [")) << found;
  // And along a line.
  description.transitions[0].where = {"x - 1/3"};
  EXPECT_TRUE(mentions(verdict(description), "undecided: two: atlas.hausdorff: ")) << verdict(description);
  // With them they are one square, which is not compact.
  description.transitions[0].where = {};
  EXPECT_TRUE(mentions(verdict(description), "rejected: two: atlas.compact: ")) << verdict(description);
}

TEST(GluingCheck, does_not_take_a_map_that_is_not_injective) {
  // (x, xy): the line x = 0 goes to a point of the other chart, and the points near it come together.
  const auto description = two_charts(Rational(2), Rational(1), {0, 1, {"x", "x*y"}, {"u", "v/u"}, {}});
  EXPECT_TRUE(mentions(verdict(description), "undecided: two: atlas.hausdorff: ")) << verdict(description);
}

TEST(GluingCheck, refuses_cores_that_do_not_cover) {
  EXPECT_EQ(verdict(two_charts(Rational(2), ratio(3, 2), inversion())), "");
  // Points between the cores are in none.
  const std::string found = verdict(two_charts(Rational(2), ratio(9, 10), inversion()));
  EXPECT_TRUE(mentions(found, "rejected: two: atlas.compact: no core holds these points; chart n: x in [")) << found;
  // Nor is anything beyond a chart that is too small.
  auto open = two_charts(Rational(2), ratio(3, 2), inversion());
  open.charts[1].domain = Sides(2, {ratio(-2, 5), ratio(2, 5)});
  open.charts[1].core = Sides(2, {ratio(-1, 3), ratio(1, 3)});
  EXPECT_TRUE(mentions(verdict(open), "rejected: two: atlas.compact: ")) << verdict(open);
}

/// Where the atlas has the transition between these charts for the k-th time.
FormulaAtlasDescription::Transition& transition(FormulaAtlasDescription& atlas, const std::string& from,
                                                const std::string& to, std::size_t k) {
  for (auto& one : atlas.transitions) {
    if (atlas.charts[one.from].name == from && atlas.charts[one.to].name == to && k-- == 0) return one;
  }
  throw std::logic_error("no transition");
}

TEST(GluingCheck, refuses_wrong_twins_of_a_cone_manifold) {
  const auto cone = atlas_named("cone-torus");
  EXPECT_EQ(verdict(cone), "");
  // One fold is a little off, on both sides of it: no other transitions do the same.
  auto wrong = cone;
  auto& moved = transition(wrong, "p", "e1", 0);
  moved.map[0] += " + 1/1000000";
  for (std::string& formula : moved.inverse) {
    for (std::size_t at = formula.find('s'); at != std::string::npos; at = formula.find('s', at + 15)) {
      if (at == 0 || formula[at - 1] != 'b') formula.replace(at, 1, "(s - 1/1000000)");
    }
  }
  EXPECT_TRUE(mentions(verdict(wrong), "rejected: cone-torus: atlas.cocycle: ")) << verdict(wrong);
  // Charts of cone points are too small: nothing else shows points of sides near them.
  wrong = cone;
  for (auto& chart : wrong.charts) {
    if (chart.name == "p" || chart.name == "q") {
      chart.domain = Sides(2, {ratio(-1, 5), ratio(1, 5)});
      chart.core = Sides(2, {ratio(-3, 16), ratio(3, 16)});
    }
  }
  EXPECT_TRUE(mentions(verdict(wrong), "rejected: cone-torus: atlas.compact: no core holds these points; chart "))
      << verdict(wrong);
  // Part of an overlap is not glued: its rim has two origins.
  wrong = cone;
  transition(wrong, "p", "e1", 0).where = {"1/4 - u^2 - v^2"};
  EXPECT_TRUE(mentions(verdict(wrong), "atlas.hausdorff: ") || mentions(verdict(wrong), "atlas.cocycle: "))
      << verdict(wrong);
}

TEST(GluingCheck, looks_at_each_side_of_a_fold) {
  // The second leads back from the first on one side of the fold only.
  const auto folds = [](const std::string& first, const std::string& back_of_first, const std::string& second,
                        const std::string& back_of_second) {
    auto description = two_charts(Rational(2), Rational(1), {0, 1, {first, "y"}, {back_of_first, "v"}, {}});
    description.charts.push_back(cube_chart("t", {"p", "q"}, Rational(2), Rational(1)));
    description.transitions.push_back({1, 2, {"u", "v"}, {"p", "q"}, {}});
    description.transitions.push_back({0, 2, {second, "y"}, {back_of_second, "q"}, {}});
    return verdict(description);
  };
  // Squares that are not compact: there is nothing else that is wrong.
  EXPECT_TRUE(mentions(folds("x + abs(y)/3", "u - abs(v)/3", "x + abs(y)/3", "p - abs(q)/3"), "atlas.compact"));
  EXPECT_TRUE(mentions(folds("x + abs(y)/3", "u - abs(v)/3", "x + y/3", "p - q/3"), "rejected: two: atlas.cocycle"));
  EXPECT_TRUE(mentions(folds("x + abs(y)/3", "u - abs(v)/3", "x - y/3", "p + q/3"), "rejected: two: atlas.cocycle"));
}

TEST(GluingCheck, does_not_take_a_fold_with_two_origins) {
  // Two squares glued to one another on one side of the line of the fold.
  const auto half = two_charts(Rational(2), Rational(1), {0, 1, {"x + abs(y)/3", "y"}, {"u - abs(v)/3", "v"}, {"y"}});
  EXPECT_TRUE(mentions(verdict(half), "undecided: two: atlas.hausdorff: ")) << verdict(half);
}

TEST(GluingCheck, says_where_it_cannot_decide) {
  // The cores touch along a circle: what lies there is in both, and in no cell certainly.
  auto description = two_charts(Rational(2), Rational(1),
                                {0, 1, {"x/(x^2 + y^2)", "y/(x^2 + y^2)"}, {"u/(u^2 + v^2)", "v/(u^2 + v^2)"}, {}});
  const std::string found = verdict(description);
  EXPECT_TRUE(mentions(found, "undecided: two: atlas.compact: that a core holds these points is not certain; chart n"))
      << found;
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
