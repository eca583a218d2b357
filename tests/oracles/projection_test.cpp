// Level 5 says that no point of the complex is farther than ω from M and no point of M farther than ω from the complex.
// Newton's method in 200 binary digits on the one side, random points of M on the other.

#include <boost/multiprecision/mpfr.hpp>
#include <cmath>
#include <random>

#include "tests/oracles/submanifold_sample.hpp"
#include "tests/support/ratio.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

using Number = boost::multiprecision::number<boost::multiprecision::mpfr_float_backend<60>>;
using Place = std::array<Number, 3>;

/// The torus of the radii 2 and 1: its distance function is known, so that its nearest points are.
Number distance_from_torus(const Place& x) {
  const Number to_axis = sqrt(x[0] * x[0] + x[1] * x[1]);
  return abs(sqrt((to_axis - 2) * (to_axis - 2) + x[2] * x[2]) - 1);
}

/// By Newton's method along the gradient; 60 digits.
Number distance_from_zeros(const Place& start) {
  Place x = start;
  for (int round = 0; round < 60; ++round) {
    const Number s = x[0] * x[0] + x[1] * x[1] + x[2] * x[2] + 3;
    const Number f = s * s - 16 * (x[0] * x[0] + x[1] * x[1]);
    const Place gradient = {4 * s * x[0] - 32 * x[0], 4 * s * x[1] - 32 * x[1], 4 * s * x[2]};
    const Number length = gradient[0] * gradient[0] + gradient[1] * gradient[1] + gradient[2] * gradient[2];
    for (std::size_t axis = 0; axis < 3; ++axis) x[axis] -= f / length * gradient[axis];
  }
  Number squared = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) squared += (x[axis] - start[axis]) * (x[axis] - start[axis]);
  return sqrt(squared);
}

class Torus {
 public:
  [[nodiscard]] static const SubmanifoldSample<2>& sample() {
    static const SubmanifoldSample<2> result("torus-of-revolution", ratio(1, 8));
    return result;
  }
  /// A random point of a random triangle.
  [[nodiscard]] static Place point(std::mt19937_64& random) {
    const auto& triangle = sample().simplices[random() % sample().simplices.size()];
    std::uniform_real_distribution<double> uniform(0, 1);
    double u = uniform(random);
    double v = uniform(random);
    if (u + v > 1) {
      u = 1 - u;
      v = 1 - v;
    }
    const double weights[] = {1 - u - v, u, v};
    Place x{0, 0, 0};
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const std::vector<double> vertex = sample().position(triangle[corner]);
      for (std::size_t axis = 0; axis < 3; ++axis) x[axis] += Number(weights[corner]) * Number(vertex[axis]);
    }
    return x;
  }
};

/// The distance of a point from a triangle, in doubles.
double distance_from_triangle(const std::array<double, 3>& x, const std::array<std::vector<double>, 3>& corners) {
  const auto dot = [](const auto& a, const auto& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; };
  const auto minus = [](const auto& a, const auto& b) {
    return std::array<double, 3>{a[0] - b[0], a[1] - b[1], a[2] - b[2]};
  };
  const auto from_segment = [&](const auto& a, const auto& b) {
    const auto along = minus(b, a);
    const auto to = minus(x, a);
    const double t = std::clamp(dot(to, along) / dot(along, along), 0.0, 1.0);
    const std::array<double, 3> rest = {to[0] - t * along[0], to[1] - t * along[1], to[2] - t * along[2]};
    return std::sqrt(dot(rest, rest));
  };
  const auto u = minus(corners[1], corners[0]);
  const auto v = minus(corners[2], corners[0]);
  const auto w = minus(x, corners[0]);
  const double uu = dot(u, u), uv = dot(u, v), vv = dot(v, v), uw = dot(u, w), vw = dot(v, w);
  const double determinant = uu * vv - uv * uv;
  const double s = (vv * uw - uv * vw) / determinant;
  const double t = (uu * vw - uv * uw) / determinant;
  if (s >= 0 && t >= 0 && s + t <= 1) {
    const std::array<double, 3> rest = {w[0] - s * u[0] - t * v[0], w[1] - s * u[1] - t * v[1],
                                        w[2] - s * u[2] - t * v[2]};
    return std::sqrt(dot(rest, rest));
  }
  return std::min({from_segment(corners[0], corners[1]), from_segment(corners[1], corners[2]),
                   from_segment(corners[2], corners[0])});
}

TEST(Projection, of_points_of_the_complex_is_within_the_displacement) {
  const double displacement = approximate_double(Torus::sample().triangulation.displacement);
  std::mt19937_64 random(7);
  Number greatest = 0;
  constexpr int tries = 2000;
  for (int each = 0; each < tries; ++each) {
    const Place x = Torus::point(random);
    const Number distance = distance_from_torus(x);
    EXPECT_LE(distance, displacement);
    // Along the gradient it is a little farther, and in the same order.
    const Number by_newton = distance_from_zeros(x);
    EXPECT_GE(by_newton * Number(1.0000001), distance);
    EXPECT_LE(by_newton, displacement);
    greatest = max(greatest, distance);
  }
  // A quarter of ω would be refuted.
  EXPECT_GT(greatest * 4, displacement);
}

TEST(Projection, of_points_of_the_torus_to_the_complex_is_within_the_displacement) {
  const auto& sample = Torus::sample();
  const double displacement = approximate_double(sample.triangulation.displacement);
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> angle(0, 2 * std::acos(-1.0));
  double greatest = 0;
  constexpr int tries = 500;
  for (int each = 0; each < tries; ++each) {
    const double u = angle(random);
    const double v = angle(random);
    const std::array<double, 3> x = {(2 + std::cos(v)) * std::cos(u), (2 + std::cos(v)) * std::sin(u), std::sin(v)};
    double least = 10;
    for (const auto& triangle : sample.simplices) {
      const std::vector<double> first = sample.position(triangle[0]);
      if (std::fabs(first[0] - x[0]) + std::fabs(first[1] - x[1]) + std::fabs(first[2] - x[2]) > 1) continue;
      least = std::min(least,
                       distance_from_triangle(x, {first, sample.position(triangle[1]), sample.position(triangle[2])}));
    }
    EXPECT_LE(least, displacement);
    greatest = std::max(greatest, least);
  }
  EXPECT_GT(greatest * 4, displacement);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
