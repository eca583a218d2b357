#include "kernel/sample/space_form_net.hpp"

#include <gtest/gtest.h>

#include "kernel/chart/lift_grid.hpp"
#include "kernel/manifold/quotient/space_form_atlas.hpp"
#include "kernel/manifold/space_form_file.hpp"
#include "kernel/number/exact_text.hpp"
#include "kernel/random/counter_random.hpp"
#include "tests/kernel/manifold/quotient/samples.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

/// Pairwise distances, certified, and points everywhere, tried at random.
template <int m>
void expect_maximal(const std::string& name, const Rational& radius, double least_count, double most_count) {
  const SpaceForm form = verify_space_form(find_space_form(name));
  const auto net = space_form_net<m>(form, radius, 11, no_progress());
  const double r = approximate_double(radius);
  const auto count = static_cast<double>(net.centres.size());
  EXPECT_GE(count, least_count);
  EXPECT_LE(count, most_count);
  EXPECT_GE(net.separation, r * (1 - 1e-9));
  EXPECT_LE(net.covering_radius, r * (1 + 1e-8));
  EXPECT_GE(net.covering_radius, r * 0.9);
  const SpaceFormAtlas<m> atlas(form, net.centres, radius, 5);
  const RoundingGuard guard;
  const Rational least = square(radius * (Rational(1) - Rational::power_of_two(-20)));
  const auto metric = atlas.metric().template on<Interval>();
  std::vector<Sighting<m>> seen;
  for (std::uint32_t i = 0; i < atlas.size(); ++i) {
    atlas.sightings(Label(i), 1.5 * r, seen);
    for (const auto& other : seen) {
      if (other.index == i && other.element == 0) continue;
      const auto x = atlas.carry(Label(i), other, Vector<Filter, m>{});
      EXPECT_TRUE(is_proved(less(scalar_from<Interval>(least), metric.squared_norm(x))));
    }
    // A place that few points are near: somewhere about p_i, at twice the radius.
    CounterRandom random(3, RandomPurpose::instances, i, 0);
    Vector<Filter, m> v;
    for (auto& coordinate : v) coordinate = Filter::exactly((2 * random.next_unit() - 1) * r);
    const auto place = atlas.template lift<Filter>({i, {}}, v);
    atlas.sightings_near(place, r * (1 + 0x1p-20), seen);
    EXPECT_FALSE(seen.empty());
  }
}

TEST(SpaceFormNet, is_separated_and_dense) {
  // About 0.7 area/r², 0.74 volume/r³.
  expect_maximal<2>("sphere-2", ratio(1, 10), 800, 950);
  expect_maximal<2>("projective-plane", ratio(1, 10), 400, 475);
  expect_maximal<2>("klein-bottle", ratio(1, 16), 160, 200);
  expect_maximal<2>("bolza-surface", ratio(1, 6), 290, 350);
  expect_maximal<3>("lens-space-5-2", ratio(1, 13), 5500, 7500);
  expect_maximal<3>("sphere-3", ratio(1, 4), 800, 1100);
}

TEST(SpaceFormNet, is_the_same_for_a_seed) {
  const SpaceForm form = verify_space_form(find_space_form("bolza-surface"));
  const auto first = space_form_net<2>(form, ratio(1, 4), 1, no_progress()).centres;
  EXPECT_EQ(space_form_net<2>(form, ratio(1, 4), 1, no_progress()).centres, first);
  EXPECT_NE(space_form_net<2>(form, ratio(1, 4), 2, no_progress()).centres, first);
  for (const auto& centre : first) {
    for (const auto& coordinate : centre) {
      EXPECT_EQ(Rational::exactly(approximate_double(coordinate)), coordinate);
      EXPECT_EQ((coordinate * Rational::power_of_two(48)).denominator(), 1);
    }
  }
}

/// FNV-1a of the exact texts of all coordinates.
template <int m>
std::uint64_t digest_of(const std::string& name, const Rational& radius) {
  const SpaceForm form = verify_space_form(find_space_form(name));
  std::uint64_t digest = 1469598103934665603U;
  for (const auto& centre : space_form_net<m>(form, radius, 1, no_progress()).centres) {
    for (const auto& coordinate : centre) {
      for (const char letter : exact_text(coordinate)) {
        digest = (digest ^ static_cast<unsigned char>(letter)) * 1099511628211U;
      }
    }
  }
  return digest;
}

TEST(SpaceFormNet, is_the_same_by_every_compiler) {
  // Middles of enclosures, computed next to the end of a guard, were rounded as the compiler liked. Found by both.
  EXPECT_EQ(digest_of<3>("sphere-3", ratio(1, 5)), 0x52ec9ee22629c11eU);
  EXPECT_EQ(digest_of<2>("bolza-surface", ratio(1, 8)), 0x14f94ea3c3e58361U);
}

TEST(SpaceFormNet, refuses_radii_that_do_not_fit) {
  const SpaceForm form = verify_space_form(find_space_form("klein-bottle"));
  EXPECT_EQ(message_of<Rejection>([&] { (void)space_form_net<2>(form, ratio(1, 5), 1, no_progress()); }),
            "klein-bottle: the radius of a net is at most a third of the injectivity radius: take at most 1/6");
  EXPECT_EQ(message_of<InputError>([&] { (void)space_form_net<2>(form, Rational(0), 1, no_progress()); }),
            "the radius of a net is above 0");
}

TEST(SpaceFormNet, relaxes) {
  const SpaceForm form = verify_space_form(find_space_form("projective-plane"));
  const auto net = space_form_net<2>(form, ratio(1, 10), 1, no_progress());
  const auto relaxed = relaxed_net<2>(form, net.centres, ratio(1, 10), 15, no_progress());
  EXPECT_EQ(relaxed.centres.size(), net.centres.size());
  // From about 1 of a Poisson-disk set towards √3 of the hexagonal lattice.
  EXPECT_LT(net.separation, 1.01 * net.covering_radius);
  EXPECT_GT(relaxed.separation, 1.02 * relaxed.covering_radius);
  EXPECT_EQ(relaxed_net<2>(form, net.centres, ratio(1, 10), 0, no_progress()).centres, net.centres);
}

TEST(SpaceFormNet, measures_points_of_any_origin) {
  const SpaceForm form = verify_space_form(find_space_form("klein-bottle"));
  const auto net = space_form_net<2>(form, ratio(1, 8), 1, no_progress());
  auto shifted = net.centres;
  for (auto& centre : shifted) centre[1] += Rational(3);
  const auto measured = measured_net<2>(form, shifted, ratio(1, 8));
  EXPECT_EQ(measured.centres, net.centres);
  EXPECT_DOUBLE_EQ(measured.separation, net.separation);
  EXPECT_DOUBLE_EQ(measured.covering_radius, net.covering_radius);
  // Without one of its points there is a gap.
  shifted.pop_back();
  EXPECT_GT(measured_net<2>(form, shifted, ratio(1, 8)).covering_radius, 1.05 * net.covering_radius);
}

TEST(SpaceFormNet, says_what_it_does) {
  const SpaceForm form = verify_space_form(find_space_form("klein-bottle"));
  std::vector<std::string> stages;
  (void)space_form_net<2>(form, ratio(1, 8), 1, [&](std::string_view stage, std::size_t, std::size_t) {
    if (stages.empty() || stages.back() != stage) stages.emplace_back(stage);
  });
  EXPECT_EQ(stages, (std::vector<std::string>{"throw darts", "fill gaps"}));
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
