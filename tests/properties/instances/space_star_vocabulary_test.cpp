#include "properties/instances/space_star_vocabulary.hpp"

#include <gtest/gtest.h>

#include "kernel/formula/parser.hpp"
#include "proofs/formula/decision.hpp"
#include "proofs/formula/type_check.hpp"
#include "properties/instances/instance_class.hpp"
#include "properties/instances/space_object.hpp"
#include "support/error.hpp"
#include "tests/properties/instances/square_net.hpp"
#include "tests/support/ratio.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

/// A sheared lattice p without a point far out, q without another one; r is sheared the other way, h hyperbolic.
Bindings sheared_lattices(const Rational& scale) {
  const auto lattice = [&](const Rational& shear, std::size_t left_out) {
    auto points = square_points(6);
    for (auto& point : points) {
      point[0] += point[1] * shear;
      for (Rational& coordinate : point) coordinate *= scale;
    }
    points.erase(points.begin() + static_cast<std::ptrdiff_t>(left_out));
    return ObjectPointer(std::make_shared<SpaceObject>(Curvature::positive, Rational(1), std::move(points)));
  };
  Bindings bindings;
  bindings["p"] = lattice(ratio(1, 10), 20);
  bindings["q"] = lattice(ratio(1, 10), 4);
  bindings["r"] = lattice(ratio(-1, 10), 4);
  bindings["h"] = ObjectPointer(
      std::make_shared<SpaceObject>(Curvature::negative, Rational(1), object_in<SpaceObject>(bindings, "p").points()));
  return bindings;
}

Verdict verdict_of(const std::string& formula, const Rational& scale = ratio(1, 100)) {
  const Bindings bindings = sheared_lattices(scale);
  Signature signature;
  for (const auto& [name, binding] : bindings) signature[name] = types::space_points;
  const auto statement = type_checked(parse_formula(formula), full_vocabulary(), signature, types::truth);
  Scene scene(bindings);
  return decide_statement(*statement, scene);
}

TEST(SpaceStarVocabulary, ComparesStars) {
  EXPECT_EQ(verdict_of("have_same_star_in_charts(p, 0, 90, p)"), Verdict::proved);
  EXPECT_EQ(verdict_of("have_same_star_in_space(p, 3, p)"), Verdict::proved);
  // Numbers shift, coordinates do not; the points left out are far away.
  EXPECT_EQ(verdict_of("have_same_star_in_chart(p, 0, p, q)"), Verdict::proved);
  EXPECT_EQ(verdict_of("have_same_star_in_chart(p, 0, p, r)"), Verdict::refuted);
}

TEST(SpaceStarVocabulary, MeasuresThem) {
  EXPECT_EQ(verdict_of("chart_star_thickness(p, 0, p) > 55/200"), Verdict::proved);
  EXPECT_EQ(verdict_of("chart_star_thickness(p, 0, p) < 56/200"), Verdict::proved);
  EXPECT_EQ(verdict_of("chart_star_protection(p, 0, p) > 13/10000"), Verdict::proved);
  EXPECT_EQ(verdict_of("chart_star_protection(p, 0, p) < 14/10000"), Verdict::proved);
}

TEST(SpaceStarVocabulary, IsUndecidedWhereEnclosuresAre) {
  EXPECT_EQ(verdict_of("chart_star_thickness(p, 0, p) > 0", ratio(1, 5)), Verdict::undecided);
  EXPECT_EQ(verdict_of("have_same_star_in_charts(p, 0, 90, p)", ratio(1, 5)), Verdict::undecided);
}

TEST(SpaceStarVocabulary, RefusesOtherSpacesAndNumbersWithoutAPoint) {
  EXPECT_THROW((void)verdict_of("have_same_star_in_space(h, 0, p)"), InputError);
  EXPECT_THROW((void)verdict_of("have_same_star_in_space(p, 1000, p)"), InputError);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
