#include "kernel/manifold/quotient/space_form_atlas.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>

#include "kernel/manifold/space_form_file.hpp"
#include "kernel/sample/space_form_net.hpp"
#include "tests/kernel/manifold/quotient/samples.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

template <int m>
SpaceFormAtlas<m> atlas_of(const std::string& name, const Rational& radius, int factor = 9) {
  const SpaceForm form = verify_space_form(find_space_form(name));
  auto net = space_form_net<m>(form, radius, 5, no_progress());
  return SpaceFormAtlas<m>(form, std::move(net.centres), radius, factor);
}

template <class To, std::size_t n>
std::array<To, n> on(const std::array<Rational, n>& x) {
  std::array<To, n> result;
  for (std::size_t axis = 0; axis < n; ++axis) result[axis] = scalar_from<To>(x[axis]);
  return result;
}

template <int m>
Vector<Rational, m> small_step(const Rational& radius) {
  Vector<Rational, m> v;
  for (std::size_t axis = 0; axis < m; ++axis) v[axis] = radius * ratio(1, 5 + static_cast<long>(axis));
  return v;
}

template <std::size_t n>
void expect_contained(const std::array<BigInterval, n>& inner, const std::array<Filter, n>& outer, double most_width) {
  for (std::size_t axis = 0; axis < n; ++axis) {
    EXPECT_LE(Rational::exactly(outer[axis].lower()), inner[axis].lower());
    EXPECT_GE(Rational::exactly(outer[axis].upper()), inner[axis].upper());
    EXPECT_LE(outer[axis].upper() - outer[axis].lower(), most_width);
    EXPECT_LE(inner[axis].upper() - inner[axis].lower(), Rational::power_of_two(-200));
  }
}

void expect_same(const BigInterval& a, const BigInterval& b) {
  EXPECT_FALSE(is_proved(less(a, b)));
  EXPECT_FALSE(is_proved(less(b, a)));
  EXPECT_LE(a.upper() - a.lower(), Rational::power_of_two(-100));
  EXPECT_LE(b.upper() - b.lower(), Rational::power_of_two(-100));
}

/// What charts show of a few labels, on all rungs, and against distances in the model space.
template <int m>
void expect_consistent(const SpaceFormAtlas<m>& atlas, double most_width) {
  const double radius = approximate_double(atlas.sampling_radius());
  const auto step = small_step<m>(atlas.sampling_radius());
  const BigInterval::Precision precision(PrecisionBits{256});
  std::size_t through_the_group = 0;
  for (std::uint32_t i = 0; i < atlas.size(); i += static_cast<std::uint32_t>(atlas.size() / 7)) {
    std::vector<Sighting<m>> seen;
    atlas.sightings(Label(i), 3 * radius, seen);
    EXPECT_TRUE(std::is_sorted(seen.begin(), seen.end()));
    for (std::size_t at = 0; at < seen.size(); at += 3) {
      if (seen[at].element != 0) ++through_the_group;
      for (const auto& home : {Vector<Rational, m>{}, step}) {
        const auto big = atlas.carry(Label(i), seen[at], on<BigInterval>(home));
        {
          const FilterGuard guard;
          expect_contained(big, atlas.carry(Label(i), seen[at], on<Filter>(home)), most_width);
        }
        // Defect: where nothing is exact, a midpoint was called so.
        const auto exact = atlas.carry(Label(i), seen[at], home);
        ASSERT_EQ(exact.has_value(), atlas.curvature() == Curvature::zero);
        if (!exact) continue;
        for (std::size_t axis = 0; axis < m; ++axis) {
          EXPECT_LE(absolute((*exact)[axis] - big[axis].lower()), Rational::exactly(most_width));
        }
      }
      // The length of what the chart shows is the distance in the model space.
      const auto shown = atlas.carry(Label(i), seen[at], on<BigInterval>(Vector<Rational, m>{}));
      const auto metric = atlas.metric().template on<BigInterval>();
      ModelPoint<BigInterval, m> x = atlas.template lift<BigInterval>(seen[at], on<BigInterval>(Vector<Rational, m>{}));
      const auto p = model_point<BigInterval, m>(atlas.curvature(), on<BigInterval>(atlas.centre(Label(i))));
      const BigInterval distance =
          distance_of_chord(atlas.curvature(), squared_chord<BigInterval, m>(atlas.curvature(), metric, p, x));
      expect_same(square(distance), metric.squared_norm(shown));
      EXPECT_FALSE(is_proved(less(BigInterval(Rational::exactly(3.000001 * radius)), distance)));
    }
  }
  if (atlas.elements().size() > 1) {
    EXPECT_GT(through_the_group, 0U);
  }
}

TEST(SpaceFormAtlas, rungs_contain_each_other_and_lengths_are_distances) {
  expect_consistent(atlas_of<2>("sphere-2", ratio(3, 20)), 0x1p-46);
  expect_consistent(atlas_of<2>("projective-plane", ratio(1, 8)), 0x1p-46);
  expect_consistent(atlas_of<2>("bolza-surface", ratio(1, 8)), 0x1p-40);
  expect_consistent(atlas_of<2>("klein-bottle", ratio(1, 24)), 0x1p-50);
  expect_consistent(atlas_of<3>("hantzsche-wendt", ratio(1, 12), 3), 0x1p-50);
  expect_consistent(atlas_of<3>("lens-space-5-2", ratio(1, 10), 3), 0x1p-46);
}

TEST(SpaceFormAtlas, flat_transitions_are_exact) {
  const auto atlas = atlas_of<3>("hantzsche-wendt", ratio(1, 12), 3);
  ASSERT_TRUE(atlas.has_exact_transitions());
  const auto step = small_step<3>(atlas.sampling_radius());
  const auto metric = atlas.metric().on<Rational>();
  for (std::uint32_t i = 0; i < atlas.size(); i += static_cast<std::uint32_t>(atlas.size() / 6)) {
    for (const auto& seen : atlas.neighbours(Label(i))) {
      const auto moved = atlas.carry(Label(i), seen, step).value();
      const auto fixed = atlas.carry(Label(i), seen, Vector<Rational, 3>{}).value();
      EXPECT_EQ(metric.squared_norm(difference(moved, fixed)), metric.squared_norm(step));
      const auto big = atlas.carry(Label(i), seen, on<BigInterval>(step));
      for (std::size_t axis = 0; axis < 3; ++axis) {
        EXPECT_LE(big[axis].lower(), moved[axis]);
        EXPECT_GE(big[axis].upper(), moved[axis]);
      }
    }
  }
  EXPECT_FALSE(atlas_of<2>("sphere-2", ratio(3, 20)).has_exact_transitions());
}

/// The sightings within a distance, found by going through all labels and all elements of a longer list.
template <int m>
void expect_exhaustive(const SpaceFormAtlas<m>& atlas, const Rational& longer) {
  const Curvature curvature = atlas.curvature();
  const ElementTable<m> all(atlas.form().form(), atlas.form().elements_within(longer),
                            Rational(2) * atlas.form().injectivity_radius.lower);
  const double radius = approximate_double(atlas.patch_radius());
  std::size_t compared = 0;
  for (std::uint32_t i = 1; i < atlas.size(); i += static_cast<std::uint32_t>(atlas.size() / 4)) {
    const auto neighbours = atlas.neighbours(Label(i));
    std::vector<Sighting<m>> some;
    atlas.sightings(Label(i), radius / 3, some);
    const RoundingGuard guard;
    const auto metric = atlas.metric().template on<Interval>();
    const auto p = model_point<Interval, m>(curvature, on<Interval>(atlas.centre(Label(i))));
    for (std::uint32_t j = 0; j < atlas.size(); ++j) {
      const auto q = model_point<Interval, m>(curvature, on<Interval>(atlas.centre(Label(j))));
      for (std::uint32_t number = 0; number < all.size(); ++number) {
        const auto x = applied(all.matrix(number), q);
        const double distance =
            distance_of_chord(curvature, squared_chord<Interval, m>(curvature, metric, p, x)).lower();
        if (distance > radius * 1.001) continue;
        const Sighting<m> expected{j, {}, static_cast<std::uint32_t>(atlas.number_of(all.elements()[number]))};
        ++compared;
        const auto is_in = [&](const auto& list) { return std::binary_search(list.begin(), list.end(), expected); };
        EXPECT_EQ(is_in(neighbours), distance <= radius);
        EXPECT_EQ(is_in(some), distance <= radius / 3);
      }
    }
    EXPECT_LE(some.size(), neighbours.size());
  }
  EXPECT_GT(compared, 100U);
}

TEST(SpaceFormAtlas, sightings_are_those_of_an_exhaustive_search) {
  expect_exhaustive(atlas_of<2>("sphere-2", ratio(3, 20)), Rational(0));
  expect_exhaustive(atlas_of<2>("projective-plane", ratio(1, 8)), Rational(0));
  expect_exhaustive(atlas_of<2>("bolza-surface", ratio(1, 8)), Rational(7));
  expect_exhaustive(atlas_of<3>("lens-space-5-2", ratio(1, 10), 3), Rational(0));
  expect_exhaustive(atlas_of<3>("hantzsche-wendt", ratio(1, 12), 3), Rational(4));
}

template <int m>
void expect_compositions(const SpaceFormAtlas<m>& atlas) {
  const double radius = approximate_double(atlas.sampling_radius());
  const auto step = on<BigInterval>(small_step<m>(atlas.sampling_radius()));
  std::size_t nontrivial = 0;
  for (std::uint32_t i = 0; i < atlas.size(); i += static_cast<std::uint32_t>(atlas.size() / 20)) {
    std::vector<Sighting<m>> from_i;
    std::vector<Sighting<m>> from_j;
    atlas.sightings(Label(i), 2 * radius, from_i);
    for (const auto& j : from_i) {
      const std::uint32_t first = j.element;
      atlas.sightings(label_of<m>(j), 2 * radius, from_j);
      // j sees i through the inverse.
      const Sighting<m> back{i, {}, static_cast<std::uint32_t>(atlas.inverse(first))};
      EXPECT_TRUE(std::binary_search(from_j.begin(), from_j.end(), back));
      const auto k = from_j[from_j.size() / 2];
      const Sighting<m> direct{k.index, {}, static_cast<std::uint32_t>(atlas.product(first, k.element))};
      if (first != 0 && k.element != 0) ++nontrivial;
      const auto once = atlas.carry(Label(i), direct, step);
      const auto twice = atlas.carry(Label(i), j, atlas.carry(label_of<m>(j), k, step));
      for (std::size_t axis = 0; axis < m; ++axis) {
        EXPECT_FALSE(is_proved(less(once[axis], twice[axis])));
        EXPECT_FALSE(is_proved(less(twice[axis], once[axis])));
      }
    }
  }
  EXPECT_GT(nontrivial, 0U);
}

TEST(SpaceFormAtlas, sightings_compose_by_products) {
  expect_compositions(atlas_of<2>("projective-plane", ratio(1, 8)));
  expect_compositions(atlas_of<2>("bolza-surface", ratio(1, 8)));
  expect_compositions(atlas_of<2>("klein-bottle", ratio(1, 24)));
  expect_compositions(atlas_of<3>("lens-space-5-2", ratio(1, 10), 3));
}

TEST(SpaceFormAtlas, sees_from_any_point) {
  const auto atlas = atlas_of<2>("bolza-surface", ratio(1, 8));
  const double radius = approximate_double(atlas.sampling_radius());
  std::vector<Sighting<2>> by_label;
  std::vector<Sighting<2>> by_point;
  // From the list of the label, and beyond that; twice, when the list is made and when it is there.
  std::size_t shortest = 0;
  for (const double radii : {3.0, 1.0, 2.2, 4.4, 4.6, 8.0, 3.0}) {
    atlas.sightings(Label(3), radii * radius, by_label);
    const FilterGuard guard;
    by_point.clear();
    atlas.sightings_near(atlas.lift<Filter>({3, {}}, Vector<Filter, 2>{}), radii * radius, by_point);
    EXPECT_EQ(by_label, by_point);
    if (radii == 1.0) shortest = by_label.size();
  }
  EXPECT_LT(shortest, by_label.size());
  EXPECT_THROW(atlas.sightings(Label(3), 9.1 * radius, by_label), std::out_of_range);
}

TEST(SpaceFormAtlas, refuses_wrong_input) {
  const SpaceForm bolza = verify_space_form(find_space_form("bolza-surface"));
  EXPECT_EQ(
      message_of<InputError>([&] {
        const SpaceFormAtlas<2> atlas(bolza, {{Rational(0), Rational(0)}, {Rational(2), Rational(0)}}, ratio(1, 10));
      }),
      "label 1: the conformal coordinates of a point of hyperbolic space are less than 2 from 0");
  EXPECT_NE(message_of<Rejection>([&] {
              const SpaceFormAtlas<2> atlas(bolza, {{Rational(0), Rational(0)}}, ratio(1, 2));
            }).find("bolza-surface: 12 sampling radii are about 6.000000"),
            std::string::npos);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
