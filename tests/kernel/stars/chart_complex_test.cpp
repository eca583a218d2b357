#include "kernel/stars/chart_complex.hpp"

#include <gtest/gtest.h>

#include "tests/kernel/manifold/exhaustive.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

/// The stars of a complex given by its triangles.
std::vector<ChartStar<2>> stars_of(std::uint32_t count, const std::vector<LabelSimplex<2>>& triangles) {
  std::vector<ChartStar<2>> result;
  for (std::uint32_t label = 0; label < count; ++label) {
    ChartStar<2> star{Label(label), {}};
    for (const auto& triangle : triangles) {
      if (std::find(triangle.begin(), triangle.end(), label) == triangle.end()) continue;
      ChartSimplex<2> others;
      std::size_t next = 0;
      for (const std::uint32_t other : triangle) {
        if (other != label) others[next++] = {other, {}};
      }
      star.simplices.push_back(others);
    }
    result.push_back(star);
  }
  return result;
}

const std::vector<LabelSimplex<2>> octahedron{{0, 2, 4}, {0, 2, 5}, {0, 3, 4}, {0, 3, 5},
                                              {1, 2, 4}, {1, 2, 5}, {1, 3, 4}, {1, 3, 5}};
const std::vector<bool> all(6, true);

TEST(ChartComplex, has_every_simplex_once) {
  const ChartComplex<2> complex(stars_of(6, octahedron), all);
  EXPECT_EQ(complex.simplices(), octahedron);
  EXPECT_EQ(complex.euler_characteristic(), 2);
  EXPECT_EQ(complex.label_complex().count(1), 12U);
  EXPECT_EQ(complex.star(Label(3)).size(), 4U);
  EXPECT_EQ(complex.star(Label(3)).front(), (std::array<std::uint32_t, 2>{0, 4}));
  EXPECT_EQ(complex.neighbours(Label(3)), (std::vector<Label>{Label(0), Label(1), Label(4), Label(5)}));
  const auto agreement = complex.agreement();
  EXPECT_EQ(agreement.missing, 0U);
  EXPECT_EQ(agreement.stars, 0U);
  EXPECT_TRUE(agreement.failures.empty());
}

TEST(ChartComplex, names_stars_that_disagree) {
  // Label 2 does not have the triangle 0 2 4 that 0 and 4 have.
  auto stars = stars_of(6, octahedron);
  std::erase_if(stars[2].simplices, [](const auto& others) { return others[0].index == 0 && others[1].index == 4; });
  const auto agreement = ChartComplex<2>(stars, all).agreement();
  EXPECT_EQ(agreement.missing, 1U);
  EXPECT_EQ(agreement.stars, 1U);
  EXPECT_EQ(agreement.labels, std::vector<Label>{Label(2)});
  ASSERT_EQ(agreement.failures.size(), 1U);
  EXPECT_EQ(agreement.failures[0].label, Label(2));
  EXPECT_EQ(agreement.failures[0].cause, FailureCause::combinatorial);
  EXPECT_EQ(agreement.failures[0].reason, "simplex {0, 2, 4} is in the star of label 0 but not of 2");
  EXPECT_EQ(agreement.failures[0].concerned, (std::vector<Label>{Label(0), Label(2), Label(4)}));

  // The other diagonal of the square 0 2 1 3 about 4: stars 0 and 1 have it, 2, 3 and 4 have the first.
  stars = stars_of(6, octahedron);
  stars[4].simplices = {ChartSimplex<2>{Sighting<2>{0, {}}, Sighting<2>{1, {}}}};
  const auto other = ChartComplex<2>(stars, all).agreement();
  EXPECT_EQ(other.missing, 4U + 2U) << "four triangles that 4 misses, one that 0 and 1 miss";
  EXPECT_EQ(other.stars, 3U);
  EXPECT_EQ(other.failures.size(), 5U);
}

TEST(ChartComplex, has_simplices_that_lesser_labels_miss_in_order) {
  auto stars = stars_of(6, octahedron);
  stars[0].simplices.clear();
  EXPECT_EQ(ChartComplex<2>(stars, all).simplices(), octahedron);
  stars[1].simplices.clear();
  stars[3].simplices.clear();
  EXPECT_EQ(ChartComplex<2>(stars, all).simplices(), octahedron);
  // A star that has one twice, at different places of a quotient.
  stars[2].simplices.push_back(stars[2].simplices.back());
  EXPECT_EQ(ChartComplex<2>(stars, all).simplices(), octahedron);
  for (auto& star : stars) std::erase_if(star.simplices, [](const auto& others) { return others[1].index == 4; });
  stars[4].simplices.clear();
  EXPECT_EQ(ChartComplex<2>(stars, all).simplices(),
            (std::vector<LabelSimplex<2>>{{0, 2, 5}, {0, 3, 5}, {1, 2, 5}, {1, 3, 5}}));
}

TEST(ChartComplex, asks_nothing_of_labels_without_a_star) {
  auto stars = stars_of(6, octahedron);
  stars[2].simplices.clear();
  EXPECT_FALSE(ChartComplex<2>(stars, all).agreement().failures.empty());
  auto interior = all;
  interior[2] = false;
  EXPECT_TRUE(ChartComplex<2>(stars, interior).agreement().failures.empty());
  EXPECT_FALSE(ChartComplex<2>(stars, interior).is_interior(Label(2)));
}

TEST(ChartComplex, gives_every_simplex_to_its_smallest_label) {
  const ChartComplex<2> complex(stars_of(6, octahedron), all);
  EXPECT_EQ(complex.first_seen_from(Label(0)).size(), 4U);
  EXPECT_EQ(complex.first_seen_from(Label(1)).size(), 4U);
  EXPECT_TRUE(complex.first_seen_from(Label(2)).empty());
  auto interior = all;
  interior[0] = false;
  const ChartComplex<2> part(stars_of(6, octahedron), interior);
  EXPECT_TRUE(part.first_seen_from(Label(0)).empty());
  EXPECT_EQ(part.first_seen_from(Label(2)).size(), 2U);
}

TEST(PlacesOf, are_where_the_labels_are_seen) {
  const FlatAtlas<2> atlas(cubic_torus<2>(), PointSet<2>(random_points<2>(20, 8)), ratio(1, 4));
  ChartView<2> view(atlas, atlas.net(), {Curvature::zero, ratio(1, 2)});
  view.look(Label(4), 0.4);
  std::vector<std::uint32_t> seen;
  for (std::uint32_t label = 0; label < 20; ++label) {
    if (view.find(Label(label))) seen.push_back(label);
  }
  ASSERT_GE(seen.size(), 3U);
  ASSERT_LT(seen.size(), 20U);
  const auto places = places_of<2>(view, {seen[0], seen[1], seen[2]});
  ASSERT_TRUE(places.has_value());
  for (std::size_t corner = 0; corner < 3; ++corner) EXPECT_EQ(view.label((*places)[corner]), Label(seen[corner]));
  std::uint32_t unseen = 0;
  while (std::find(seen.begin(), seen.end(), unseen) != seen.end()) ++unseen;
  EXPECT_FALSE(places_of<2>(view, {seen[0], seen[1], unseen}).has_value());
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
