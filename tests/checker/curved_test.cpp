#include "proofs/checker/geometry/curved.hpp"

#include <gtest/gtest.h>

#include <random>

#include "tests/checker/upwards.hpp"

namespace delcert::checker_tests {
namespace {

using checker::Ball;
using checker::Interval;
using checker::Vector;

class Curved : public testing::Test {
 protected:
  const test::Upwards upwards;

  double uniform() { return static_cast<double>(random_() >> 11) * 0x1p-53; }
  std::mt19937_64 random_{1};
};

Ball exactly(double x) {
  Ball result;
  arb_set_d(result.raw(), x);
  return result;
}

void expect_contains(const Interval& interval, const Ball& value, double tightness) {
  EXPECT_NE(less(value, exactly(interval.lower())), checker::Verdict::proved);
  EXPECT_NE(less(exactly(interval.upper()), value), checker::Verdict::proved);
  EXPECT_LE(interval.upper() - interval.lower(), tightness);
}

TEST_F(Curved, logarithm_factor_in_doubles_contains_that_of_256_bits) {
  for (int k = 0; k < 3000; ++k) {
    const double q = k < 10 ? k * 0x1p-1074 : std::ldexp(uniform(), -static_cast<int>(random_() % 60));
    for (const int K : {1, 0, -1}) {
      const Interval filtered = checker::logarithm_factor(K, Interval::between(q, q));
      checker::in_balls(256, [&] {
        expect_contains(filtered, checker::logarithm_factor(K, exactly(q)), q < 0.9 ? 0x1p-49 : 0x1p-44);
      });
    }
  }
}

TEST_F(Curved, exponential_and_logarithm_are_inverse_and_frames_are_isometries) {
  for (int k = 0; k < 200; ++k) {
    for (const int K : {1, 0, -1}) {
      const std::size_t m = 2 + random_() % 2;
      Vector<Ball> v{}, a{}, b{};
      const double size = K > 0 ? 1 : 0.5;
      const checker::BallScope scope(192);
      for (std::size_t i = 0; i < m; ++i) {
        v[i] = exactly(size * (uniform() - 0.5));
        a[i] = exactly(size * (uniform() - 0.5));
        b[i] = exactly(size * (uniform() - 0.5));
      }
      const Vector<Ball> at = conformal(m, checker::exponential(K, m, v));
      const Ball factor = checker::logarithm_factor(K, squared(at, m) / Ball(4));
      for (std::size_t i = 0; i < m; ++i) EXPECT_NE(arb_overlaps((factor * at[i]).raw(), v[i].raw()), 0);
      // The point of the frame is seen at o, and distances stay.
      const auto seen = [&](const Vector<Ball>& x) { return conformal(m, seen_from(K, m, a, linear(K, m, x))); };
      for (std::size_t i = 0; i < m; ++i) EXPECT_NE(arb_contains_zero(seen(a)[i].raw()), 0);
      const Ball before = squared_distance(K, m, v, b), after = squared_distance(K, m, seen(v), seen(b));
      EXPECT_NE(arb_overlaps(before.raw(), after.raw()), 0);
      EXPECT_LT(mag_get_d(arb_radref(after.raw())), 1e-40);
    }
  }
}

TEST_F(Curved, distances_from_o_are_lengths_of_tangent_vectors) {
  for (const int K : {1, 0, -1}) {
    const checker::BallScope scope(192);
    Vector<Ball> v{};
    v[0] = exactly(0.3);
    v[1] = exactly(0.4);
    const Ball length_squared = squared_distance(K, 2, Vector<Ball>{}, conformal(2, checker::exponential(K, 2, v)));
    EXPECT_NE(arb_overlaps(length_squared.raw(), squared(v, 2).raw()), 0);
    EXPECT_LT(mag_get_d(arb_radref(length_squared.raw())), 1e-40);
  }
}

}  // namespace
}  // namespace delcert::checker_tests
