#include "kernel/formula/parser.hpp"

#include <gtest/gtest.h>

#include <utility>

#include "kernel/formula/formula_error.hpp"
#include "kernel/formula/formula_text.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

/// The tree with every node in brackets.
std::string bracketed(const Expression& e) {
  if (e.operation == Operation::literal) return e.value.numerator().str();
  if (e.operation == Operation::name) return e.text;
  static const std::vector<std::string> signs{"",    "",    "",   "neg",     "+",      "-",     "*",
                                              "/",   "^",   "<",  "<=",      ">",      ">=",    "=",
                                              "not", "and", "or", "implies", "forall", "exists"};
  std::string result = "(" + (e.text.empty() ? "" : e.text + " ") + signs.at(static_cast<std::size_t>(e.operation));
  for (const auto& child : e.children) result += " " + bracketed(*child);
  return result + ")";
}

std::string tree(std::string_view text) { return bracketed(*parse_formula(text)); }

std::pair<std::size_t, std::string> error_of(std::string_view text) {
  try {
    (void)parse_formula(text);
  } catch (const FormulaError& error) {
    return {error.offset(), error.what()};
  }
  return {0, "accepted"};
}

TEST(Parser, precedence_of_terms) {
  EXPECT_EQ(tree("a + b*c"), "(+ a (* b c))");
  EXPECT_EQ(tree("a - b - c"), "(- (- a b) c)");
  EXPECT_EQ(tree("a/b/c"), "(/ (/ a b) c)");
  EXPECT_EQ(tree("a/b*c"), "(* (/ a b) c)");
  EXPECT_EQ(tree("-a^2"), "(neg (^ a 2))");
  EXPECT_EQ(tree("a^b^c"), "(^ a (^ b c))");
  EXPECT_EQ(tree("2^-1/2"), "(/ (^ 2 (neg 1)) 2)");
  EXPECT_EQ(tree("-a*b"), "(* (neg a) b)");
  EXPECT_EQ(tree("a*-b"), "(* a (neg b))");
  EXPECT_EQ(tree("a - -b"), "(- a (neg b))");
  EXPECT_EQ(tree("--a"), "(neg (neg a))");
  EXPECT_EQ(tree("(a + b)*c"), "(* (+ a b) c)");
}

TEST(Parser, precedence_of_statements) {
  EXPECT_EQ(tree("a < b and c < d or e < f"), "(or (and (< a b) (< c d)) (< e f))");
  EXPECT_EQ(tree("not a < b and c = d"), "(and (not (< a b)) (= c d))");
  EXPECT_EQ(tree("not not p"), "(not (not p))");
  EXPECT_EQ(tree("p implies q implies r"), "(implies p (implies q r))");
  EXPECT_EQ(tree("p or q implies r and s"), "(implies (or p q) (and r s))");
  EXPECT_EQ(tree("(p implies q) implies r"), "(implies (implies p q) r)");
}

TEST(Parser, a_chain_of_comparisons_is_their_conjunction) {
  EXPECT_EQ(tree("0 < a <= 1"), "(and (< 0 a) (<= a 1))");
  EXPECT_EQ(tree("a < b <= c = d"), "(and (and (< a b) (<= b c)) (= c d))");
  EXPECT_EQ(tree("a > b >= c"), "(and (> a b) (>= b c))");
}

TEST(Parser, a_quantifier_reaches_as_far_as_it_can) {
  EXPECT_EQ(tree("forall i in 1..k: p and q or r"), "(i forall (range  1 k) (or (and p q) r))");
  EXPECT_EQ(tree("p and exists f in faces(s): q implies r"), "(and p (f exists (faces  s) (implies q r)))");
  EXPECT_EQ(tree("forall i in 1..k, j in i+1..k: p"), "(i forall (range  1 k) (j forall (range  (+ i 1) k) p))");
  EXPECT_EQ(tree("(forall i in 1..k: p) and q"), "(and (i forall (range  1 k) p) q)");
}

TEST(Parser, calls_take_terms_and_statements) {
  EXPECT_EQ(tree("f()"), "(f )");
  EXPECT_EQ(tree("f(a, g(b))"), "(f  a (g  b))");
  EXPECT_EQ(tree("f(a < b)"), "(f  (< a b))");
}

TEST(Parser, numbers_are_decimal_whatever_zeros_lead) {
  EXPECT_EQ(tree("0010"), "10");
  EXPECT_EQ(tree("000"), "0");
  EXPECT_EQ(tree("08"), "8");
  EXPECT_EQ(tree(std::string(1000, '9')).size(), 1000U);
  EXPECT_EQ(error_of(std::string(1001, '9')).second, "a number of more than 1000 digits");
}

TEST(Parser, errors_say_what_stands_where_and_what_was_expected) {
  const std::vector<std::pair<std::string, std::pair<std::size_t, std::string>>> cases{
      {"", {0, "the end where a number, a name or ( was expected"}},
      {"a +", {3, "the end where a number, a name or ( was expected"}},
      {"a b", {2, "'b' where an operator or the end was expected"}},
      {"(a", {2, "the end where an operator or ) was expected"}},
      {"a)", {1, "')' where an operator or the end was expected"}},
      {"f(a", {3, "the end where a comma or ) was expected"}},
      {"f(a,)", {4, "')' where a number, a name or ( was expected"}},
      {"a < ", {4, "the end where a number, a name or ( was expected"}},
      {"a < and", {4, "'and' where a number, a name or ( was expected"}},
      {"and(a)", {0, "'and' where a number, a name or ( was expected"}},
      {"forall in 1..2: p", {7, "'in' where a variable was expected"}},
      {"forall 1 in 1..2: p", {7, "'1' where a variable was expected"}},
      {"forall i 1..2: p", {9, "'1' where 'in' was expected"}},
      {"forall i in 1..2 p", {17, "'p' where a colon and a statement, or a comma and another variable was expected"}},
      {"1..2", {1, "'..' where an operator or the end was expected"}},
      {"a <= <= b", {5, "'<=' where a number, a name or ( was expected"}},
      {"a not b", {2, "'not' where an operator or the end was expected"}},
      {"2 (a)", {2, "'(' where an operator or the end was expected"}},
  };
  for (const auto& [text, expected] : cases) EXPECT_EQ(error_of(text), expected) << text;
}

std::string repeated(const std::string& text, int times) {
  std::string result;
  for (int i = 0; i < times; ++i) result += text;
  return result;
}

TEST(Parser, what_is_nested_too_deeply_is_refused_and_breaks_nothing) {
  const std::string deep = "more than 200 levels of nesting";
  for (const int depth : {250, 100000}) {
    EXPECT_EQ(error_of(repeated("(", depth) + "a" + repeated(")", depth)).second, deep);
    EXPECT_EQ(error_of(repeated("-", depth) + "a").second, deep);
    EXPECT_EQ(error_of(repeated("not ", depth) + "p").second, deep);
    EXPECT_EQ(error_of(repeated("f(", depth) + "a").second, deep);
    EXPECT_EQ(error_of(repeated("2^", depth) + "a").second, deep);
    EXPECT_EQ(error_of(repeated("p implies ", depth) + "p").second, deep);
    EXPECT_EQ(error_of(repeated("forall i in s: ", depth) + "p").second, deep);
    // A tree as deep as the others, though the text has no nesting.
    EXPECT_EQ(error_of(repeated("a + ", depth) + "a").second, deep);
    EXPECT_EQ(error_of(repeated("a*", depth) + "a").second, deep);
    EXPECT_EQ(error_of(repeated("p and ", depth) + "p").second, deep);
    EXPECT_EQ(error_of(repeated("a < ", depth) + "a").second, deep);
  }
  EXPECT_NO_THROW((void)parse_formula(repeated("(", 150) + "a" + repeated(")", 150)));
  EXPECT_NO_THROW((void)parse_formula(repeated("a + ", 150) + "a"));
}

TEST(Parser, offsets_point_at_operators_and_names) {
  const auto formula = parse_formula("ab + f(c) < 1");
  EXPECT_EQ(formula->offset, 10U);
  EXPECT_EQ(formula->children[0]->offset, 3U);
  EXPECT_EQ(formula->children[0]->children[1]->offset, 5U);
  EXPECT_EQ(formula->children[0]->children[1]->children[0]->offset, 7U);
  EXPECT_EQ(formula->children[1]->offset, 12U);
}

TEST(Ranges, ends_belong_to_them_or_not) {
  const ParameterRange range = parse_range(" ( -1/2 , 3 ] ");
  EXPECT_EQ(range.lower, Rational(Integer(-1), Integer(2)));
  EXPECT_EQ(range.upper, Rational(3));
  EXPECT_FALSE(range.has_lower);
  EXPECT_TRUE(range.has_upper);
  EXPECT_NO_THROW((void)parse_range("[1, 1]"));
}

TEST(Ranges, may_have_no_end) {
  const ParameterRange range = parse_range("[1/2, infinity)");
  EXPECT_EQ(range.lower, Rational(Integer(1), Integer(2)));
  EXPECT_FALSE(range.upper.has_value());
  const ParameterRange all = parse_range("(-infinity, infinity)");
  EXPECT_FALSE(all.lower.has_value() || all.upper.has_value());
}

/// The words of a term that runs through a set, as the tree and back as text.
TEST(TermsOverSets, are_read_and_written) {
  for (const std::string text : {"sum(p in vertices(s): altitude(s, p))", "max(i in 0 .. k: min(j in 0 .. i: i*j))",
                                 "1 + product(f in facets(s): volume(f))^2"}) {
    EXPECT_EQ(formula_text(*parse_formula(text)), text);
  }
  const auto both = parse_formula("sum(i in 0 .. k, j in 0 .. i: edge(s, i, j))");
  EXPECT_EQ(both->operation, Operation::sum_over);
  EXPECT_EQ(both->text, "i");
  EXPECT_EQ(both->children.at(1)->operation, Operation::sum_over);
  EXPECT_EQ(both->children.at(1)->text, "j");
  EXPECT_EQ(parse_formula("max(a, b)")->operation, Operation::call) << "of two terms it is a function";
}

TEST(TermsOverSets, are_refused_where_they_are_wrong) {
  const std::vector<std::pair<std::string, std::pair<std::size_t, std::string>>> cases{
      {"1 + summ(p in vertices(s): 1)", {4, "no sum, product, min or max is called summ, did you mean sum?"}},
      {"sum(p in vertices(s), 1)", {22, "'1' where a variable was expected"}},
      {"sum(p in vertices(s))", {20, "')' where a colon and a term, or a comma and another variable was expected"}},
      {"sum(p in vertices(s): 1", {23, "the end where an operator or ) was expected"}},
  };
  for (const auto& [text, expected] : cases) {
    try {
      (void)parse_formula(text);
      ADD_FAILURE() << text << " was accepted";
    } catch (const FormulaError& error) {
      EXPECT_EQ(std::make_pair(error.offset(), std::string(error.what())), expected) << text;
    }
  }
}

TEST(Ranges, what_is_no_interval_is_refused) {
  const std::vector<std::pair<std::string, std::pair<std::size_t, std::string>>> cases{
      {"0, 1", {0, "'0' where an interval such as (0, 1] was expected"}},
      {"(0 1)", {3, "'1' where a comma between the ends was expected"}},
      {"(0, 1", {5, "the end where the end of the interval, ) or ] was expected"}},
      {"(0, k)", {4, "'k' where a number was expected"}},
      {"(0, 1/0)", {6, "a denominator of 0"}},
      {"(1, 0)", {0, "an empty interval"}},
      {"(1, 1]", {0, "an empty interval"}},
      {"[-infinity, 1]", {0, "infinity is not a number: write (-infinity"}},
      {"(0, infinity]", {12, "infinity is not a number: write infinity)"}},
      {"(infinity, 1)", {1, "an empty interval"}},
      {"(0, 1) x", {7, "'x' where an operator or the end was expected"}},
  };
  for (const auto& [text, expected] : cases) {
    try {
      (void)parse_range(text);
      ADD_FAILURE() << text << " was accepted";
    } catch (const FormulaError& error) {
      EXPECT_EQ(std::make_pair(error.offset(), std::string(error.what())), expected) << text;
    }
  }
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
