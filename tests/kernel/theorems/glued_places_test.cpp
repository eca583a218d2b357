#include "kernel/theorems/glued_places.hpp"

#include <gtest/gtest.h>

#include "tests/kernel/theorems/glued_run.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

TEST(GluedPlaces, are_where_the_inversion_takes_points) {
  const auto& [atlas, run] = fine_sphere();
  const GluedPlaces<2> places(atlas, run.points);
  ASSERT_EQ(places.labels(), atlas.size());
  ASSERT_EQ(places.charts(), 2U);
  std::size_t in_both = 0;
  for (std::uint32_t label = 0; label < atlas.size(); ++label) {
    const std::size_t home = places.home(label);
    const auto x = atlas.position(Label(label), run.points.exact(Label(label)));
    const Rational squared = square(x[0]) + square(x[1]);
    const bool is_inside =
        Rational(0) < squared && square(x[0] / squared) < Rational(4) && square(x[1] / squared) < Rational(4);
    const auto& there = places.place(1 - home, label);
    ASSERT_EQ(there.has_value(), is_inside) << label;
    ASSERT_TRUE(places.place(home, label).has_value());
    for (std::size_t axis = 0; axis < 2; ++axis) {
      const Interval& here = (*places.place(home, label))[axis];
      EXPECT_LE(Rational::exactly(here.lower()), x[axis]);
      EXPECT_LE(x[axis], Rational::exactly(here.upper()));
      if (!is_inside) continue;
      const Rational image = x[axis] / squared;
      EXPECT_LE(Rational::exactly((*there)[axis].lower()), image);
      EXPECT_LE(image, Rational::exactly((*there)[axis].upper()));
      EXPECT_LT((*there)[axis].upper() - (*there)[axis].lower(), 1e-12);
    }
    if (is_inside) ++in_both;
  }
  EXPECT_GT(in_both, atlas.size() / 4);
  EXPECT_LT(in_both, atlas.size());
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
