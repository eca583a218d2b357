#include "kernel/sample/torus_sizing.hpp"

#include <cmath>
#include <fstream>

#include "kernel/random/counter_random.hpp"
#include "tests/kernel/manifold/exhaustive.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

/// By all lifts with shifts of up to 12 in each coordinate.
template <int m>
double distance_on(const FlatSpace<m>& space, const Vector<double, m>& x, const Vector<double, m>& y) {
  double least = 1e9;
  Shift<m> shift;
  shift.fill(-12);
  while (true) {
    Vector<double, m> offset;
    for (std::size_t axis = 0; axis < m; ++axis) offset[axis] = y[axis] + shift[axis] - x[axis];
    double squared = 0;
    for (std::size_t a = 0; a < m; ++a) {
      for (std::size_t b = 0; b < m; ++b)
        squared += offset[a] * approximate_double(space.metric.gram()[a][b]) * offset[b];
    }
    least = std::min(least, squared);
    std::size_t axis = 0;
    while (axis < m && ++shift[axis] > 12) shift[axis++] = -12;
    if (axis == m) return std::sqrt(least);
  }
}

template <int m>
void check_cones(const FlatSpace<m>& space) {
  const std::vector<Sizing::Cone> cones{{std::vector<double>(m, 0.875), 0.0625, 0.125},
                                        {std::vector<double>(m, -3.25), 0.125, 0.5},
                                        {std::vector<double>(m, 0.5), 0.1875, 0}};
  TorusSizing<m> sizing(space, 0.25);
  EXPECT_EQ(sizing.greatest(), 0.25);
  for (const auto& cone : cones) sizing.add(cone);
  EXPECT_EQ(sizing.least(), 0.0625);
  for (std::uint32_t place = 0; place < 100; ++place) {
    CounterRandom random(3, RandomPurpose::darts, place, 0);
    Vector<double, m> x;
    for (double& coordinate : x) coordinate = 4 * random.next_unit() - 2;
    double least = 0.25;
    for (const auto& cone : cones) {
      Vector<double, m> apex;
      std::copy(cone.apex.begin(), cone.apex.end(), apex.begin());
      least = std::min(least, cone.radius + cone.slope * distance_on<m>(space, x, apex));
    }
    EXPECT_NEAR(sizing.at(x), least, 1e-12);
  }
}

TEST(TorusSizing, is_the_least_of_its_cones_on_the_torus) {
  check_cones<1>(cubic_torus<1>());
  check_cones<2>(cubic_torus<2>());
  check_cones<2>(hexagonal_torus());
  check_cones<2>(square_torus_in_a_long_basis());
  check_cones<3>(skewed_torus());
}

TEST(TorusSizing, is_no_lower_than_its_cones_anywhere) {
  // The twin: a cone with its apex elsewhere.
  TorusSizing<2> sizing(cubic_torus<2>(), 0.25);
  sizing.add({{0, 0}, 0.0625, 0.25});
  EXPECT_EQ(sizing.at({0.5, 0}), 0.0625 + 0.125);
  EXPECT_EQ(sizing.at({0.75, 0}), 0.0625 + 0.0625);
  EXPECT_EQ(sizing.at({0, 7}), 0.0625);
}

TEST(TorusSizing, is_read_from_a_file) {
  const std::string file = ::testing::TempDir() + "torus-sizing.txt";
  std::ofstream(file) << "# x y radius slope\n1/2 1/2 1/16 1/64\n";
  const auto space = cubic_torus<2>();
  EXPECT_EQ(torus_sizing<2>({file}, space, 0.125).at({0.5, 0.5}), 0.0625);
  const auto refusal = [&](const std::string& text, const FlatSpace<2>& of) {
    return message_of<InputError>([&] { (void)torus_sizing<2>({text}, of, 0.125); });
  };
  EXPECT_TRUE(mentions(refusal("curvature:1/10,1/10", space), "a flat torus has no curvature"));
  EXPECT_TRUE(mentions(refusal(file, ball_of<2>(Rational(1))), "--sizing is for flat tori and submanifolds"));
  std::ofstream(file) << "1/2 1/2 1/2 1/16 1/64\n";
  EXPECT_TRUE(mentions(refusal(file, space), ":1:"));
}

TEST(TorusSizing, refuses_a_basis_that_is_too_skewed) {
  const Rational long_one(300000);
  const auto space = torus_of<2>({{{Rational(1), long_one}, {long_one, square(long_one) + Rational(1)}}});
  TorusSizing<2> sizing(space, 0.25);
  EXPECT_TRUE(mentions(message_of<InputError>([&] { sizing.add({{0, 0}, 0.0625, 0.125}); }), "too skewed"));
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
