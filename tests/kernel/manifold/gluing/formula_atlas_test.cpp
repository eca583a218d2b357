#include "kernel/manifold/gluing/formula_atlas.hpp"

#include <gtest/gtest.h>

#include <set>

#include "kernel/manifold/gluing/gluing_check.hpp"
#include "tests/kernel/manifold/gluing/atlas_samples.hpp"
#include "tests/support/contains.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

std::shared_ptr<const ChartGluing> glued(const std::string& name) {
  return std::make_shared<const ChartGluing>(atlas_named(name));
}

/// The multiples of a step in the squares |x_k| ≤ 5/4 of both charts of the sphere, but those of the second that are at
/// places of the first.
std::vector<NetPlace<2>> places_on_sphere() {
  std::vector<NetPlace<2>> result;
  for (std::size_t chart = 0; chart < 2; ++chart) {
    for (long a = -6; a <= 6; ++a) {
      for (long b = -6; b <= 6; ++b) {
        const NetPlace<2> place{chart, {ratio(a, 6), ratio(b, 6)}};
        const bool is_new = chart == 0 || square(place.x[0]) + square(place.x[1]) < ratio(1, 2);
        if (is_new) result.push_back(place);
      }
    }
  }
  return result;
}

FormulaAtlas<2> sphere_atlas() { return {glued("sphere-2-stereographic"), places_on_sphere(), ratio(1, 9)}; }

/// Where a label is in the other chart of the sphere, or in its own.
Vector<Rational, 2> place_in(const FormulaAtlas<2>& atlas, std::size_t chart, Label j,
                             const Vector<Rational, 2>& home = {}) {
  const auto x = atlas.position(j, home);
  if (atlas.home_chart(j) == chart) return x;
  const Rational squared = square(x[0]) + square(x[1]);
  return {x[0] / squared, x[1] / squared};
}

TEST(FormulaAtlas, sees_all_labels_within_a_distance) {
  const auto atlas = sphere_atlas();
  ASSERT_GE(atlas.patch_factor(), 4);
  std::vector<Sighting<2>> seen;
  std::size_t in_another_chart = 0;
  for (const std::uint32_t index : {0U, 14U, 84U, 100U, 175U, 190U}) {
    const Label i(index);
    for (const double distance : {0.2, 0.3, 0.44}) {
      atlas.sightings(i, distance, seen);
      EXPECT_TRUE(std::is_sorted(seen.begin(), seen.end()));
      std::set<std::uint32_t> found;
      for (const auto& one : seen) {
        EXPECT_TRUE(found.insert(one.index).second) << "a label is seen once";
        EXPECT_EQ(one.element == 0, atlas.home_chart(label_of<2>(one)) == atlas.home_chart(i));
        if (one.element != 0) ++in_another_chart;
      }
      std::size_t expected = 0;
      for (std::uint32_t other = 0; other < atlas.size(); ++other) {
        const auto x = atlas.centre(Label(other));
        if (atlas.home_chart(Label(other)) != atlas.home_chart(i) && square(x[0]) + square(x[1]) < ratio(1, 8))
          continue;
        const auto offset = difference(place_in(atlas, atlas.home_chart(i), Label(other)), atlas.centre(i));
        const auto in_chart = upper_applied(atlas.chart(i).matrix(), offset);
        if (pairing(in_chart, in_chart) > square(Rational::exactly(distance))) continue;
        ++expected;
        EXPECT_TRUE(found.contains(other)) << index << " " << other;
      }
      EXPECT_LE(seen.size(), expected + 1);
    }
  }
  EXPECT_GE(in_another_chart, 10U);
}

TEST(FormulaAtlas, transitions_are_exact_and_enclosed) {
  const auto atlas = sphere_atlas();
  const Vector<Rational, 2> home{ratio(1, 97), ratio(-1, 83)};
  std::size_t across = 0;
  for (const std::uint32_t index : {0U, 14U, 84U, 175U}) {
    const Label i(index);
    for (const auto& other : atlas.neighbours(i)) {
      const Label j = label_of<2>(other);
      const auto exact = atlas.carry(i, other, home).value();
      const auto there = place_in(atlas, atlas.home_chart(i), j, home);
      EXPECT_EQ(exact, upper_applied(atlas.chart(i).matrix(), difference(there, atlas.centre(i))));
      if (other.element != 0) {
        ++across;
        // Back again: the inverse stands beside the transition.
        const Sighting<2> back{index, {}, static_cast<std::uint32_t>(ChartGluing::opposite(other.element - 1) + 1)};
        EXPECT_EQ(atlas.carry(j, back, exact), home);
      }
      const FilterGuard guard;
      const Vector<Filter, 2> enclosed{scalar_from<Filter>(home[0]), scalar_from<Filter>(home[1])};
      const auto filtered = atlas.carry(i, other, enclosed);
      const auto big = atlas.carry(i, other, {BigInterval(home[0]), BigInterval(home[1])});
      for (std::size_t axis = 0; axis < 2; ++axis) {
        EXPECT_TRUE(contains(filtered[axis], exact[axis]));
        EXPECT_LE(filtered[axis].upper() - filtered[axis].lower(), 1e-13);
        EXPECT_TRUE(contains(big[axis], exact[axis]));
        EXPECT_LE(big[axis].upper() - big[axis].lower(), Rational::power_of_two(-110));
      }
    }
  }
  EXPECT_GE(across, 10U);
}

TEST(FormulaAtlas, derivatives_are_those_of_all_points_near_by) {
  const auto atlas = sphere_atlas();
  const RoundingGuard guard;
  std::size_t looked_at = 0;
  std::set<std::uint32_t> visited;
  atlas.visit_derivatives(Label(14), [&](Label j, const Matrix<Interval, 2>& derivative) {
    visited.insert(j.value);
    if (atlas.home_chart(j) == atlas.home_chart(Label(14))) {
      EXPECT_EQ(derivative[0][0].lower(), 1);
      EXPECT_EQ(derivative[0][1].upper(), 0);
      return;
    }
    ++looked_at;
    // D(x/|x|²) = (1 − 2xxᵀ/|x|²)/|x|², at the point itself and a quarter of a radius away.
    for (const Rational& step : {Rational(0), ratio(1, 36)}) {
      const auto x = atlas.position(j, {step, Rational(0)});
      const Rational squared = square(x[0]) + square(x[1]);
      for (std::size_t row = 0; row < 2; ++row) {
        for (std::size_t column = 0; column < 2; ++column) {
          const Rational exact =
              (Rational(row == column ? 1 : 0) - Rational(2) * x[row] * x[column] / squared) / squared;
          EXPECT_TRUE(contains(derivative[row][column], exact));
        }
      }
    }
  });
  EXPECT_GE(looked_at, 3U);
  for (const auto& seen : atlas.neighbours(Label(14))) EXPECT_TRUE(visited.contains(seen.index));
}

TEST(FormulaAtlas, refuses_what_is_no_net_of_it) {
  const auto gluing = glued("sphere-2-stereographic");
  const auto refusal = [&](const std::vector<NetPlace<2>>& net, const Rational& radius) {
    return message_of<InputError>([&] { (void)FormulaAtlas<2>(gluing, net, radius); });
  };
  EXPECT_EQ(refusal({{0, {Rational(2), Rational(0)}}}, ratio(1, 10)),
            "label 0 has the coordinate 2, outside of the chart north");
  EXPECT_EQ(refusal({{2, {Rational(0), Rational(0)}}}, ratio(1, 10)), "label 0 is in no chart of the atlas");
  EXPECT_EQ(refusal({{0, {Rational(0), Rational(0)}}}, Rational(0)), "the sampling radius is above 0");
  const auto no_room = message_of<Rejection>([&] {
    (void)FormulaAtlas<2>(gluing, {{0, {ratio(15, 8), Rational(0)}}}, ratio(1, 10));
  });
  EXPECT_TRUE(mentions(no_room,
                       "sphere-2-stereographic: the sampling radius 1/10 is too large: a patch of 4 of it "
                       "about label 0 does not fit into the chart north"));
}

TEST(FormulaAtlas, divides_what_has_a_pole_in_it) {
  // The inversion is not defined at the centre, from where points may move to places that the other chart shows.
  auto description = atlas_named("sphere-2-stereographic");
  for (auto& chart : description.charts) chart.domain = Sides(2, {Rational(-8), Rational(8)});
  const auto gluing = std::make_shared<const ChartGluing>(description);
  const std::vector<NetPlace<2>> net{{0, {Rational(0), Rational(0)}}, {1, {Rational(1), Rational(0)}}};
  const FormulaAtlas<2> atlas(gluing, net, ratio(1, 2));
  for (const std::uint32_t index : {0U, 1U}) {
    // Each sees the other, which is a unit away, by the inversion, and itself.
    std::set<std::uint32_t> seen;
    for (const auto& one : atlas.neighbours(Label(index))) seen.insert(one.index);
    EXPECT_EQ(seen.contains(0), index == 0) << "the centre is nowhere else";
    EXPECT_TRUE(seen.contains(1));
  }
  // A point that is moved goes to where the inversion takes it.
  const auto moved = atlas.carry(Label(1), {0, {}, 1}, Vector<Rational, 2>{ratio(1, 8), Rational(0)}).value();
  const Rational place = Rational(1) / atlas.position(Label(0), {ratio(1, 8), Rational(0)})[0];
  EXPECT_EQ(moved[0], atlas.chart(Label(1)).matrix()[0][0] * (place - Rational(1)));
  EXPECT_THROW((void)atlas.carry(Label(1), {0, {}, 1}, Vector<Rational, 2>{}), Undecided);
}

TEST(FormulaAtlas, does_not_guess_where_a_transition_is_defined) {
  auto description = atlas_named("sphere-2-stereographic");
  description.transitions[0].where = {"x - 1"};
  const auto gluing = std::make_shared<const ChartGluing>(description);
  const auto undecided = message_of<Undecided>([&] {
    (void)FormulaAtlas<2>(gluing, {{0, {Rational(1), Rational(0)}}}, ratio(1, 10));
  });
  EXPECT_TRUE(mentions(undecided, "label 0: transition 1, from north to south is not certainly defined about it"));
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
