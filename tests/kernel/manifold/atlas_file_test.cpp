#include "kernel/manifold/atlas_file.hpp"

#include <gtest/gtest.h>

#include "support/error.hpp"
#include "tests/support/message_of.hpp"
#include "tests/support/ratio.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

const std::string head = "name = \"s\"\nfamily = \"atlas\"\ndimension = 2\n";
const std::string north =
    "[[charts]]\nname = \"n\"\nvariables = [\"x\", \"y\"]\ndomain = [[-2, 2], [\"-2\", \"0x1p1\"]]\n";
const std::string south = "[[charts]]\nname = \"s\"\nvariables = [\"u\", \"v\"]\ndomain = [[-2, 2], [-2, 2]]\n";
const std::string join = "[[transitions]]\nfrom = \"n\"\nto = \"s\"\n";
const std::string map = "map = [\"x/(x^2 + y^2)\", \"y/(x^2+y^2)\"]\n";
const std::string inverse = "inverse = [\"u/(u^2 + v^2)\", \"v/(u^2 + v^2)\"]\n";
const std::string sphere = head + north + south + join + map + inverse;

std::string refusal(const std::string& text) {
  return message_of<InputError>([&] { (void)parse_atlas(text, "x.toml"); });
}

TEST(AtlasFile, reads_charts_and_transitions) {
  const auto atlas = parse_atlas(sphere + "where = [\"x + 3\"]\n", "x.toml");
  EXPECT_EQ(atlas.name, "s");
  EXPECT_EQ(atlas.dimension, Dimension(2));
  ASSERT_EQ(atlas.charts.size(), 2U);
  EXPECT_EQ(atlas.charts[1].variables, (std::vector<std::string>{"u", "v"}));
  EXPECT_EQ(atlas.charts[0].domain[1][1], Rational(2));
  // By default each side is an eighth shorter.
  EXPECT_EQ(atlas.charts[0].core[0][0], ratio(-7, 4));
  EXPECT_EQ(atlas.charts[0].core[1][1], ratio(7, 4));
  ASSERT_EQ(atlas.transitions.size(), 1U);
  EXPECT_EQ(atlas.transitions[0].from, 0U);
  EXPECT_EQ(atlas.transitions[0].to, 1U);
  EXPECT_EQ(atlas.transitions[0].map[1], "y/(x^2+y^2)");
  EXPECT_EQ(atlas.transitions[0].where, (std::vector<std::string>{"x+3"}));
  EXPECT_TRUE(atlas.homology.empty());
  EXPECT_TRUE(parse_atlas(sphere, "x.toml").transitions[0].where.empty());
  const auto with_core = parse_atlas(head + "homology = [\"Z\", \"0\", \"Z\"]\n" + north +
                                         "core = [[-1, 1], [\"-1/2\", 1]]\n" + south + join + map + inverse,
                                     "x.toml");
  EXPECT_EQ(with_core.charts[0].core[1][0], ratio(-1, 2));
  EXPECT_EQ(with_core.homology[1], "0");
}

TEST(AtlasFile, says_what_is_wrong_and_where) {
  EXPECT_TRUE(mentions(refusal("name = \n"), "x.toml:1:8: not TOML"));
  EXPECT_EQ(refusal("name = \"x\"\n"), "x.toml:1:1: the key family is missing");
  EXPECT_TRUE(mentions(refusal("family = \"torus\"\n"), "x.toml:1:10: key \"family\": found \"torus\", expected"));
  EXPECT_TRUE(mentions(refusal("name = \"s\"\nfamily = \"atlas\"\ndimension = 4\n"),
                       "x.toml:3:13: key \"dimension\": found the integer 4, expected an integer from 2 to 3"));
  EXPECT_TRUE(mentions(refusal(head + "cores = 1\n"), "x.toml:4:1: unknown key cores"));
  EXPECT_TRUE(mentions(refusal(head), "the key charts is missing"));
  EXPECT_TRUE(
      mentions(refusal(head + "charts = [1]\n"), "x.toml:4:11: chart 1: found the integer 1, expected a table"));
  EXPECT_TRUE(
      mentions(refusal(head + "charts = []\n"), "found an array of length 0, expected an array of 1 to 64 tables"));
  EXPECT_TRUE(mentions(refusal(head + north), "the key transitions is missing"));
  EXPECT_TRUE(mentions(refusal(head + "homology = [\"Z\"]\n" + north + south + join + map + inverse),
                       "found an array of length 1, expected an array of 3 groups"));
  EXPECT_TRUE(mentions(refusal(head + "homology = [\"Z\", 0, \"Z\"]\n" + north + south + join + map + inverse),
                       "x.toml:4:18: homology, degree 1: found the integer 0"));
}

std::string refusal_of_chart(const std::string& lines) {
  return refusal(head + "[[charts]]\nname = \"n\"\n" + lines + south + join + map + inverse);
}

TEST(AtlasFile, says_what_is_wrong_with_a_chart) {
  const std::string variables = "variables = [\"x\", \"y\"]\n";
  EXPECT_TRUE(mentions(refusal(head + north + north), "chart 2: found \"n\", expected another name"));
  EXPECT_TRUE(mentions(refusal_of_chart("variables = [\"x\"]\n"), "chart 1, variables: found an array of length 1"));
  EXPECT_TRUE(
      mentions(refusal_of_chart("variables = [\"x\", \"Y\"]\n"), "x.toml:6:19: chart 1, variables: found \"Y\""));
  EXPECT_TRUE(mentions(refusal_of_chart("variables = [\"x\", \"sin\"]\n"), "expected a name"));
  EXPECT_TRUE(mentions(refusal_of_chart("variables = [\"x\", \"x\"]\n"), "found \"x\", expected another name"));
  EXPECT_TRUE(
      mentions(refusal_of_chart(variables + "domain = [[-2, 2]]\n"), "chart 1, domain: found an array of length 1"));
  EXPECT_TRUE(mentions(refusal_of_chart(variables + "domain = [[-2, 2], [1, 2, 3]]\n"),
                       "chart 1, domain, y: found an array of length 3, expected a pair of numbers"));
  EXPECT_TRUE(mentions(refusal_of_chart(variables + "domain = [[-2, 2], [1, 1]]\n"),
                       "x.toml:7:24: chart 1, domain, y, to: found the integer 1, expected a number above 1"));
  EXPECT_TRUE(mentions(refusal_of_chart(variables + "domain = [[-2, 2], [1, 1.5]]\n"),
                       "chart 1, domain, y, to: found the floating-point number 1.5, expected an exact number"));
  EXPECT_TRUE(mentions(refusal_of_chart(variables + "domain = [[-2, 2], [1, 2]]\ncore = [[-1, 1], [1, \"3/2\"]]\n"),
                       "chart 1, core, y: found an array of length 2, expected a side strictly inside"));
  EXPECT_TRUE(mentions(refusal_of_chart(variables + "box = 1\n"), "unknown key box"));
}

std::string refusal_of_transition(const std::string& lines) { return refusal(head + north + south + lines); }

TEST(AtlasFile, says_what_is_wrong_with_a_transition) {
  EXPECT_TRUE(mentions(refusal_of_transition("[[transitions]]\nfrom = \"m\"\nto = \"s\"\n"),
                       "x.toml:13:8: transition 1, from: found \"m\", expected the name of a chart"));
  EXPECT_TRUE(mentions(refusal_of_transition("[[transitions]]\nfrom = \"n\"\nto = \"n\"\n"),
                       "transition 1, to: found \"n\", expected another chart"));
  EXPECT_TRUE(mentions(refusal_of_transition(join + "map = [\"x\"]\n" + inverse),
                       "transition 1, map: found an array of length 1, expected an array of 2 formulas"));
  EXPECT_TRUE(mentions(refusal_of_transition(join + "map = [\"x\", 3]\n" + inverse),
                       "transition 1, map, formula 2: found the integer 3, expected a string"));
  EXPECT_TRUE(mentions(refusal_of_transition(join + "map = [\"x\", \"y + u\"]\n" + inverse),
                       "x.toml:15:18: unknown variable u"));
  EXPECT_TRUE(mentions(refusal_of_transition(join + "map = [\"x\", \"y +\"]\n" + inverse), "x.toml:15:"));
  EXPECT_TRUE(mentions(refusal_of_transition(join + "map = [\"x\", \"y/(1 - 1)\"]\n" + inverse), "a division by 0"));
  EXPECT_TRUE(
      mentions(refusal_of_transition(join + "map = [\"x\", \"y^x\"]\n" + inverse), "an exponent is a whole number"));
  EXPECT_TRUE(mentions(refusal_of_transition(join + map), "the key inverse is missing"));
  EXPECT_TRUE(mentions(refusal_of_transition(join + map + inverse + "where = []\n"),
                       "transition 1, where: found an array of length 0"));
  EXPECT_TRUE(mentions(refusal_of_transition(join + map + inverse + "wher = [\"x\"]\n"), "unknown key wher"));
}

TEST(AtlasFile, built_in_atlases_are_known_by_their_names) {
  ASSERT_GE(builtin_atlases().size(), 6U);
  for (const auto& builtin : builtin_atlases()) {
    const auto atlas = parse_atlas(builtin.text, builtin.name);
    EXPECT_EQ(atlas.name, builtin.name);
    EXPECT_EQ(atlas.homology.size(), static_cast<std::size_t>(atlas.dimension.value) + 1);
  }
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
