#include "kernel/sample/manifold_survey.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "tests/kernel/manifold/submanifold/samples.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

ManifoldSurvey survey_of(const ZeroSet& m, const std::vector<std::vector<double>>& around = {}) {
  return survey_manifold(m, 0.25, around, 1, no_progress());
}

ZeroSet two_unit_spheres(const std::string& centre) {
  return zero_set("two", {"x", "y", "z"}, {"(x^2 + y^2 + z^2 - 1)*((x - " + centre + ")^2 + y^2 + z^2 - 1)"},
                  {Rational(6), Rational(2), Rational(2)});
}

TEST(ManifoldSurvey, knows_the_reach_and_the_area_of_well_known_surfaces) {
  const ZeroSet ellipsoid =
      zero_set("ellipsoid", {"x", "y", "z"}, {"x^2/4 + 4*y^2/9 + z^2 - 1"}, {ratio(5, 2), Rational(2), ratio(3, 2)});
  struct Known {
    ZeroSet m;
    double reach, area;
  };
  constexpr double pi = std::numbers::pi;
  const std::vector<Known> all{
      {unit_sphere_in_space(), 1, 4 * pi}, {torus_of_revolution(), 1, 8 * pi * pi}, {ellipsoid, 0.5, 27.9}};
  for (const Known& known : all) {
    const ManifoldSurvey survey = survey_of(known.m);
    EXPECT_GT(survey.places.size(), 4000U) << known.m.name();
    EXPECT_GT(survey.reach, known.reach * 0.999) << known.m.name();
    EXPECT_LT(survey.reach, known.reach * 1.02) << known.m.name();
    EXPECT_GT(survey.volume, known.area * 0.85) << known.m.name();
    EXPECT_LT(survey.volume, known.area * 1.15) << known.m.name();
    EXPECT_NEAR(survey.places.front().curvature, 1 / known.reach, 0.02 / known.reach) << known.m.name();
    EXPECT_LE(survey.curvatures.back(), survey.places.front().curvature) << known.m.name();
  }
}

TEST(ManifoldSurvey, sees_sheets_that_come_near_to_one_another) {
  // A gap of 1/10 between two spheres; the twin: one of 2.
  const ManifoldSurvey near = survey_of(two_unit_spheres("21/10"));
  EXPECT_NEAR(near.reach, 0.05, 0.001);
  ASSERT_FALSE(near.narrow.empty());
  for (const auto& x : near.narrow) EXPECT_NEAR(x[0], 1.05, 0.06);
  EXPECT_GT(survey_of(two_unit_spheres("4")).reach, 0.99);
  // Two sheets far from where it is curved most: opposite sides of a flat ellipsoid are no nearer than its rim is
  // curved.
  const ZeroSet flat =
      zero_set("flat", {"x", "y", "z"}, {"x^2 + y^2 + 100*z^2 - 1"}, {Rational(2), Rational(2), Rational(1)});
  EXPECT_NEAR(survey_of(flat).reach, 0.01, 0.0005);
}

TEST(ManifoldSurvey, looks_around_places_where_a_part_is_small) {
  const ZeroSet m = zero_set("moon", {"x", "y", "z"}, {"(x^2 + y^2 + z^2 - 1)*((x - 3)^2 + y^2 + z^2 - 1/250000)"},
                             {Rational(4), Rational(2), Rational(2)});
  EXPECT_NEAR(survey_of(m, {{3.002, 0, 0}}).reach, 0.002, 0.0001);
}

TEST(ManifoldSurvey, is_for_any_codimension) {
  // The second fundamental form of this torus is known up to a factor √2.
  EXPECT_NEAR(survey_of(clifford_torus()).reach, 1 / std::sqrt(2.0), 0.01);
}

TEST(ManifoldSurvey, is_empty_without_zeros_and_the_same_for_a_seed) {
  const ZeroSet none =
      zero_set("none", {"x", "y", "z"}, {"x^2 + y^2 + z^2 + 1"}, {Rational(1), Rational(1), Rational(1)});
  EXPECT_TRUE(survey_of(none).places.empty());
  EXPECT_TRUE(survey_of(none).curvatures.empty());
  const ZeroSet m = unit_sphere_in_space();
  const ManifoldSurvey once = survey_of(m);
  const ManifoldSurvey again = survey_of(m);
  EXPECT_EQ(once.reach, again.reach);
  EXPECT_EQ(once.places.back().x, again.places.back().x);
  EXPECT_NE(once.places.back().x, survey_manifold(m, 0.25, {}, 2, no_progress()).places.back().x);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
