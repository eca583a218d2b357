#include "kernel/sample/sizing.hpp"

#include <cmath>
#include <fstream>

#include "kernel/random/counter_random.hpp"
#include "tests/kernel/manifold/submanifold/samples.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

TEST(Sizing, is_the_least_of_its_cones) {
  Sizing sizing(3, 0.5);
  const std::vector<double> origin{0, 0, 0};
  EXPECT_EQ(sizing.at(origin.data()), 0.5);
  EXPECT_EQ(sizing.least(), 0.5);
  // Enough of them for a tree, and some that are not in it.
  std::vector<Sizing::Cone> cones;
  CounterRandom random(5, RandomPurpose::darts, 0, 0);
  const auto unit = [&] { return random.next_unit(); };
  for (int k = 0; k < 300; ++k) {
    cones.push_back({{unit(), unit(), unit()}, 0.05 + 0.4 * unit(), k % 2 == 0 ? 0.25 : 1});
    sizing.add(cones.back());
  }
  for (int k = 0; k < 500; ++k) {
    const std::vector<double> x{2 * unit() - 0.5, unit(), unit()};
    double least = 0.5;
    for (const Sizing::Cone& cone : cones) {
      const double distance =
          std::sqrt((x[0] - cone.apex[0]) * (x[0] - cone.apex[0]) + (x[1] - cone.apex[1]) * (x[1] - cone.apex[1]) +
                    (x[2] - cone.apex[2]) * (x[2] - cone.apex[2]));
      least = std::min(least, cone.radius + cone.slope * distance);
    }
    EXPECT_EQ(sizing.at(x.data()), least);
    EXPECT_LE(sizing.least(), least);
  }
}

TEST(Sizing, follows_the_curvature) {
  const ZeroSet ellipsoid =
      zero_set("ellipsoid", {"x", "y", "z"}, {"x^2/4 + 4*y^2/9 + z^2 - 1"}, {ratio(5, 2), Rational(2), ratio(3, 2)});
  const Sizing sizing = sizing_of({"curvature:1/10,1/8"}, ellipsoid, 1, 1, no_progress());
  // Principal curvatures at the ends of the axes: 2, 8/9; 3/8, 3/2; 1/4, 4/9. No cone is above what a point asks for by
  // more than 1/8.
  const auto at = [&](std::vector<double> x) { return sizing.at(x.data()); };
  EXPECT_GE(at({2, 0, 0}), 0.05 * 0.999);
  EXPECT_LE(at({2, 0, 0}), 0.05 * 1.2);
  EXPECT_LE(at({0, 1.5, 0}), 0.1 / 1.5 * 1.2);
  EXPECT_GT(at({0, 0, 1}), at({0, 1.5, 0}));
  EXPECT_LT(at({0, 0, 1}), 0.26);
  const Sizing constant = sizing_of({""}, ellipsoid, 0.25, 1, no_progress());
  EXPECT_EQ(constant.size(), 0U);
  EXPECT_EQ(constant.at(std::vector<double>{2, 0, 0}.data()), 0.25);
}

TEST(Sizing, is_read_from_a_file) {
  const ZeroSet sphere = unit_sphere_in_space();
  const std::string file = ::testing::TempDir() + "sizing.txt";
  std::ofstream(file) << "# x y z radius slope\n1 0 0 1/8 1/2\n0 0 1 1/4 0\n";
  const Sizing sizing = sizing_of({file}, sphere, 1, 0, no_progress());
  EXPECT_EQ(sizing.size(), 2U);
  EXPECT_EQ(sizing.at(std::vector<double>{1, 0, 0.125}.data()), 0.1875);
  EXPECT_EQ(sizing.at(std::vector<double>{0, 0, -9}.data()), 0.25);
  const auto refusal = [&](const std::string& text) {
    std::ofstream(file) << text;
    return message_of<InputError>([&] { (void)sizing_of({file}, sphere, 1, 0, no_progress()); });
  };
  EXPECT_TRUE(mentions(refusal("1 0 0 0 1/2\n"), "the radius of a cone is above 0"));
  EXPECT_TRUE(mentions(refusal("1 0 0 1/2 -1\n"), "found 1/2 and -1"));
  EXPECT_TRUE(mentions(refusal("1 0 0 1/2\n"), ":1:"));
  const auto misread = [&](const std::string& text) {
    return message_of<InputError>([&] { (void)sizing_of({text}, sphere, 1, 0, no_progress()); });
  };
  EXPECT_TRUE(mentions(misread("curvature:1/10"), "expected curvature:K,NU"));
  EXPECT_TRUE(mentions(misread("curvature:1/10,0"), "0 is not above 0"));
  EXPECT_TRUE(mentions(misread("curvature:0.1,1"), "--sizing curvature:0.1,1"));
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
