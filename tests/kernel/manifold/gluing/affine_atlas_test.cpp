#include "kernel/manifold/gluing/affine_atlas.hpp"

#include <gtest/gtest.h>

#include "tests/kernel/manifold/gluing/samples.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

/// The line ℝ² itself in charts of diag(1, 2)², with places for two labels.
class Plane final : public AffineAtlas<2> {
 public:
  Plane(std::vector<Vector<Rational, 2>> centres, Rational radius)
      : AffineAtlas<2>(std::move(centres), std::move(radius)) {
    make_charts([](Label) { return Matrix<Interval, 2>{{{Interval(1), Interval(0)}, {Interval(0), Interval(4)}}}; });
  }
  /// The factor for this much room, or 0 and where there is least.
  int factor(double room_of_first, double room_of_others) {
    const RoundingGuard guard;
    Label where{0};
    const bool fits =
        fit_patch_factor([&](Label i, std::size_t) { return i == Label(0) ? room_of_first : room_of_others; }, where);
    narrowest = where;
    return fits ? patch_factor() : 0;
  }
  Label narrowest{0};

  void sightings(Label i, double distance, std::vector<Sighting<2>>& out) const override {
    out.clear();
    const RoundingGuard guard;
    for (std::uint32_t j = 0; j < size(); ++j) {
      Vector<Interval, 2> offset;
      for (std::size_t axis = 0; axis < 2; ++axis)
        offset[axis] = scalar_from<Interval>(centre(Label(j))[axis] - centre(i)[axis]);
      if (may_be_within(i, offset, distance * distance)) out.push_back({j, {}, 0});
    }
  }

 private:
  template <class S>
  Vector<S, 2> difference_of(Label i, const Sighting<2>& seen, const Vector<S, 2>& moved) const {
    return sum(difference(centres().coordinates<S>(label_of<2>(seen)), centres().coordinates<S>(i)), moved);
  }
  Vector<Filter, 2> offset(Label i, const Sighting<2>& seen, const Vector<Filter, 2>& moved) const override {
    return difference_of<Filter>(i, seen, moved);
  }
  Vector<BigInterval, 2> offset(Label i, const Sighting<2>& seen, const Vector<BigInterval, 2>& moved) const override {
    return difference_of<BigInterval>(i, seen, moved);
  }
  Vector<Rational, 2> offset(Label i, const Sighting<2>& seen, const Vector<Rational, 2>& moved) const override {
    return difference_of<Rational>(i, seen, moved);
  }
};

Plane plane() { return {{{Rational(0), Rational(0)}, {ratio(1, 3), ratio(1, 5)}}, ratio(1, 10)}; }

TEST(AffineAtlas, carries_points_by_the_matrices_of_both_charts) {
  const Plane atlas = plane();
  const Sighting<2> seen{1, {}, 0};
  const Vector<Rational, 2> home{ratio(1, 7), ratio(1, 9)};
  const auto exact = atlas.carry(Label(0), seen, home).value();
  // (1/3 + 1/7, 2·(1/5 + 1/18)).
  EXPECT_EQ(exact, (Vector<Rational, 2>{ratio(10, 21), ratio(23, 45)}));
  EXPECT_EQ(atlas.carry(Label(1), {0, {}, 0}, exact), home);
  EXPECT_EQ(atlas.position(Label(1), home), (Vector<Rational, 2>{ratio(10, 21), ratio(23, 90)}));
  const FilterGuard guard;
  const Vector<Filter, 2> enclosed{scalar_from<Filter>(home[0]), scalar_from<Filter>(home[1])};
  const auto filtered = atlas.carry(Label(0), seen, enclosed);
  const auto big = atlas.carry(Label(0), seen, {BigInterval(home[0]), BigInterval(home[1])});
  for (std::size_t axis = 0; axis < 2; ++axis) {
    EXPECT_TRUE(holds(filtered[axis], exact[axis]));
    EXPECT_LE(filtered[axis].upper() - filtered[axis].lower(), 1e-15);
    EXPECT_LE(big[axis].lower(), exact[axis]);
    EXPECT_GE(big[axis].upper(), exact[axis]);
  }
  // What is not moved stays as it is, without rounding.
  const auto unmoved = atlas.carry(Label(1), seen, enclosed);
  EXPECT_EQ(unmoved[0].lower(), enclosed[0].lower());
  EXPECT_EQ(unmoved[1].upper(), enclosed[1].upper());
}

TEST(AffineAtlas, has_patches_as_large_as_the_room_allows) {
  // f·ε·stretch < room, with stretches 1 and 1/2 and ε = 1/10.
  EXPECT_EQ(plane().factor(1, 1), 9);
  EXPECT_EQ(plane().factor(0.95, 1), 9);
  EXPECT_EQ(plane().factor(0.85, 1), 8);
  EXPECT_EQ(plane().factor(0.41, 1), 4);
  EXPECT_EQ(plane().factor(0.39, 1), 0);
  EXPECT_EQ(plane().factor(1, 0), 0);
  Plane narrow = plane();
  EXPECT_EQ(narrow.factor(1, 0.375), 0);
  EXPECT_EQ(narrow.narrowest, Label(1));
}

TEST(AffineAtlas, sees_what_may_be_within_a_distance) {
  const Plane atlas = plane();
  std::vector<Sighting<2>> seen;
  // The distance is √(1/9 + 4/25) = 0.5206….
  atlas.sightings(Label(0), 0.5207, seen);
  EXPECT_EQ(seen.size(), 2U);
  atlas.sightings(Label(0), 0.5206, seen);
  EXPECT_EQ(seen.size(), 1U);
  EXPECT_EQ(atlas.neighbours(Label(0)).size(), 2U);
}

TEST(AffineAtlas, refuses_an_empty_net_and_a_radius_of_0) {
  EXPECT_EQ(message_of<InputError>([] { (void)Plane({}, Rational(1)); }), "a net has at least one point");
  EXPECT_EQ(message_of<InputError>([] {
              (void)Plane({{Rational(0), Rational(0)}}, Rational(0));
            }),
            "the sampling radius is above 0");
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
