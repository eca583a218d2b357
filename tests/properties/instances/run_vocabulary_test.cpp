#include "properties/instances/run_vocabulary.hpp"

#include <gtest/gtest.h>

#include "kernel/formula/parser.hpp"
#include "proofs/formula/decision.hpp"
#include "proofs/formula/type_check.hpp"
#include "properties/instances/instance_class.hpp"
#include "properties/instances/run_object.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

Bindings run_of(RunMode mode) {
  RunRecipe recipe;
  recipe.divisions = 18;
  recipe.mode = mode;
  Bindings bindings;
  bindings["r"] = ObjectPointer(std::make_shared<RunObject>(recipe));
  return bindings;
}

Verdict verdict(const Bindings& bindings, const std::string& formula) {
  const auto statement = type_checked(parse_formula(formula), full_vocabulary(), {{"r", types::run}}, types::truth);
  Scene scene(bindings);
  return decide_statement(*statement, scene);
}

TEST(RunVocabulary, speaks_of_a_run_of_the_algorithm) {
  const Bindings run = run_of(RunMode::theory);
  for (const char* statement :
       {"satisfies_hypotheses(r)", "has_no_forbidden_configuration(r)", "has_protected_stars(r)", "is_manifold(r)",
        "has_stable_stars(r)", "is_delaunay(r)", "is_triangulation(r)", "is_self_delaunay(r)",
        "euler_characteristic(r) = 0", "least_protection(r) > 0", "least_thickness(r) > 0"}) {
    EXPECT_EQ(verdict(run, statement), Verdict::proved) << statement;
  }
  // Squares of side 1/18, moved by at most a quarter of the sampling radius.
  EXPECT_EQ(verdict(run, "perturbed_separation(r) > 1/40 and perturbed_separation(r) < 1/18"), Verdict::proved);
  EXPECT_EQ(verdict(run, "perturbed_covering_radius(r) > 1/27 and perturbed_covering_radius(r) < 1/18"),
            Verdict::proved);
  EXPECT_EQ(verdict(run, "least_thickness(r) > 1/2"), Verdict::refuted);
  EXPECT_EQ(verdict(run, "least_protection(r) > 1/100"), Verdict::refuted);
}

// Defect: undecided from half a sampling radius on, where the certified number ends.
TEST(RunVocabulary, bounds_a_protection_beyond_half_a_sampling_radius) {
  RunRecipe recipe;
  recipe.manifold = "torus-3";
  recipe.divisions = 14;
  recipe.centred = true;
  recipe.perturbation_share = Rational(Integer(1), Integer(8));
  Bindings run;
  run["r"] = ObjectPointer(std::make_shared<RunObject>(recipe));
  // The sampling radius of the lattice is √5/56 = 0.0399…; in the lattice itself the protection is 0.0244….
  EXPECT_EQ(verdict(run, "least_protection(r) > 1/60"), Verdict::proved);
  EXPECT_EQ(verdict(run, "least_protection(r) < 1/12"), Verdict::proved);
  EXPECT_EQ(verdict(run, "least_protection(r) < 1/60 or least_protection(r) > 1/12"), Verdict::refuted);
}

TEST(RunVocabulary, refutes_it_all_without_perturbation) {
  const Bindings run = run_of(RunMode::none);
  for (const char* statement :
       {"satisfies_hypotheses(r)", "has_no_forbidden_configuration(r)", "has_protected_stars(r)", "is_manifold(r)",
        "has_stable_stars(r)", "is_delaunay(r)", "is_triangulation(r)", "is_self_delaunay(r)"}) {
    EXPECT_EQ(verdict(run, statement), Verdict::refuted) << statement;
  }
  EXPECT_EQ(verdict(run, "least_protection(r) > 0"), Verdict::undecided);
  // Defect: what is no manifold had the characteristic -1000000.
  for (const char* statement : {"euler_characteristic(r) = 0", "euler_characteristic(r) = -1000000"})
    EXPECT_EQ(verdict(run, statement), Verdict::undecided) << statement;
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
