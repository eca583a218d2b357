#include "kernel/sample/icosphere.hpp"

#include <gtest/gtest.h>

#include "kernel/manifold/space_form_file.hpp"
#include "kernel/sample/space_form_net.hpp"
#include "tests/kernel/manifold/quotient/samples.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

TEST(Icosphere, has_ten_points_for_each_square_of_the_frequency_and_two) {
  EXPECT_EQ(icosphere(1).size(), 12U);
  EXPECT_EQ(icosphere(2).size(), 42U);
  EXPECT_EQ(icosphere(7).size(), 492U);
}

TEST(Icosphere, is_even) {
  const SpaceForm sphere = verify_space_form(find_space_form("sphere-2"));
  // The icosahedron itself: faces have the circumradius 0.6524, edges the length 1.1071.
  const auto first = measured_net<2>(sphere, icosphere(1), ratio(65, 100));
  EXPECT_NEAR(first.covering_radius, 0.6523581397843682, 1e-12);
  EXPECT_NEAR(first.separation, 1.1071487177940904, 1e-12);
  // Divided: the edges' arcs are divided equally, and triangles stay close to equilateral ones.
  const auto net = measured_net<2>(sphere, icosphere(8), ratio(95, 1000));
  EXPECT_EQ(net.centres.size(), 642U);
  EXPECT_NEAR(net.separation, 1.1071487177940904 / 8, 1e-12);
  EXPECT_LT(net.covering_radius, 0.75 * net.separation);
}

TEST(Icosphere, refuses_frequencies) {
  EXPECT_EQ(message_of<InputError>([] { (void)icosphere(0); }),
            "the frequency of an icosphere is 0, expected 1 to 600");
  EXPECT_EQ(message_of<InputError>([] { (void)icosphere(601); }),
            "the frequency of an icosphere is 601, expected 1 to 600");
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
