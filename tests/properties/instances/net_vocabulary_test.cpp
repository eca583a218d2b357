#include "properties/instances/net_vocabulary.hpp"

#include <gtest/gtest.h>

#include "kernel/formula/parser.hpp"
#include "proofs/formula/decision.hpp"
#include "proofs/formula/type_check.hpp"
#include "properties/instances/instance_class.hpp"
#include "tests/properties/instances/square_net.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

/// The square lattice, and the same with one neighbour of the origin moved.
Bindings square_nets() {
  auto moved = square_points(9);
  for (auto& point : moved) {
    if (point[0] == Rational(1) && point[1] == Rational(0)) point[0] += Rational(Integer(1), Integer(8));
  }
  Bindings bindings;
  bindings["p"] = ObjectPointer(std::make_shared<NetObject>(square_points(9), Rational(1), Rational(4)));
  bindings["q"] = ObjectPointer(std::make_shared<NetObject>(moved, Rational(1), Rational(4)));
  return bindings;
}

Verdict verdict_of(const std::string& formula) {
  const Bindings bindings = square_nets();
  const auto statement =
      type_checked(parse_formula(formula), full_vocabulary(), {{"p", types::net}, {"q", types::net}}, types::truth);
  Scene scene(bindings);
  return decide_statement(*statement, scene);
}

TEST(NetVocabulary, measures_the_square_lattice) {
  EXPECT_EQ(verdict_of("separation(p) = 1"), Verdict::proved);
  EXPECT_EQ(verdict_of("separation(q) = 7/8"), Verdict::proved);
  EXPECT_EQ(verdict_of("displacement(p, q) = 1/8"), Verdict::proved);
  EXPECT_EQ(verdict_of("covering_radius(p) > 7/10 and covering_radius(p) < 71/100"), Verdict::proved);
  EXPECT_EQ(verdict_of("covering_radius(q) < 71/100"), Verdict::refuted);
  // Eight points at distance 1 and √2: 56 triangles.
  EXPECT_EQ(verdict_of("simplices_within(p, 3/2) = 56"), Verdict::proved);
  EXPECT_EQ(verdict_of("simplices_within(p, 1) = 0"), Verdict::proved);
  EXPECT_EQ(verdict_of("simplices_within(p, sqrt(2)) = 4"), Verdict::proved);
  EXPECT_EQ(verdict_of("farthest_original(q, p, 11/10) = 9/8"), Verdict::proved);
}

TEST(NetVocabulary, knows_stars) {
  EXPECT_EQ(verdict_of("have_same_star(region_of_interest(p, q), q)"), Verdict::proved);
  EXPECT_EQ(verdict_of("have_same_star(p, q)"), Verdict::refuted);
  EXPECT_EQ(verdict_of("star_reach(p, p) = sqrt(2)"), Verdict::proved);
  EXPECT_EQ(verdict_of("star_reach(p, q) >= 9/8"), Verdict::proved);
  // Two triangles at right angles are those of a square: protected by 0 by the fourth corner.
  EXPECT_EQ(verdict_of("forall s in star_simplices(p): is_nondegenerate(s) and protection(p, s) = 0"), Verdict::proved);
  EXPECT_EQ(verdict_of("forall s in star_simplices(q): protection(q, s) > 0"), Verdict::refuted);
}

TEST(NetVocabulary, finds_forbidden_configurations) {
  EXPECT_EQ(verdict_of("has_forbidden_configuration(p, 1/100, 1, 0)"), Verdict::proved);
  EXPECT_EQ(verdict_of("has_forbidden_configuration(p, 1/100, 7/10, 0)"), Verdict::refuted);
  EXPECT_EQ(verdict_of("has_forbidden_configuration(p, 1/100, 1, -1)"), Verdict::refuted);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
