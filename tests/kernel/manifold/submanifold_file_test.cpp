#include "kernel/manifold/submanifold_file.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>

#include "kernel/number/rounding_guard.hpp"
#include "kernel/number/scalar.hpp"
#include "support/error.hpp"
#include "tests/support/message_of.hpp"
#include "tests/support/ratio.hpp"
#include "tests/support/temporary_folder.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

/// A file of which each line can be another.
struct Text {
  std::string name = "name = 'sphere'";
  std::string family = "family = 'submanifold'";
  std::string dimension = "dimension = 2";
  std::string variables = "variables = ['x', 'y', 'z']";
  std::string equations = "equations = ['x^2 + y^2 + z^2 - 1']";
  std::string box = "box = [[-2, 2], ['-3/2', 2], [-2, 2]]";
  std::string homology;

  [[nodiscard]] std::string whole() const {
    std::string result;
    for (const std::string& line : {name, family, dimension, variables, equations, box, homology})
      result += line + "\n";
    return result;
  }
};

std::string refusal(const Text& text) {
  return message_of<InputError>([&] { (void)parse_submanifold(text.whole(), "x.toml"); });
}
std::string refusal_of_equation(const std::string& equation) {
  Text text;
  text.equations = "equations = ['" + equation + "']";
  return refusal(text);
}
std::string refusal_with(std::string Text::*line, const std::string& value) {
  Text text;
  text.*line = value;
  return refusal(text);
}

TEST(SubmanifoldFile, reads_all_that_it_has) {
  Text text;
  text.homology = "homology = ['Z', '0', 'Z']";
  const SubmanifoldDescription sphere = parse_submanifold(text.whole(), "x.toml");
  EXPECT_EQ(sphere.name, "sphere");
  EXPECT_EQ(sphere.dimension, Dimension(2));
  EXPECT_EQ(sphere.variables, (std::vector<std::string>{"x", "y", "z"}));
  EXPECT_EQ(sphere.equations, (std::vector<std::string>{"x^2+y^2+z^2-1"}));
  EXPECT_EQ(sphere.box[1][0], ratio(-3, 2));
  EXPECT_EQ(sphere.box[1][1], Rational(2));
  EXPECT_EQ(sphere.homology, (std::vector<std::string>{"Z", "0", "Z"}));
  EXPECT_TRUE(parse_submanifold(Text().whole(), "x.toml").homology.empty());
}

TEST(SubmanifoldFile, reads_curves_in_the_plane_and_in_space) {
  Text circle;
  circle.dimension = "dimension = 1";
  circle.variables = "variables = ['x', 'y']";
  circle.equations = "equations = ['x^2 + y^2 - 1']";
  circle.box = "box = [[-2, 2], [-2, 2]]";
  circle.homology = "homology = ['Z', 'Z']";
  EXPECT_EQ(parse_submanifold(circle.whole(), "x.toml").dimension, Dimension(1));
  Text curve;
  curve.dimension = "dimension = 1";
  curve.equations = "equations = ['x^2 + y^2 - 1', 'z - x*y']";
  EXPECT_EQ(parse_submanifold(curve.whole(), "x.toml").equations.size(), 2U);
  EXPECT_TRUE(mentions(refusal_with(&Text::dimension, "dimension = 1"), "expected an array of 2 formulas"));
}

TEST(SubmanifoldFile, shows_what_is_wrong_within_an_equation) {
  const std::string start = "x.toml:5:";
  EXPECT_EQ(refusal_of_equation("x^2 + w - 1"), start + "21: unknown variable w");
  EXPECT_EQ(refusal_of_equation("x^2 + * y"), start + "21: '*' where a number, a name or ( was expected");
  EXPECT_EQ(refusal_of_equation("x^2 + (y"), start + "23: the end where an operator or ) was expected");
  EXPECT_EQ(refusal_of_equation("x^y"), start + "17: an exponent is a whole number from 0 to 100");
  EXPECT_EQ(refusal_of_equation("x^(1/2) - y"), start + "19: an exponent is a whole number from 0 to 100");
  EXPECT_EQ(refusal_of_equation("x^2^3"), start + "18: an exponent is a whole number from 0 to 100");
  EXPECT_EQ(refusal_of_equation("x^2 + y^2 = 1"),
            start + "25: a comparison where a real function was expected: for a = b write a - b");
  EXPECT_EQ(refusal_of_equation("x/(1 - 1)"), start + "16: a division by 0");
  EXPECT_EQ(refusal_of_equation("x + sqrt(2 - 3)"), start + "19: the root of a number that is not positive");
  EXPECT_TRUE(mentions(refusal_of_equation("x + 0.5"), start + "20: a decimal number"));
  EXPECT_TRUE(mentions(refusal_of_equation("x + tan(y)"), start + "19: unknown function tan"));
  EXPECT_TRUE(mentions(refusal_of_equation("forall k in 1 .. 2: x"), "a statement where a real function was expected"));
  EXPECT_TRUE(mentions(refusal_of_equation(""), start + "15: the end where"));
  EXPECT_TRUE(mentions(refusal_of_equation(std::string(4097, ' ') + "x"), "a string of at most 4096 bytes"));
}

TEST(SubmanifoldFile, says_what_is_wrong_elsewhere_and_where) {
  EXPECT_TRUE(mentions(refusal_with(&Text::variables, "variables = ['x', 'sin', 'z']"),
                       "x.toml:4:19: variable 2: found \"sin\", expected a name"));
  EXPECT_TRUE(mentions(refusal_with(&Text::variables, "variables = ['x', 'Y', 'z']"), "variable 2: found \"Y\""));
  EXPECT_TRUE(mentions(refusal_with(&Text::variables, "variables = ['x', 'x', 'z']"),
                       "x.toml:4:19: variable 2: found \"x\", expected another name: this one is taken"));
  EXPECT_TRUE(mentions(refusal_with(&Text::variables, "variables = ['x']"), "expected an array of 2 to 9 names"));
  EXPECT_TRUE(mentions(refusal_with(&Text::variables, "variables = 'xy'"), "expected an array of 2 to 9 names"));
  EXPECT_TRUE(
      mentions(refusal_with(&Text::dimension, "dimension = 3"),
               "x.toml:3:13: key \"dimension\": found the integer 3, expected less than the number of variables, 3"));
  EXPECT_TRUE(mentions(refusal_with(&Text::dimension, "dimension = 4"), "expected an integer from 1 to 3"));
  EXPECT_TRUE(mentions(refusal_with(&Text::equations, "equations = ['x', 'y']"),
                       "x.toml:5:13: key \"equations\": found an array of length 2, expected an array of 1 formulas"));
  EXPECT_TRUE(mentions(refusal_with(&Text::equations, "equations = [3]"), "equation 1: found the integer 3"));
  EXPECT_TRUE(mentions(refusal_with(&Text::box, "box = [[-2, 2]]"), "expected an array of 3 pairs of numbers"));
  EXPECT_TRUE(mentions(refusal_with(&Text::box, "box = [[-2, 2], [1], [1, 2]]"), "box, y: found an array of length 1"));
  EXPECT_TRUE(mentions(refusal_with(&Text::box, "box = [[-2, 2], [1, 1], [1, 2]]"),
                       "x.toml:6:21: box, y, to: found the integer 1, expected a number above 1"));
  EXPECT_TRUE(
      mentions(refusal_with(&Text::box, "box = [[2, -2], [1, 2], [1, 2]]"), "box, x, to: found the integer -2"));
  EXPECT_TRUE(mentions(refusal_with(&Text::box, "box = [[-2, 2.5], [1, 2], [1, 2]]"), "the floating-point number 2.5"));
  EXPECT_TRUE(mentions(refusal_with(&Text::box, ""), "the key box is missing, expected an array of 3 pairs"));
  EXPECT_TRUE(mentions(refusal_with(&Text::homology, "homology = ['Z']"), "expected an array of 3 groups"));
  EXPECT_TRUE(
      mentions(refusal_with(&Text::homology, "homology = ['Z', 1, 'Z']"), "homology, degree 1: found the integer 1"));
  EXPECT_TRUE(mentions(refusal_with(&Text::homology, "homology = ['Z', 'Y', 'Z']"), "expected a group such as"));
  EXPECT_TRUE(mentions(refusal_with(&Text::homology, "homolgy = []"), "unknown key homolgy, did you mean homology?"));
  EXPECT_TRUE(mentions(refusal_with(&Text::family, "family = 'submanifolds'"), "expected \"submanifold\""));
  EXPECT_EQ(refusal(Text()), "accepted");
}

TEST(SubmanifoldFile, reads_a_mesh_from_its_own_folder) {
  const test::TemporaryFolder folder;
  std::ofstream(folder / "part.off")
      << "OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 0.5\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n";
  const std::string head = "name = 'part'\nfamily = 'submanifold'\n";
  const auto parse = [&](const std::string& text) {
    return parse_submanifold(head + text, (folder / "x.toml").string());
  };
  const auto refusal_of = [&](const std::string& text) { return message_of<InputError>([&] { (void)parse(text); }); };
  const SubmanifoldDescription part = parse("dimension = 2\nmesh = 'part.off'\nhomology = ['Z', '0', 'Z']\n");
  ASSERT_TRUE(part.mesh);
  EXPECT_EQ(part.mesh->triangles.size(), 4U);
  EXPECT_EQ(part.mesh->points[3][2], ratio(1, 2));
  EXPECT_TRUE(part.equations.empty());
  const auto embedded = embedded_manifold(part);
  EXPECT_EQ(embedded->name(), "part");
  EXPECT_EQ(embedded->dimension(), 2U);
  EXPECT_FALSE(embedded->is_smooth());
  EXPECT_TRUE(embedded_manifold(parse_submanifold(Text().whole(), "x.toml"))->is_smooth());

  EXPECT_NE(refusal_of("dimension = 2\nmesh = 'other.off'\n").find("cannot be read"), std::string::npos);
  EXPECT_NE(refusal_of("dimension = 3\nmesh = 'part.off'\n").find("expected 2: a mesh"), std::string::npos);
  EXPECT_NE(refusal_of("dimension = 2\nmesh = 'part.off'\nbox = []\n").find("unknown key box"), std::string::npos);
  std::ofstream(folder / "part.off") << "OFF\n4 4 0\n";
  EXPECT_NE(refusal_of("dimension = 2\nmesh = 'part.off'\n"), "accepted");
}

TEST(SubmanifoldFile, of_every_built_in_zero_set_is_in_order) {
  ASSERT_GE(builtin_submanifolds().size(), 10U);
  for (const BuiltinManifold& builtin : builtin_submanifolds()) {
    const SubmanifoldDescription manifold = parse_submanifold(builtin.text, builtin.name);
    EXPECT_EQ(manifold.name, builtin.name);
    EXPECT_EQ(manifold.homology.size(), static_cast<std::size_t>(manifold.dimension.value) + 1);
    EXPECT_NO_THROW((void)ZeroSet(manifold));
  }
}

TEST(SubmanifoldFile, of_every_built_in_zero_set_has_its_points_inside_of_its_box) {
  // On every side of the box some equation has no zero, cell by cell.
  const RoundingGuard guard;
  for (const BuiltinManifold& builtin : builtin_submanifolds()) {
    const SubmanifoldDescription manifold = parse_submanifold(builtin.text, builtin.name);
    const FormulaMap map(manifold.variables, manifold.equations);
    FormulaEvaluation<Interval> evaluation(map);
    const std::size_t n = manifold.variables.size();
    for (std::size_t side = 0; side < 2 * n; ++side) {
      std::vector<std::vector<Interval>> open{{}};
      for (std::size_t axis = 0; axis < n; ++axis) {
        const Interval from = scalar_from<Interval>(manifold.box[axis][0]);
        const Interval to = scalar_from<Interval>(manifold.box[axis][1]);
        open[0].push_back(axis != side / 2 ? Interval::between(from.lower(), to.upper()) : side % 2 == 0 ? from : to);
      }
      std::size_t looked_at = 0;
      while (!open.empty()) {
        ASSERT_LT(++looked_at, 300000U) << builtin.name << ", side " << side;
        const std::vector<Interval> cell = open.back();
        open.pop_back();
        std::vector<Interval> f(map.function_count());
        ASSERT_TRUE(evaluation.value(cell.data(), f.data()));
        if (std::any_of(f.begin(), f.end(), [](const Interval& value) { return is_refuted(is_zero(value)); })) continue;
        std::size_t widest = 0;
        const auto width = [&](std::size_t axis) { return cell[axis].upper() - cell[axis].lower(); };
        for (std::size_t axis = 1; axis < n; ++axis) widest = width(axis) > width(widest) ? axis : widest;
        const double middle = (cell[widest].lower() + cell[widest].upper()) / 2;
        for (const bool is_upper : {false, true}) {
          open.push_back(cell);
          open.back()[widest] = is_upper ? Interval::between(middle, cell[widest].upper())
                                         : Interval::between(cell[widest].lower(), middle);
        }
      }
    }
  }
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
