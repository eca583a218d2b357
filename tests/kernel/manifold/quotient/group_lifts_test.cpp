#include "kernel/manifold/quotient/group_lifts.hpp"

#include <gtest/gtest.h>

#include <set>

#include "kernel/manifold/space_form_file.hpp"
#include "kernel/number/rounding_guard.hpp"
#include "kernel/sample/space_form_net.hpp"
#include "tests/kernel/manifold/quotient/samples.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

template <int m>
std::vector<ModelPoint<Interval, m>> points_of(const SpaceForm& form, const Rational& radius) {
  const auto net = space_form_net<m>(form, radius, 3, no_progress());
  const RoundingGuard guard;
  std::vector<ModelPoint<Interval, m>> result;
  for (const auto& centre : net.centres) {
    Vector<Interval, m> a;
    for (std::size_t axis = 0; axis < m; ++axis) a[axis] = scalar_from<Interval>(centre[axis]);
    result.push_back(model_point<Interval, m>(form.form().curvature(), a));
  }
  return result;
}

/// No lift by an element of a longer list is within reach, unless it is among the lifts.
template <int m>
void expect_complete(const std::string& name, const Rational& radius, double reach, const Rational& longer) {
  const SpaceForm form = verify_space_form(find_space_form(name));
  const Curvature curvature = form.form().curvature();
  const auto points = points_of<m>(form, radius);
  const LiftBounds bounds = [&] {
    const RoundingGuard guard;
    return lift_bounds<m>(form, points);
  }();
  EXPECT_EQ(bounds.in_polyhedron, curvature == Curvature::negative);
  const GroupLifts<m> lifts(form, bounds, reach);
  const ElementTable<m> all(form.form(), form.elements_within(longer), Rational(2) * form.injectivity_radius.lower);
  ASSERT_GE(all.size(), lifts.table().size());
  const RoundingGuard guard;
  const auto metric = chart_metric<m>(form.form()).template on<Interval>();
  std::size_t seen = 0;
  for (std::size_t j = 0; j < points.size(); j += 3) {
    std::set<std::uint32_t> found;
    lifts.for_each_lift(points[j], [&](std::uint32_t number, const ModelPoint<Interval, m>&) {
      found.insert(all.number_of(lifts.table().elements()[number]));
    });
    seen += found.size();
    for (std::uint32_t number = 1; number < all.size(); ++number) {
      if (found.contains(number)) continue;
      const auto lift = applied(all.matrix(number), points[j]);
      for (std::size_t i = 0; i < points.size(); i += 4) {
        const Interval chord = squared_chord<Interval, m>(curvature, metric, points[i], lift);
        ASSERT_GT(distance_of_chord(curvature, chord).lower(), reach);
      }
    }
  }
  EXPECT_GT(seen, 0U);
}

TEST(GroupLifts, misses_no_lift) {
  expect_complete<2>("bolza-surface", ratio(3, 10), 1, Rational(7));
  expect_complete<2>("projective-plane", ratio(1, 5), 1, Rational(0));
  expect_complete<2>("klein-bottle", ratio(1, 12), 0.5, Rational(5));
  expect_complete<3>("hantzsche-wendt", ratio(1, 6), 0.5, Rational(5));
  expect_complete<3>("lens-space-5-2", ratio(1, 5), 0.6, Rational(0));
}

TEST(GroupLifts, do_with_points_outside_of_the_polyhedron) {
  const SpaceForm form = verify_space_form(find_space_form("bolza-surface"));
  auto points = points_of<2>(form, ratio(3, 10));
  const double usual = [&] {
    const RoundingGuard guard;
    return lift_bounds<2>(form, points).radius;
  }();
  {
    const RoundingGuard guard;
    const ElementTable<2> table(form.form(), {form.description.generators.front()}, Rational(1));
    points.push_back(table.centre(1));
    const LiftBounds bounds = lift_bounds<2>(form, points);
    EXPECT_FALSE(bounds.in_polyhedron);
    EXPECT_GT(bounds.radius, usual);
  }
  // From there the tiles about the tile across the side are needed, too.
  const GroupLifts<2> near(form, {usual, true}, 1);
  const GroupLifts<2> all(form, {3.1, false}, 1);
  EXPECT_GT(all.table().size(), near.table().size());
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
