#include "kernel/theorems/blended_triangulation.hpp"

#include <gtest/gtest.h>

#include "tests/kernel/theorems/glued_run.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

TEST(BlendedTriangulation, triangulates_a_sphere_that_is_sampled_well) {
  const auto& [atlas, run] = fine_sphere();
  const auto found = check_blended_triangulation<2>(atlas, run.points, run.complex.simplices());
  EXPECT_TRUE(found.triangulates());
  EXPECT_GT(found.seams, 50U);
  EXPECT_LT(found.contraction, ratio(3, 5));
  EXPECT_GT(found.contraction, ratio(1, 50));
  EXPECT_LT(found.displacement, atlas.sampling_radius() / Rational(5));
  EXPECT_GT(found.displacement, Rational(0));
}

TEST(BlendedTriangulation, of_flat_charts_moves_nothing) {
  const auto [atlas, run] = glued_run<2>("torus-2-by-charts", ratio(1, 30));
  const auto found = check_blended_triangulation<2>(atlas, run.points, run.complex.simplices());
  EXPECT_TRUE(found.triangulates());
  EXPECT_GT(found.seams, 20U);
  EXPECT_LT(found.contraction, Rational::power_of_two(-20));
  EXPECT_LT(found.displacement, Rational::power_of_two(-40));
}

TEST(BlendedTriangulation, says_which_simplices_it_does_not_know) {
  const auto& [atlas, run] = fine_sphere();
  // Two labels far from each other exchanged: their simplices reach around the sphere.
  auto simplices = run.complex.simplices();
  for (auto& simplex : simplices) {
    for (std::uint32_t& label : simplex)
      label = label == 0 ? static_cast<std::uint32_t>(atlas.size() - 1) : label == atlas.size() - 1 ? 0U : label;
    std::sort(simplex.begin(), simplex.end());
  }
  ASSERT_NE(atlas.home_chart(Label(0)), atlas.home_chart(Label(static_cast<std::uint32_t>(atlas.size() - 1))));
  const auto found = check_blended_triangulation<2>(atlas, run.points, simplices);
  EXPECT_FALSE(found.triangulates());
  EXPECT_GE(found.failures.size(), 6U);
}

TEST(BlendedTriangulation, asks_for_a_label_that_is_clear_of_seams) {
  const auto& [atlas, run] = fine_sphere();
  // The seams alone: the star of every label is between charts.
  std::vector<LabelSimplex<2>> seams;
  for (const auto& simplex : run.complex.simplices()) {
    if (std::any_of(simplex.begin(), simplex.end(),
                    [&](std::uint32_t v) { return atlas.home_chart(Label(v)) != atlas.home_chart(Label(simplex[0])); }))
      seams.push_back(simplex);
  }
  const auto found = check_blended_triangulation<2>(atlas, run.points, seams);
  EXPECT_TRUE(found.failures.empty());
  EXPECT_FALSE(found.unclear.empty());
  EXPECT_FALSE(found.triangulates());
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
