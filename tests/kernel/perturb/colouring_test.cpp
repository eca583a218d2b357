#include "kernel/perturb/colouring.hpp"

#include <set>

#include "kernel/manifold/quotient/space_form_atlas.hpp"
#include "kernel/manifold/space_form_file.hpp"
#include "kernel/parallel/threads.hpp"
#include "kernel/sample/poisson_disk.hpp"
#include "kernel/sample/space_form_net.hpp"
#include "tests/kernel/manifold/exhaustive.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

/// For each label the labels that it sights within the reach or that sight it.
template <int m>
std::vector<std::set<std::uint32_t>> seen_by_each_other(const Atlas<m>& atlas, double reach) {
  std::vector<std::set<std::uint32_t>> result(atlas.size());
  std::vector<Sighting<m>> seen;
  for (std::uint32_t index = 0; index < atlas.size(); ++index) {
    atlas.sightings(Label(index), reach, seen);
    for (const auto& sighting : seen) {
      if (sighting.index == index) continue;
      result[index].insert(sighting.index);
      result[sighting.index].insert(index);
    }
  }
  return result;
}

/// Checks a colouring by its definition; returns the number of colours.
template <int m>
std::size_t check(const Atlas<m>& atlas, const Rational& reach) {
  const auto colours = colours_of<m>(atlas, reach, no_progress());
  const auto near = seen_by_each_other<m>(atlas, approximate_double(reach * atlas.sampling_radius(Label(0))));
  EXPECT_EQ(colours.size(), atlas.size());
  std::size_t clashes = 0;
  std::size_t wasted = 0;
  for (std::uint32_t index = 0; index < atlas.size(); ++index) {
    std::set<std::uint32_t> earlier;
    for (const std::uint32_t other : near[index]) {
      if (colours[other] == colours[index]) ++clashes;
      if (other < index) earlier.insert(colours[other]);
    }
    for (std::uint32_t less = 0; less < colours[index]; ++less) {
      if (!earlier.contains(less)) ++wasted;
    }
  }
  EXPECT_EQ(clashes, 0U);
  EXPECT_EQ(wasted, 0U);
  return *std::max_element(colours.begin(), colours.end()) + std::size_t{1};
}

TEST(ColoursOf, keep_labels_of_one_colour_out_of_sight_and_waste_none) {
  const FlatAtlas<2> torus(hexagonal_torus(),
                           PointSet<2>(poisson_disk_net<2>(hexagonal_torus(), ratio(1, 30), 1, no_progress())),
                           ratio(1, 30));
  EXPECT_LT(check<2>(torus, ratio(9, 2)), 40U);
  EXPECT_LT(check<2>(torus, Rational(3)), 20U);
  EXPECT_EQ(check<2>(torus, ratio(1, 2)), 1U);
  for (const auto& [name, radius] : {std::pair{"klein-bottle", ratio(1, 24)}, {"projective-plane", ratio(1, 8)}}) {
    const auto form = verify_space_form(find_space_form(name));
    const SpaceFormAtlas<2> atlas(form, space_form_net<2>(form, radius, 1, no_progress()).centres, radius);
    EXPECT_LT(check<2>(atlas, ratio(9, 2)), 40U) << name;
  }
}

TEST(ColoursOf, are_as_many_as_labels_where_all_are_in_sight) {
  const FlatAtlas<2> torus(cubic_torus<2>(), PointSet<2>(random_points<2>(150, 1)), ratio(1, 8));
  EXPECT_EQ(check<2>(torus, Rational(8)), 150U);
}

TEST(ColoursOf, go_on_from_those_that_are_known) {
  const FlatAtlas<2> torus(cubic_torus<2>(), PointSet<2>(random_points<2>(500, 1)), ratio(1, 30));
  const auto all = colours_of<2>(torus, ratio(9, 2), no_progress());
  for (const std::uint32_t first : {0U, 1U, 250U, 499U, 500U}) {
    const std::vector<std::uint32_t> known(all.begin(), all.begin() + first);
    EXPECT_EQ(more_colours_of<2>(torus, ratio(9, 2), known, 500, no_progress()), all);
  }
  EXPECT_EQ(more_colours_of<2>(torus, ratio(9, 2), {}, 300, no_progress()),
            std::vector<std::uint32_t>(all.begin(), all.begin() + 300));
  // What others have is not what it would be otherwise, and the others keep out of its way.
  auto given = more_colours_of<2>(torus, ratio(9, 2), {7}, 500, no_progress());
  EXPECT_EQ(given[0], 7U);
  EXPECT_NE(given, all);
}

TEST(ColoursOf, are_the_same_for_any_number_of_threads) {
  const FlatAtlas<2> torus(cubic_torus<2>(), PointSet<2>(random_points<2>(2500, 1)), ratio(1, 40));
  std::set<std::vector<std::uint32_t>> all;
  for (const unsigned limit : {1U, 2U, 4U}) {
    const ThreadLimit threads(limit);
    all.insert(colours_of<2>(torus, ratio(9, 2), no_progress()));
  }
  EXPECT_EQ(all.size(), 1U);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
