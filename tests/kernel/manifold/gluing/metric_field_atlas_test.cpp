#include "kernel/manifold/gluing/metric_field_atlas.hpp"

#include <gtest/gtest.h>

#include <set>

#include "kernel/number/exact_text.hpp"
#include "tests/kernel/manifold/gluing/samples.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

using Field = MetricField<2>;
using Atlas2 = MetricFieldAtlas<2>;

Atlas2 sheared_atlas() { return {Field(shear()), lattice_points<2>(6), ratio(1, 16)}; }

/// |A_i v|².
Rational squared_length(const Atlas2& atlas, Label i, const Vector<Rational, 2>& v) {
  const auto seen = upper_applied(atlas.chart(i).matrix(), v);
  return pairing(seen, seen);
}

TEST(MetricFieldAtlas, has_charts_close_to_the_metric) {
  const auto atlas = sheared_atlas();
  ASSERT_EQ(atlas.size(), 36U);
  for (std::uint32_t index = 0; index < atlas.size(); ++index) {
    const Label i(index);
    const RoundingGuard guard;
    const auto exact = atlas.field().at<Interval>(atlas.centre(i));
    const Interval more = scalar_from<Interval>(Rational(1) + Rational::power_of_two(-26));
    EXPECT_TRUE(is_proved(is_below(atlas.enclosed_gram(i), more, exact)));
    EXPECT_TRUE(is_proved(is_below(exact, more, atlas.enclosed_gram(i))));
    EXPECT_TRUE(holds(atlas.enclosed_gram(i)[0][1], atlas.chart(i).gram()[0][1]));
    EXPECT_EQ(atlas.net().exact(i), (Vector<Rational, 2>{}));
  }
}

TEST(MetricFieldAtlas, sees_all_labels_within_a_distance) {
  const auto atlas = sheared_atlas();
  std::vector<Sighting<2>> seen;
  for (const std::uint32_t index : {0U, 7U, 35U}) {
    for (const double distance : {0.1, 0.26, 0.9}) {
      const Label i(index);
      atlas.sightings(i, distance, seen);
      EXPECT_TRUE(std::is_sorted(seen.begin(), seen.end()));
      const std::set<Sighting<2>> found(seen.begin(), seen.end());
      EXPECT_EQ(found.size(), seen.size());
      const Rational squared = square(Rational::exactly(distance));
      std::size_t expected = 0;
      for (std::uint32_t other = 0; other < atlas.size(); ++other) {
        for (std::int32_t a = -2; a <= 2; ++a) {
          for (std::int32_t b = -2; b <= 2; ++b) {
            const auto offset =
                difference(sum(atlas.centre(Label(other)), {Rational(a), Rational(b)}), atlas.centre(i));
            if (squared_length(atlas, i, offset) > squared) continue;
            ++expected;
            EXPECT_TRUE(found.contains({other, {a, b}})) << index << " " << other;
          }
        }
      }
      // And hardly any others.
      EXPECT_LE(seen.size(), expected + 1);
    }
  }
}

TEST(MetricFieldAtlas, neighbours_are_those_in_the_patch) {
  const auto atlas = sheared_atlas();
  for (const auto& other : atlas.neighbours(Label(5))) {
    const auto offset =
        difference(sum(atlas.centre(label_of<2>(other)), {Rational(other.shift[0]), Rational(other.shift[1])}),
                   atlas.centre(Label(5)));
    EXPECT_LE(squared_length(atlas, Label(5), offset), square(atlas.patch_radius()) * ratio(1000001, 1000000));
  }
  EXPECT_GE(atlas.neighbours(Label(5)).size(), 5U);
}

TEST(MetricFieldAtlas, transitions_are_exact_and_enclosed) {
  const auto atlas = sheared_atlas();
  const Vector<Rational, 2> home{ratio(1, 97), ratio(-1, 83)};
  for (const auto& other : atlas.neighbours(Label(0))) {
    const Label i(0);
    const Label j = label_of<2>(other);
    const auto exact = atlas.carry(i, other, home).value();
    // By way of the torus.
    auto x = atlas.position(j, home);
    for (std::size_t axis = 0; axis < 2; ++axis) x[axis] += Rational(other.shift[axis]) - atlas.centre(i)[axis];
    EXPECT_EQ(exact, upper_applied(atlas.chart(i).matrix(), x));
    // Back again.
    const Sighting<2> back{0, {-other.shift[0], -other.shift[1]}};
    EXPECT_EQ(atlas.carry(j, back, exact), home);

    const FilterGuard guard;
    const Vector<Filter, 2> enclosed{scalar_from<Filter>(home[0]), scalar_from<Filter>(home[1])};
    const auto filtered = atlas.carry(i, other, enclosed);
    const auto big = atlas.carry(i, other, {BigInterval(home[0]), BigInterval(home[1])});
    for (std::size_t axis = 0; axis < 2; ++axis) {
      EXPECT_LE(Rational::exactly(filtered[axis].lower()), exact[axis]);
      EXPECT_GE(Rational::exactly(filtered[axis].upper()), exact[axis]);
      EXPECT_LE(filtered[axis].upper() - filtered[axis].lower(), 1e-14);
      EXPECT_LE(big[axis].lower(), exact[axis]);
      EXPECT_GE(big[axis].upper(), exact[axis]);
      EXPECT_LE(big[axis].upper() - big[axis].lower(), Rational::power_of_two(-120));
    }
  }
}

TEST(MetricFieldAtlas, patches_are_as_large_as_the_torus_lets_them) {
  const Field flat(constant_field(multiple_of_identity(2, Rational(1))));
  const auto factor = [&](const Rational& radius) { return Atlas2(flat, lattice_points<2>(2), radius).patch_factor(); };
  // 3fε < 1.
  EXPECT_EQ(factor(ratio(1, 28)), 9);
  EXPECT_EQ(factor(ratio(1, 27)), 8);
  EXPECT_EQ(factor(ratio(1, 24)), 7);
  EXPECT_EQ(factor(ratio(1, 13)), 4);
  EXPECT_TRUE(mentions(message_of<Rejection>([&] { (void)factor(ratio(1, 12)); }), "is too large for patches"));
  // What the refusal advises is accepted.
  const Rational advised = fitting_sampling_radius(flat.eigenvalue_bounds());
  EXPECT_TRUE(mentions(message_of<Rejection>([&] { (void)factor(ratio(1, 12)); }), "at most " + exact_text(advised)));
  EXPECT_EQ(factor(advised), 4);
  EXPECT_GT(advised, ratio(1, 13));
  // Lengths are half as long along the first axis.
  const Field narrow(constant_field({{ratio(1, 4), Rational(0)}, {Rational(0), Rational(1)}}));
  EXPECT_EQ(Atlas2(narrow, lattice_points<2>(2), ratio(1, 28)).patch_factor(), 4);
  auto atlas = Atlas2(flat, lattice_points<2>(2), ratio(1, 28));
  atlas.set_patch_factor(5);
  EXPECT_EQ(atlas.patch_radius(), ratio(5, 28));
}

TEST(MetricFieldAtlas, refuses_what_is_no_net) {
  const Field field(shear());
  const auto refusal = [&](const std::vector<Vector<Rational, 2>>& points, const Rational& radius) {
    return message_of<InputError>([&] { (void)Atlas2(field, points, radius); });
  };
  EXPECT_EQ(refusal({}, ratio(1, 30)), "a net has at least one point");
  EXPECT_EQ(refusal(lattice_points<2>(2), Rational(0)), "the sampling radius is above 0");
  EXPECT_EQ(refusal({{Rational(0), Rational(0)}, {Rational(0), Rational(1)}}, ratio(1, 30)),
            "label 1 has the coordinate 1: points of the torus have coordinates in [0, 1)");
  EXPECT_TRUE(mentions(refusal({{ratio(-1, 9), Rational(0)}}, ratio(1, 30)), "label 0 has the coordinate -1/9"));
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
