#include "kernel/manifold/submanifold/submanifold_atlas.hpp"

#include <algorithm>
#include <set>
#include <thread>

#include "kernel/number/rounding_guard.hpp"
#include "kernel/sample/submanifold_net.hpp"
#include "tests/kernel/manifold/submanifold/samples.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

SubmanifoldAtlas<2> atlas_of(const ZeroSet& m, const Rational& radius) {
  return {m, submanifold_net<2>(m, radius, 1, no_progress()).charts, radius, no_progress()};
}

bool holds(const Interval& enclosure, const Rational& x) {
  return Rational::exactly(enclosure.lower()) <= x && x <= Rational::exactly(enclosure.upper());
}

TEST(SubmanifoldAtlas, has_its_points_on_the_manifold) {
  const auto atlas = atlas_of(torus_of_revolution(), ratio(1, 12));
  const Vector<Rational, 2> home{ratio(1, 50), ratio(-1, 70)};
  const RoundingGuard guard;
  for (std::uint32_t index = 0; index < atlas.size(); index += 100) {
    const auto x =
        atlas.position<Interval>(Label(index), {scalar_from<Interval>(home[0]), scalar_from<Interval>(home[1])})
            .value();
    // The distance from the circle in the middle of the tube is 1.
    const Interval off = square_root(square(x[0]) + square(x[1])) - Interval(2);
    EXPECT_TRUE(holds(square(off) + square(x[2]), Rational(1)));
    EXPECT_LT(x[2].upper() - x[2].lower(), 1e-13);
    // At these coordinates of its chart, and those of BigInterval are inside.
    const auto big = atlas.position<BigInterval>(Label(index), {BigInterval(home[0]), BigInterval(home[1])}).value();
    for (std::size_t k = 0; k < 2; ++k)
      EXPECT_TRUE(holds(atlas.chart(Label(index)).enclosed().coordinate(x.data(), k), home[k]));
    for (std::size_t axis = 0; axis < 3; ++axis) {
      EXPECT_TRUE(holds(x[axis], big[axis].lower()));
      EXPECT_TRUE(holds(x[axis], big[axis].upper()));
      EXPECT_LE(big[axis].upper() - big[axis].lower(), Rational::power_of_two(-110));
    }
  }
  // Outside of the patch there is none.
  EXPECT_FALSE(atlas.position<Interval>(Label(0), {Interval(1), Interval(0)}));
}

TEST(SubmanifoldAtlas, sees_what_is_in_the_patch_and_nothing_through_the_hole) {
  // Two spheres with a gap that is narrower than patches are wide.
  const ZeroSet m =
      zero_set("gap", {"x", "y", "z"}, {"((x + 3/5)^2 + y^2 + z^2 - 1/4)*((x - 3/5)^2 + y^2 + z^2 - 1/4)"},
               std::vector<Rational>(3, ratio(3, 2)));
  const auto atlas = atlas_of(m, ratio(1, 24));
  ASSERT_GE(atlas.patch_radius(), ratio(1, 8));
  std::vector<Vector<double, 3>> centres;
  for (const TangentChart& chart : atlas.charts()) {
    Vector<double, 3>& centre = centres.emplace_back();
    for (std::size_t axis = 0; axis < 3; ++axis) centre[axis] = approximate_double(chart.data().centre[axis]);
  }
  const auto shell = [&](Label i) { return centres[i.value][0] > 0; };
  std::vector<Sighting<2>> seen;
  std::vector<Label> near;
  std::ptrdiff_t crossings = 0;
  for (std::uint32_t index = 0; index < atlas.size(); index += 23) {
    const Label i(index);
    for (const double distance : {0.05, 0.1, 0.12}) {
      atlas.sightings(i, distance, seen);
      EXPECT_TRUE(std::is_sorted(seen.begin(), seen.end()));
      std::set<std::uint32_t> found;
      for (const auto& sighting : seen) {
        found.insert(sighting.index);
        EXPECT_EQ(shell(label_of<2>(sighting)), shell(i));
      }
      EXPECT_TRUE(found.contains(index));
      // On one sheet, the projection of p_j to the plane of chart i.
      const auto& chart = atlas.chart(i).enclosed();
      const auto along = [&](const Vector<double, 3>& offset, std::size_t column) {
        double result = 0;
        for (std::size_t axis = 0; axis < 3; ++axis) result += chart.at(axis, column).lower() * offset[axis];
        return result;
      };
      std::size_t expected = 0;
      for (std::uint32_t other = 0; other < atlas.size(); ++other) {
        const auto offset = difference(centres[other], centres[index]);
        if (shell(Label(other)) != shell(i) || std::fabs(along(offset, 2)) > 0.25) continue;
        if (std::hypot(along(offset, 0), along(offset, 1)) > distance * (1 - 0x1p-20)) continue;
        ++expected;
        EXPECT_TRUE(found.contains(other)) << index << " " << other;
      }
      EXPECT_LE(found.size(), expected + 1);
    }
    near.clear();
    atlas.near(i, 0.25, near);
    crossings += std::count_if(near.begin(), near.end(), [&](Label other) { return shell(other) != shell(i); });
  }
  EXPECT_GT(crossings, 10);
  EXPECT_EQ(atlas.neighbours(Label(5)).size(), [&] {
    atlas.sightings(Label(5), approximate_double(atlas.patch_radius()), seen);
    return seen.size();
  }());
}

TEST(SubmanifoldAtlas, transitions_are_enclosed_and_never_exact) {
  const auto atlas = atlas_of(unit_sphere_in_space(), ratio(1, 10));
  const Label i(3);
  EXPECT_FALSE(atlas.has_exact_transitions());
  const Vector<Rational, 2> home{ratio(1, 97), ratio(-1, 83)};
  std::size_t others = 0;
  for (const auto& seen : atlas.neighbours(i)) {
    const bool is_itself = seen.index == i.value;
    EXPECT_EQ(atlas.carry(i, seen, home).has_value(), is_itself);
    const FilterGuard guard;
    const Vector<Filter, 2> enclosed{scalar_from<Filter>(home[0]), scalar_from<Filter>(home[1])};
    const auto filtered = atlas.carry(i, seen, enclosed);
    const auto big = atlas.carry(i, seen, {BigInterval(home[0]), BigInterval(home[1])});
    for (std::size_t axis = 0; axis < 2; ++axis) {
      EXPECT_LE(Rational::exactly(filtered[axis].lower()), big[axis].lower());
      EXPECT_GE(Rational::exactly(filtered[axis].upper()), big[axis].upper());
      EXPECT_LE(filtered[axis].upper() - filtered[axis].lower(), 1e-13);
      // What is remembered is what was found.
      EXPECT_EQ(atlas.carry(i, seen, enclosed)[axis].lower(), filtered[axis].lower());
    }
    if (!is_itself) ++others;
  }
  EXPECT_GT(others, 10U);
  // A place outside of the patch of its label could be anywhere.
  const FilterGuard guard;
  const auto lost = atlas.carry(i, atlas.neighbours(i).front(), Vector<Filter, 2>{Filter(1), Filter(0)});
  EXPECT_TRUE(i.value == atlas.neighbours(i).front().index || !(lost[0].upper() < 1e300));
}

TEST(SubmanifoldAtlas, tells_every_thread_the_same) {
  const auto atlas = atlas_of(unit_sphere_in_space(), ratio(1, 10));
  const Label i(7);
  const auto seen = atlas.neighbours(i);
  const auto look = [&](std::vector<double>& out) {
    const FilterGuard guard;
    for (int step = 1; step <= 40; ++step) {
      const Vector<Filter, 2> home{scalar_from<Filter>(ratio(step % 5, 100)), scalar_from<Filter>(ratio(1, 50))};
      for (const auto& sighting : seen) out.push_back(atlas.carry(i, sighting, home)[1].lower());
    }
  };
  std::array<std::vector<double>, 3> found;
  std::vector<std::thread> threads;
  for (auto& out : found) threads.emplace_back([&] { look(out); });
  for (auto& thread : threads) thread.join();
  EXPECT_EQ(found[0], found[1]);
  EXPECT_EQ(found[0], found[2]);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
