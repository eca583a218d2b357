#include "proofs/certificate/given_complex_claims.hpp"

#include <gtest/gtest.h>

#include "proofs/certificate/file_text.hpp"
#include "support/error.hpp"
#include "tests/support/complex_texts.hpp"
#include "tests/support/message_of.hpp"
#include "tests/support/temporary_folder.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

template <int m>
GivenComplexClaims claims_in(const std::string& text, const LevelSelection& levels = all_levels()) {
  const ComplexDescription description = parse_complex(text, "x.toml");
  return claims_of<m>(description.form, place_complex<m>(description), levels, no_progress());
}

TEST(GivenComplexClaims, of_equilateral_triangles_are_the_known_margins) {
  const auto claims = claims_in<2>(complex_text("klein-bottle-9"));
  ASSERT_TRUE(claims.levels.delaunay && claims.levels.metric && claims.levels.metric->weight);
  EXPECT_TRUE(claims.levels.triangulation);
  EXPECT_TRUE(claims.not_reached.empty());
  // Edges of 1/3; the centre of a triangle is twice as far from the next point as from its vertices.
  const double radius = 0.1924500897;
  EXPECT_NEAR(approximate_double(claims.longest_edge), 1.0 / 3, 1e-3);
  EXPECT_NEAR(approximate_double(claims.levels.delaunay->balls->circumradius), radius, 1e-3);
  EXPECT_NEAR(approximate_double(claims.levels.delaunay->balls->protection), radius, 1e-3);
  EXPECT_GT(approximate_double(claims.levels.delaunay->balls->circumradius), radius);
  EXPECT_LT(approximate_double(claims.levels.delaunay->balls->protection), radius);
  EXPECT_NEAR(approximate_double(*claims.levels.metric->weight), 1.1547005, 1e-3);
  EXPECT_NEAR(approximate_double(claims.levels.metric->least_stretch), 1, 1e-5);
  EXPECT_NEAR(approximate_double(claims.levels.metric->greatest_stretch), 1, 1e-5);
  ASSERT_TRUE(claims.levels.manifold);
  EXPECT_EQ(claims.levels.manifold->euler_characteristic, 0);
  EXPECT_EQ(group_text(claims.levels.manifold->homology[1]), "Z + Z/2");
}

TEST(GivenComplexClaims, leave_out_level_4_where_a_neighbour_is_in_a_circumball) {
  const auto claims =
      claims_in<2>(replaced(complex_text("klein-bottle-9"), "b1 = [\"1/6\", \"1/2\"]", "b1 = [0.32, 0.5]"));
  EXPECT_FALSE(claims.levels.delaunay);
  ASSERT_EQ(claims.not_reached.size(), 1U);
  EXPECT_TRUE(mentions(claims.not_reached[0], "is not certainly outside of the circumball of simplex {"));
  EXPECT_TRUE(claims.levels.triangulation);
}

TEST(GivenComplexClaims, leave_out_balls_that_do_not_exist) {
  // Four points nearly on a horocycle have no circumball in the hyperbolic plane.
  const auto claims = claims_in<2>(
      "name = \"x\"\nfamily = \"complex\"\ndimension = 2\ncurvature = -1\n"
      "points = [[1.9, 0], [-1.9, 0], [0, 0.1]]\nsimplices = [[0, 1, 2]]\n");
  EXPECT_FALSE(claims.levels.delaunay);
  EXPECT_FALSE(claims.levels.metric);
  ASSERT_EQ(claims.not_reached.size(), 2U);
  EXPECT_EQ(claims.not_reached[0], "level 4: of 1 simplices no circumball is certain");
}

TEST(GivenComplexClaims, are_those_that_are_asked_for) {
  const auto claims = claims_in<2>(complex_text("klein-bottle-9"), {"2", "5"});
  EXPECT_TRUE(claims.levels.manifold && claims.levels.triangulation);
  EXPECT_FALSE(claims.levels.delaunay || claims.levels.metric);
  EXPECT_FALSE(claims_in<2>(complex_text("klein-bottle-9"), {"2"}).levels.triangulation);
}

TEST(GivenComplexClaims, are_written_with_the_group_and_without_an_injectivity_radius) {
  const TemporaryFolder folder;
  const ComplexDescription description = parse_complex(complex_text("klein-bottle-9"), "x.toml");
  const auto given = place_complex<2>(description);
  const auto claims = claims_of<2>(description.form, given, {"2", "5"}, no_progress());
  write_given_complex<2>(folder / "x.json", description, given, claims, {}, no_progress());
  const std::string text = read_text(folder / "x.json");
  EXPECT_TRUE(mentions(text, "\"family\":\"flat\",\"dimension\":2"));
  EXPECT_TRUE(mentions(text, "\"injectivity_radius\":\"0\"}"));
  EXPECT_TRUE(mentions(text, "\"mode\":\"none\""));
  EXPECT_TRUE(mentions(text, "\"perturbation\":\"0\""));
  EXPECT_TRUE(mentions(text, "\"levels\":{\"2\":{\"simplices\":18,"));
  EXPECT_TRUE(mentions(text, "\"points\":[[\"0\",\"0\"],"));
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
