#include "kernel/formula/formula_graph.hpp"

#include <gtest/gtest.h>

#include "kernel/formula/formula_error.hpp"
#include "kernel/formula/plain_formula.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

using Node = FormulaGraph::Node;
const std::vector<std::string> variables{"x", "y"};

struct Graph : FormulaGraph {
  Node node(std::string_view text) { return add_formula(*parse_plain_formula(text, variables), variables); }
};

TEST(FormulaGraph, has_once_what_is_the_same) {
  Graph graph;
  EXPECT_EQ(graph.node("x*y + exp(x*y)"), graph.node("exp(y*x) + y*x"));
  EXPECT_EQ(graph.node("x*x"), graph.node("x^2"));
  EXPECT_EQ(graph.node("2*(3*x)"), graph.node("x*6"));
  EXPECT_EQ(graph.node("-(-x)"), graph.node("x"));
  EXPECT_EQ(graph.node("(-x)^2"), graph.node("x^2"));
  EXPECT_EQ(graph.node("x/2"), graph.node("1/2*x"));
  EXPECT_NE(graph.node("x - y"), graph.node("y - x"));
  EXPECT_NE(graph.node("x/y"), graph.node("y/x"));
  EXPECT_NE(graph.node("sin(x)"), graph.node("cos(x)"));
}

TEST(FormulaGraph, works_out_constants) {
  Graph graph;
  EXPECT_TRUE(graph.is_zero(graph.node("0*x + x - x")));
  EXPECT_EQ(graph[graph.node("(1/2 + 1/3)^2*6")].value, Rational(25) / Rational(6));
  EXPECT_EQ(graph.node("x^0"), graph.node("1"));
  EXPECT_EQ(graph.node("x^1"), graph.node("x"));
  EXPECT_FALSE(graph.is_zero(graph.node("x - y")));
}

TEST(FormulaGraph, differentiates_by_the_rules) {
  Graph graph;
  const auto check = [&](std::string_view text, std::string_view by_x) {
    EXPECT_EQ(graph.derivative(graph.node(text), 0), graph.node(by_x)) << text;
  };
  check("7", "0");
  check("y^3", "0");
  check("x", "1");
  check("x^5", "5*x^4");
  check("x*y - 3*x", "y - 3");
  check("-x", "-1");
  check("sin(3*x)", "3*cos(3*x)");
  check("cos(3*x)", "-(3*sin(3*x))");
  check("exp(2*x)", "2*exp(2*x)");
  check("sqrt(x)", "1/(2*sqrt(x))");
  check("x/y", "1/y");
  check("1/x", "(0 - 1/x*1)/x");
  EXPECT_NE(graph.derivative(graph.node("x^5"), 0), graph.node("x^4"));
}

TEST(FormulaGraph, remembers_what_has_to_be_defined) {
  Graph graph;
  (void)graph.node("0*sqrt(x) + 0/y + x^2");
  ASSERT_EQ(graph.partial_nodes().size(), 2);
  EXPECT_EQ(graph[graph.partial_nodes()[0]].step, FormulaStep::root);
  EXPECT_EQ(graph[graph.partial_nodes()[1]].step, FormulaStep::divide);
  (void)graph.node("x/3 + exp(y)");
  EXPECT_EQ(graph.partial_nodes().size(), 2);
}

TEST(FormulaGraph, refuses_what_is_defined_nowhere) {
  Graph graph;
  EXPECT_THROW((void)graph.node("x/(1 - 1)"), FormulaError);
  EXPECT_THROW((void)graph.node("sqrt(2 - 3)"), FormulaError);
  EXPECT_THROW((void)graph.node("sqrt(0)"), FormulaError);
  EXPECT_NO_THROW((void)graph.node("x/(2 - 1) + sqrt(3 - 2)"));
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
