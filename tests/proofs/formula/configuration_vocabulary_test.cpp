#include "proofs/formula/configuration_vocabulary.hpp"

#include <gtest/gtest.h>

#include "kernel/formula/parser.hpp"
#include "proofs/formula/arithmetic_vocabulary.hpp"
#include "proofs/formula/decision.hpp"
#include "proofs/formula/simplex_object.hpp"
#include "proofs/formula/simplex_vocabulary.hpp"
#include "proofs/formula/type_check.hpp"
#include "support/error.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

using Points = SimplexObject::Points;

ObjectPointer simplex(Points points) { return std::make_shared<SimplexObject>(std::move(points)); }

const Vocabulary& vocabulary() {
  static const Vocabulary result = [] {
    Vocabulary made;
    add_arithmetic(made);
    add_simplex_quantities(made);
    add_configuration_quantities(made);
    return made;
  }();
  return result;
}

Verdict decided(const std::string& text, const Bindings& bindings) {
  const Signature signature{{"t", types::simplex}, {"x", types::point}};
  const auto formula = type_checked(parse_formula(text), vocabulary(), signature, types::truth);
  Scene scene(bindings);
  return decide_statement(*formula, scene);
}

/// A vertex above the middle of an edge of length 2.
Bindings tent(long height) { return {{"t", simplex({{0, Rational(height)}, {-1, 0}, {1, 0}})}}; }

/// The corners of a square on the unit circle, one of them at another distance from the origin.
Bindings square_with(const Rational& distance) { return {{"t", simplex({{distance, 0}, {0, 1}, {-1, 0}, {0, -1}})}}; }

TEST(ConfigurationVocabulary, CircumsphereAndDiametricSphereOfAnEdgeDiffer) {
  // The circumsphere of an edge in its line are its two ends.
  EXPECT_EQ(decided("circumsphere_distance(t, 0) = sqrt(5)", tent(2)), Verdict::proved);
  EXPECT_EQ(decided("diametric_sphere_distance(t, 0) = 1", tent(2)), Verdict::proved);
  EXPECT_EQ(decided("circumsphere_distance(t, 0) < sqrt(5)", tent(2)), Verdict::refuted);
  EXPECT_EQ(decided("diametric_sphere_distance(t, 0) < 1", tent(2)), Verdict::refuted);
  EXPECT_EQ(decided("diametric_sphere_distance(t, 0) = 0", tent(1)), Verdict::proved);
}

TEST(ConfigurationVocabulary, DistancesFromAFacetWithoutCircumcentreAreUndefined) {
  const Bindings line{{"t", simplex({{0, 1}, {-1, 0}, {1, 0}, {3, 0}})}};
  EXPECT_EQ(decided("circumsphere_distance(t, 0) >= 0", line), Verdict::undecided);
  EXPECT_EQ(decided("diametric_sphere_distance(t, 0) >= 0", line), Verdict::undecided);
}

TEST(ConfigurationVocabulary, AVertexThatDoesNotExistIsAnError) {
  EXPECT_THROW((void)decided("circumsphere_distance(t, 3) >= 0", tent(2)), InputError);
  EXPECT_THROW((void)decided("diametric_sphere_distance(t, -1) >= 0", tent(2)), InputError);
}

TEST(ConfigurationVocabulary, FourPointsOfACircleAreAForbiddenConfiguration) {
  EXPECT_EQ(decided("is_forbidden_configuration(t, 2, 1/10, 2, 0)", square_with(1)), Verdict::proved);
  // R < ε′ is strict.
  EXPECT_EQ(decided("is_forbidden_configuration(t, 2, 1/10, 1, 0)", square_with(1)), Verdict::refuted);
}

TEST(ConfigurationVocabulary, ADistanceOfExactlyTheProtectionIsForbidden) {
  const Bindings moved = square_with(Rational(101) / Rational(100));
  EXPECT_EQ(decided("is_forbidden_configuration(t, 2, 1/10, 2, 1/100)", moved), Verdict::proved);
  EXPECT_EQ(decided("is_forbidden_configuration(t, 2, 1/10, 2, 1/200)", moved), Verdict::refuted);
}

TEST(ConfigurationVocabulary, AForbiddenConfigurationInAnotherSpaceIsAnError) {
  EXPECT_THROW((void)decided("is_forbidden_configuration(t, 3, 1/10, 2, 0)", square_with(1)), InputError);
}

TEST(ConfigurationVocabulary, EachOfTheFourPropertiesCanFail) {
  EXPECT_EQ(decided("has_forbidden_properties(t, 1/10, 1/100, 3/5, 5/2)", square_with(1)), Verdict::proved);
  const Bindings moved = square_with(Rational(11) / Rational(10));
  EXPECT_EQ(decided("has_forbidden_properties(t, 1/10, 1/100, 3/5, 5/2)", moved), Verdict::refuted);
  EXPECT_EQ(decided("has_forbidden_properties(t, 1/10, 1/100, 1/2, 5/2)", square_with(1)), Verdict::refuted);
  EXPECT_EQ(decided("has_forbidden_properties(t, 1/10, 1/100, 3/5, 2)", square_with(1)), Verdict::refuted);
  EXPECT_EQ(decided("has_forbidden_properties(t, 9/10, 1/100, 3/5, 5/2)", square_with(1)), Verdict::refuted);
}

TEST(ConfigurationVocabulary, AJoinHasThePointFirst) {
  const Bindings bindings{{"t", simplex({{-1, 0}, {1, 0}})},
                          {"x", ObjectPointer(std::make_shared<PointObject>(std::vector<Rational>{0, 1}))}};
  EXPECT_EQ(decided("altitude(join(x, t), 0) = 1", bindings), Verdict::proved);
  EXPECT_EQ(decided("edge(join(x, t), 1, 2) = 2", bindings), Verdict::proved);
}

TEST(ConfigurationVocabulary, AJoinOfDifferentSpacesIsAnError) {
  const Bindings bindings{{"t", simplex({{-1, 0}, {1, 0}})},
                          {"x", ObjectPointer(std::make_shared<PointObject>(std::vector<Rational>{0, 1, 2}))}};
  EXPECT_THROW((void)decided("altitude(join(x, t), 0) = 1", bindings), InputError);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
