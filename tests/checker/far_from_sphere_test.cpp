#include "proofs/checker/far_from_sphere.hpp"

#include <gtest/gtest.h>

#include <random>

#include "tests/checker/support/exact_double.hpp"
#include "tests/checker/upwards.hpp"

namespace delcert::checker_tests {
namespace {

using namespace checker;

struct FarFromSphereOfChecker : testing::Test, test::Upwards {};

struct Numbers {
  Vector<Interval> enclosed{};
  Vector<Rational> exact{};
};

/// Numbers at one end of intervals of this relative width.
Numbers numbers(std::mt19937_64& random, std::size_t m, double width) {
  Numbers result;
  for (std::size_t k = 0; k < m; ++k) {
    const double x = static_cast<double>(random() % 2001) / 1000 - 1,
                 end = x + (random() % 2 == 0 ? 1 : -1) * width * std::fabs(x);
    result.enclosed[k] = Interval::between(std::min(x, end), std::max(x, end));
    result.exact[k] = exact(end);
  }
  return result;
}

/// The points are so near to the sphere that only the bound of the error tells whether |P| is more than `small`.
TEST_F(FarFromSphereOfChecker, calls_no_point_far_that_is_not) {
  std::mt19937_64 random(1);
  int far = 0, open = 0;
  for (int k = 0; k < 200000; ++k) {
    const std::size_t m = 1 + random() % 4;
    const double width = random() % 2 == 0 ? 0 : std::ldexp(1.0, -20 - static_cast<int>(random() % 30));
    const Numbers y = numbers(random, m, width), c = numbers(random, m, random() % 2 == 0 ? 0 : width);
    const Rational product = dot(y.exact, c.exact, m);
    // s is near <y, c> + small, or - small.
    const double small = random() % 2 == 0 ? 0 : 0x1p-30;
    const Rational aim = random() % 2 == 0 ? product + exact(small) : product - exact(small);
    const double near = enclosure(aim).upper(), away = near + (static_cast<double>(random() % 65) - 32) * 0x1p-53;
    const double error = random() % 2 == 0 ? 0 : width;
    FarFromSphere points(m);
    points.add(y.enclosed, Interval::between(away - error, away));
    const Rational power = exact(away) - product;
    const bool is_far = less(exact(small), power) == Verdict::proved || less(power, -exact(small)) == Verdict::proved;
    const bool found = points.is_far(points.sphere(c.enclosed, small), 0);
    EXPECT_TRUE(is_far || !found) << "case " << k;
    far += found ? 1 : 0;
    open += is_far && !found ? 1 : 0;
    // Farther away there is no doubt.
    FarFromSphere others(m);
    others.add(y.enclosed, Interval::between(away + 0x1p-10, away + 0x1p-10));
    EXPECT_TRUE(others.is_far(others.sphere(c.enclosed, small), 0) || width > 0x1p-16);
  }
  EXPECT_GT(open, 1000) << "the bound is never needed";
  std::printf("%d far, %d left open\n", far, open);
}

/// As before, for the sphere of a pencil through the first point: the second one is so near to it that only the bound
/// of the error tells on which side it is.
TEST_F(FarFromSphereOfChecker, calls_no_point_far_from_a_sphere_of_a_pencil_that_is_not) {
  std::mt19937_64 random(2);
  int far = 0, open = 0;
  for (int k = 0; k < 100000; ++k) {
    const std::size_t m = 1 + random() % 4;
    const double width = random() % 2 == 0 ? 0 : std::ldexp(1.0, -20 - static_cast<int>(random() % 30));
    const Numbers y = numbers(random, m, width), z = numbers(random, m, width), c = numbers(random, m, width),
                  n = numbers(random, m, random() % 2 == 0 ? 0 : width);
    const double s = static_cast<double>(random() % 2001) / 1000;
    const Rational height = dot(y.exact, n.exact, m);
    if (height == Rational(0)) continue;
    const Rational t = (exact(s) - dot(y.exact, c.exact, m)) / height,
                   product = dot(z.exact, c.exact, m) + t * dot(z.exact, n.exact, m);
    const double factor = random() % 2 == 0 ? 0 : 0x1p-40;
    const Rational radius_squared = Rational(1) + Rational(2) * t * t, small = exact(factor) * radius_squared;
    // s of the second point is near <z, c + t n> + small, or - small.
    const double near = enclosure(random() % 2 == 0 ? product + small : product - small).upper(),
                 away = near + (static_cast<double>(random() % 65) - 32) *
                                   std::ldexp(1.0, -53 + static_cast<int>(random() % 20));
    FarFromSphere points(m);
    points.add(y.enclosed, Interval::between(s, s));
    points.add(z.enclosed, Interval::between(away, away));
    SpherePencil pencil;
    pencil.open(points, c.enclosed, Interval(1), n.enclosed, Interval(2));
    pencil.add(0);
    pencil.add(1);
    const SpherePencil::Sphere sphere = pencil.through(0, factor);
    EXPECT_NE(less(radius_squared, exact(sphere.least_radius_squared)), Verdict::proved) << "case " << k;
    const Rational power = exact(away) - product;
    const bool is_far = less(small, power) == Verdict::proved || less(power, -small) == Verdict::proved;
    const bool found = pencil.is_far(sphere, 1);
    EXPECT_TRUE(is_far || !found) << "case " << k;
    EXPECT_FALSE(pencil.is_far(sphere, 0)) << "its own point";
    far += found ? 1 : 0;
    open += is_far && !found ? 1 : 0;
  }
  EXPECT_GT(far, 1000);
  EXPECT_GT(open, 1000) << "the bound is never needed";
}

TEST_F(FarFromSphereOfChecker, leaves_open_what_has_no_sphere) {
  const Interval one(1), whole = Interval(1) / Interval::between(-1, 1);
  for (const auto& [y, s, n] : {std::tuple(Interval::between(-1, 1), one, one),
                                {one, one, whole},
                                {one, one, Interval(0)},
                                {one, whole, one}}) {
    FarFromSphere points(1);
    points.add({y}, s);
    points.add({one}, Interval(1000));
    SpherePencil pencil;
    pencil.open(points, {Interval(0)}, one, {n}, one);
    pencil.add(0);
    pencil.add(1);
    const SpherePencil::Sphere sphere = pencil.through(0, 0);
    EXPECT_FALSE(pencil.is_far(sphere, 1));
    EXPECT_FALSE(sphere.least_radius_squared > 2);
  }
}

TEST_F(FarFromSphereOfChecker, leaves_open_what_is_not_bounded) {
  const Interval whole = Interval(1) / Interval::between(-1, 1), one(1);
  for (const auto& [y, s, c] : {std::tuple(whole, one, one), {one, whole, one}, {one, one, whole}}) {
    FarFromSphere points(1);
    points.add({y}, s);
    points.add({one}, Interval(1000));
    const FarFromSphere::Sphere sphere = points.sphere({c}, 0);
    EXPECT_FALSE(points.is_far(sphere, 0));
    EXPECT_FALSE(points.is_far(sphere, 1));
  }
  FarFromSphere huge(1);
  huge.add({Interval::between(1e200, 1e200)}, one);
  EXPECT_FALSE(huge.is_far(huge.sphere({Interval::between(1e200, 1e200)}, 0), 0));
}

}  // namespace
}  // namespace delcert::checker_tests
