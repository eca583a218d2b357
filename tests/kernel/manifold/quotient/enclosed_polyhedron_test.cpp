#include "kernel/manifold/quotient/enclosed_polyhedron.hpp"

#include <gtest/gtest.h>

#include "kernel/manifold/quotient/element_table.hpp"
#include "kernel/manifold/space_form_file.hpp"
#include "kernel/number/rounding_guard.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

class EnclosedBolza : public testing::Test {
 protected:
  SpaceForm form_ = verify_space_form(find_space_form("bolza-surface"));
  ElementTable<2> table_{form_.form(), {form_.description.generators.front()}, form_.injectivity_radius.lower};
  RoundingGuard guard_;
  EnclosedPolyhedron<2> polyhedron_{form_.form(), *form_.polyhedron};

  /// On the geodesic from o to the centre of the tile across a side, at this fraction of the way.
  [[nodiscard]] ModelPoint<Interval, 2> towards_neighbour(int numerator, int denominator) const {
    const auto whole = logarithm<Interval, 2>(Curvature::negative, table_.centre(1));
    const Interval fraction = Interval(numerator) / Interval(denominator);
    return exponential<Interval, 2>(Curvature::negative, scaled(fraction, whole));
  }
};

TEST_F(EnclosedBolza, decides_what_is_inside) {
  EXPECT_TRUE(is_proved(polyhedron_.contains(towards_neighbour(0, 1))));
  EXPECT_TRUE(is_proved(polyhedron_.contains(towards_neighbour(499, 1000))));
  EXPECT_TRUE(is_refuted(polyhedron_.contains(towards_neighbour(501, 1000))));
  EXPECT_TRUE(is_undecided(polyhedron_.contains(towards_neighbour(1, 2))));
}

TEST_F(EnclosedBolza, measures_how_far_outside) {
  // The centre of the next tile is as far beyond the side as o is in front of it: half its displacement, r.
  const auto centre = table_.centre(1);
  const auto middle = towards_neighbour(1, 2);
  // sinh r is the length of the spatial part of the middle.
  const Interval sine = square_root(square(middle[1]) + square(middle[2]));
  EXPECT_TRUE(polyhedron_.is_certainly_farther(centre, sine * Interval(999) / Interval(1000)));
  EXPECT_FALSE(polyhedron_.is_certainly_farther(centre, sine * Interval(1001) / Interval(1000)));
  EXPECT_FALSE(polyhedron_.is_certainly_farther(towards_neighbour(1, 4), Interval(0)));
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
