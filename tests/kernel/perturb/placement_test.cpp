#include "kernel/perturb/placement.hpp"

#include "kernel/sample/poisson_disk.hpp"
#include "support/error.hpp"
#include "tests/kernel/manifold/exhaustive.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

PerturbationParameters choosing(std::uint32_t choices) {
  PerturbationParameters parameters;
  parameters.separation = Rational(1);
  parameters.perturbation = ratio(1, 4);
  parameters.tolerance = ratio(1, 50);
  parameters.edge_bound = ratio(5, 2);
  parameters.circumradius_bound = Rational(2);
  parameters.seed = 1;
  parameters.choices = choices;
  if (choices > 1) parameters.clearance = ratio(1, 20);
  return parameters;
}

FlatAtlas<2> torus() {
  const auto space = hexagonal_torus();
  return {space, PointSet<2>(poisson_disk_net<2>(space, ratio(1, 20), 1, no_progress())), ratio(1, 20)};
}

/// Where label i is placed in this state.
Vector<Rational, 2> placed_at(const FlatAtlas<2>& atlas, const PerturbationParameters& parameters,
                              PlacedPoints<2> state, Label i) {
  state.placed[i.value] = 0;
  Placement<2>(atlas, parameters, state).place(i);
  return state.points.exact(i);
}

TEST(Placement, looks_no_farther_than_its_reach) {
  const auto atlas = torus();
  for (const std::uint32_t choices : {1U, 20U}) {
    const auto parameters = choosing(choices);
    EXPECT_EQ(Placement<2>::reach(parameters), choices > 1 ? ratio(9, 2) : Rational(3));
    PlacedPoints<2> state(atlas, parameters);
    Placement<2> placement(atlas, parameters, state);
    for (std::uint32_t index = 0; index < atlas.size(); ++index) placement.place(Label(index));
    const double reach = approximate_double(Placement<2>::reach(parameters)) / 20;
    std::size_t changed = 0;
    std::vector<Sighting<2>> seen;
    for (std::uint32_t index = 0; index < 40; ++index) {
      const auto before = placed_at(atlas, parameters, state, Label(index));
      atlas.sightings(Label(index), reach, seen);
      std::vector<bool> is_near(atlas.size(), false);
      for (const auto& sighting : seen) is_near[sighting.index] = true;
      // All that is far is taken away or elsewhere, then all that is near.
      for (const bool near : {false, true}) {
        PlacedPoints<2> other = state;
        {
          const FilterGuard guard;
          for (std::uint32_t far = 0; far < atlas.size(); ++far) {
            if (far == index || is_near[far] != near) continue;
            if (far % 2 == 0) other.placed[far] = 0;
            if (far % 2 == 1) other.points.place(Label(far), atlas.net().exact(Label(far)));
          }
        }
        const auto after = placed_at(atlas, parameters, other, Label(index));
        if (!near) {
          EXPECT_EQ(after, before) << index;
        } else if (after != before) {
          ++changed;
        }
      }
    }
    EXPECT_GT(changed, choices > 1 ? 30U : 3U);
  }
}

TEST(Placement, writes_nothing_but_its_label_and_counts_what_it_did) {
  const auto atlas = torus();
  const auto parameters = choosing(20);
  PlacedPoints<2> state(atlas, parameters);
  PerturbationStatistics all;
  for (std::uint32_t index = 0; index < 30; ++index) {
    const PlacedPoints<2> before = state;
    Placement<2> placement(atlas, parameters, state);
    placement.place(Label(index));
    EXPECT_EQ(placement.statistics().placements, 1U);
    EXPECT_EQ(placement.statistics().tries, state.attempts[index]);
    all += placement.take_statistics();
    EXPECT_EQ(placement.statistics().placements, 0U);
    EXPECT_EQ(placement.statistics().visited, 0U);
    for (std::uint32_t other = 0; other < atlas.size(); ++other) {
      EXPECT_EQ(state.placed[other] == 1, other <= index);
      if (other == index) continue;
      EXPECT_EQ(state.points.exact(Label(other)), before.points.exact(Label(other)));
      EXPECT_EQ(state.attempts[other], before.attempts[other]);
    }
  }
  EXPECT_EQ(all.placements, 30U);
  EXPECT_GE(all.tries, 20U * 30U);
  EXPECT_GE(all.most_tries, 20U);
  EXPECT_LE(all.most_tries, all.tries);
  EXPECT_LE(all.most_candidates, all.candidates);
}

TEST(Placement, names_the_label_that_cannot_be_placed) {
  const auto atlas = torus();
  auto parameters = choosing(1);
  parameters.tolerance = ratio(2, 5);
  parameters.most_tries = 50;
  PlacedPoints<2> state(atlas, parameters);
  Placement<2> placement(atlas, parameters, state);
  std::uint32_t index = 0;
  try {
    for (; index < atlas.size(); ++index) placement.place(Label(index));
    ADD_FAILURE() << "all were placed";
  } catch (const Rejection& rejection) {
    EXPECT_TRUE(mentions(rejection.what(), "label " + std::to_string(index) + " in 50 tries")) << rejection.what();
  }
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
