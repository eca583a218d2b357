#include "kernel/manifold/quotient/distortion.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <random>

#include "kernel/manifold/quotient/transition.hpp"
#include "tests/kernel/manifold/quotient/samples.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

constexpr std::array curved{Curvature::negative, Curvature::positive};

using Point = Vector<Rational, 2>;
using Enclosure = Vector<BigInterval, 2>;

Enclosure enclosed(const Point& x) { return {BigInterval(x[0]), BigInterval(x[1])}; }

BigInterval squared_length(const Enclosure& x) { return square(x[0]) + square(x[1]); }

/// Two charts, the centre of the second at the conformal coordinates (15/32, 0) about the first: at the distance
/// 0.4604… on the sphere, 0.4777… in the hyperbolic plane.
class TwoCharts {
 public:
  static Rational nearer() { return ratio(46, 100); }
  static Rational farther() { return ratio(1, 2); }

  explicit TwoCharts(Curvature curvature)
      : curvature_(curvature),
        matrix_(transition_matrix<2>(InvariantForm::standard(curvature, 2), FieldMatrix::identity(3), Point{},
                                     {ratio(15, 32), Rational(0)})) {}

  [[nodiscard]] Enclosure transition(const Point& x) const {
    return carried<BigInterval, 2>(curvature_, matrix_, enclosed(x));
  }
  [[nodiscard]] BigInterval squared_distance(const Point& x, const Point& y) const {
    const auto step = difference(exponential<BigInterval, 2>(curvature_, enclosed(x)),
                                 exponential<BigInterval, 2>(curvature_, enclosed(y)));
    const BigInterval side = square(step[1]) + square(step[2]);
    const BigInterval chord = curvature_ == Curvature::positive ? side + square(step[0]) : side - square(step[0]);
    return square(distance_of_chord(curvature_, chord));
  }

 private:
  Curvature curvature_;
  ModelMatrix<BigInterval, 2> matrix_;
};

/// Whether the first squared length is that of the second times a factor in [1 − ξ, 1 + ξ].
bool is_within(const BigInterval& changed, const BigInterval& original, double xi) {
  const Rational bound = Rational::exactly(xi);
  return is_proved(less_equal(changed, BigInterval(square(Rational(1) + bound)) * original)) &&
         is_proved(less_equal(BigInterval(square(Rational(1) - bound)) * original, changed));
}

bool is_inside(const Enclosure& x, const Rational& radius) {
  return is_proved(less_equal(squared_length(x), BigInterval(square(radius))));
}

/// Multiples of 1/64 in a square.
template <class Use>
void for_random_points(int count, std::uint64_t seed, const Use& use) {
  std::mt19937_64 random(seed);
  const auto coordinate = [&random] { return ratio(static_cast<long>(random() % 129) - 64, 64); };
  for (int k = 0; k < count; ++k) {
    const Point x{coordinate(), coordinate()};
    use(x, Point{coordinate(), coordinate()});
    use(x, Point{x[0] + ratio(1, 256), x[1]});
    use(x, Point{x[0], x[1] + ratio(1, 256)});
  }
}

TEST(Distortion, of_transitions_is_that_of_all_pairs_of_points_in_both_patches) {
  const Rational radius = ratio(3, 4);
  for (const Curvature curvature : curved) {
    const TwoCharts charts(curvature);
    const auto found = transition_distortion(curvature, radius, TwoCharts::farther());
    int used = 0;
    for_random_points(300, 1, [&](const Point& x, const Point& y) {
      const Enclosure u = charts.transition(x);
      const Enclosure v = charts.transition(y);
      if (!is_inside(enclosed(x), radius) || !is_inside(enclosed(y), radius)) return;
      if (!is_inside(u, radius) || !is_inside(v, radius)) return;
      ++used;
      const BigInterval original = squared_length(difference(enclosed(x), enclosed(y)));
      EXPECT_TRUE(is_within(squared_length(difference(u, v)), original, found.of_pairs.upper));
      EXPECT_TRUE(is_within(squared_length(difference(u, v)), original, found.proved));
    });
    EXPECT_GT(used, 100);
  }
}

TEST(Distortion, of_transitions_is_needed_across_the_line_through_the_centres) {
  const Rational radius = ratio(3, 4);
  for (const Curvature curvature : curved) {
    const TwoCharts charts(curvature);
    const auto known = transition_distortion(curvature, radius, TwoCharts::nearer());
    // Near the rim of the first patch beyond q; near the rim of the second, on the other side of p.
    const Rational at = curvature == Curvature::negative ? radius : TwoCharts::nearer() - radius;
    const Point x{at, ratio(1, 512)};
    const Point y{at, ratio(-1, 512)};
    const BigInterval original = squared_length(difference(enclosed(x), enclosed(y)));
    const BigInterval changed = squared_length(difference(charts.transition(x), charts.transition(y)));
    EXPECT_TRUE(is_within(changed, original, known.of_pairs.upper * 1.05));
    EXPECT_FALSE(is_within(changed, original, known.of_pairs.lower * 0.98));
  }
}

TEST(Distortion, of_transitions_is_enclosed_narrowly) {
  for (const Curvature curvature : curved) {
    for (const long thousandths : {10, 50, 100, 133}) {
      const Rational epsilon = ratio(thousandths, 1000);
      const auto found = transition_distortion(curvature, Rational(9) * epsilon, Rational(6) * epsilon);
      EXPECT_GT(found.of_pairs.lower, 0);
      EXPECT_LE(found.of_pairs.lower, found.of_pairs.upper);
      EXPECT_LE(found.of_pairs.upper, found.of_pairs.lower * 1.002);
      // 12ε², as against 81/6 ε² for charts one by one and 486ε² in the paper.
      const double squared = approximate_double(square(epsilon));
      EXPECT_GT(found.of_pairs.lower, 12 * squared);
      EXPECT_LT(found.of_pairs.upper, found.proved);
      EXPECT_LT(found.proved, (thousandths < 100 ? 14 : 17) * squared);
    }
  }
}

TEST(Distortion, of_large_patches_is_that_of_their_charts) {
  const auto sphere = transition_distortion(Curvature::positive, ratio(27, 20), ratio(9, 10));
  EXPECT_EQ(sphere.of_pairs.upper, sphere.proved);
  EXPECT_LT(sphere.of_pairs.lower, sphere.proved);
  const auto hyperbolic = transition_distortion(Curvature::negative, ratio(5, 2), ratio(5, 3));
  EXPECT_EQ(hyperbolic.of_pairs.upper, hyperbolic.proved);
}

TEST(Distortion, of_flat_manifolds_is_none) {
  const auto found = transition_distortion(Curvature::zero, ratio(1, 2), ratio(1, 3));
  EXPECT_EQ(found.proved, 0);
  EXPECT_EQ(found.of_pairs.upper, 0);
  EXPECT_EQ(metric_distortion(Curvature::zero, ratio(1, 2)), 0);
  EXPECT_EQ(chart_stretch(Curvature::zero, ratio(1, 2)), 1);
  EXPECT_EQ(ball_distortion(Curvature::zero, ratio(1, 2), ratio(1, 3)), 0);
}

TEST(Distortion, of_a_chart_against_the_space_is_attained_along_its_rim) {
  const Rational radius = ratio(3, 4);
  for (const Curvature curvature : curved) {
    const TwoCharts charts(curvature);
    const double eta = metric_distortion(curvature, radius);
    for_random_points(200, 2, [&](const Point& x, const Point& y) {
      if (!is_inside(enclosed(x), radius) || !is_inside(enclosed(y), radius) || x == y) return;
      EXPECT_TRUE(is_within(charts.squared_distance(x, y), squared_length(difference(enclosed(x), enclosed(y))), eta));
    });
    const Point x{radius, ratio(1, 512)};
    const Point y{radius, ratio(-1, 512)};
    const BigInterval original = squared_length(difference(enclosed(x), enclosed(y)));
    EXPECT_FALSE(is_within(charts.squared_distance(x, y), original, eta * 0.999));
    // The factor is that of η, or its inverse.
    const double stretch = chart_stretch(curvature, radius);
    EXPECT_NEAR(curvature == Curvature::negative ? stretch - 1 : 1 - 1 / stretch, eta, 1e-15);
  }
}

TEST(Distortion, of_a_ball_is_that_of_its_points_in_all_near_charts) {
  const Rational radius = ratio(1, 2);
  for (const Curvature curvature : curved) {
    const TwoCharts charts(curvature);
    const double xi = ball_distortion(curvature, radius, TwoCharts::farther());
    for_random_points(200, 3, [&](const Point& x, const Point& y) {
      if (!is_inside(enclosed(x), radius) || !is_inside(enclosed(y), radius) || x == y) return;
      const BigInterval original = squared_length(difference(enclosed(x), enclosed(y)));
      EXPECT_TRUE(is_within(squared_length(difference(charts.transition(x), charts.transition(y))), original, xi));
    });
    // At the point of the ball that is farthest from q.
    const Point x{-radius, ratio(1, 512)};
    const Point y{-radius, ratio(-1, 512)};
    const BigInterval original = squared_length(difference(enclosed(x), enclosed(y)));
    EXPECT_FALSE(is_within(squared_length(difference(charts.transition(x), charts.transition(y))), original, xi * 0.7));
  }
  EXPECT_EQ(ball_distortion(Curvature::positive, Rational(1), ratio(3, 5)), std::numeric_limits<double>::infinity());
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
