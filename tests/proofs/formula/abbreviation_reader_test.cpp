#include "proofs/formula/abbreviation_reader.hpp"

#include <gtest/gtest.h>

#include "proofs/formula/claim.hpp"
#include "proofs/formula/decision.hpp"
#include "proofs/formula/simplex_object.hpp"
#include "properties/instances/instance_class.hpp"
#include "support/error.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

const std::string head = "name = 'n'\ninstance = 'simplex'\n";

Claim parsed(const std::string& text) {
  return parse_claim(text, "a.toml", full_vocabulary(), {{"simplex", instance_class("simplex").signature()}});
}

std::string error_of(const std::string& text) {
  try {
    (void)parsed(text);
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

Verdict first_conclusion(const std::string& text) {
  const Claim claim = parsed(text);
  const ObjectPointer s =
      std::make_shared<SimplexObject>(SimplexObject::Points{{0, 0}, {Rational(3), 0}, {0, Rational(4)}});
  const Bindings bindings{{"s", s}, {"k", 2L}, {"m", 2L}};
  Scene scene(bindings);
  return decide_statement(*claim.conclusions.at(0).formula, scene);
}

TEST(Abbreviations, of_numbers_objects_sets_and_statements_stand_for_what_they_are) {
  const std::string let =
      "let = { half = 'perimeter/2', perimeter = 'sum(e in edges(s): longest_edge(e))', f = 'opposite_facet(s, 0)', "
      "all = 'facets(s)', right = 'longest_edge(f) = 5' }\n";
  EXPECT_EQ(first_conclusion(head + let + "[[show]]\nclaim = 'half = 6 and right'\n"), Verdict::proved);
  EXPECT_EQ(first_conclusion(head + let + "[[show]]\nclaim = 'half = 7 or not right'\n"), Verdict::refuted);
  EXPECT_EQ(first_conclusion(head + let + "[[show]]\nclaim = 'max(e in all: longest_edge(e)) = longest_edge(f)'\n"),
            Verdict::proved);
}

/// The variable inside an abbreviation is another than that of the formula that uses it.
TEST(Abbreviations, keep_their_own_variables) {
  const std::string let = "let = { d = 'max(p in vertices(s): altitude(s, p))' }\n";
  EXPECT_EQ(first_conclusion(head + let + "[[show]]\nclaim = 'forall p in 0 .. 0: altitude(s, p) < d and d = 4'\n"),
            Verdict::proved);
}

TEST(Abbreviations, are_refused_where_they_are_wrong) {
  const std::string show = "[[show]]\nclaim = '1 > 0'\n";
  EXPECT_EQ(error_of(head + "let = { s = '1' }\n" + show), "a.toml:3:9: s is already something else");
  EXPECT_EQ(error_of(head + "let = { sqrt = '1' }\n" + show),
            "a.toml:3:9: sqrt is no name for an abbreviation: letters, digits and '_', and no function");
  EXPECT_EQ(error_of(head + "let = { a = 'b', b = 'a' }\n" + show), "a.toml:3:13: a is made of itself");
  EXPECT_EQ(error_of(head + "let = { a = 'thicknes(s)' }\n" + show),
            "a.toml:3:14: no function is called thicknes, did you mean thickness?");
  EXPECT_EQ(error_of(head + "let = { a = '1' }\n[[show]]\nclaim = 'forall a in 0 .. k: a >= 0'\n"),
            "a.toml:5:10: the variable a is already something else");
  EXPECT_EQ(error_of(head + "let = 1\n" + show),
            "a.toml:3:7: the key let expects a table such as { ratio = \"1/(1 + xi)\" }");
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
