#include "kernel/simplex/sphere_form.hpp"

#include "kernel/simplex/sphere_stack.hpp"
#include "tests/kernel/manifold/exhaustive.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

template <int m>
Vector<Rational, m> exactly(const Vector<double, m>& x) {
  Vector<Rational, m> result;
  for (std::size_t axis = 0; axis < m; ++axis) result[axis] = Rational::exactly(x[axis]);
  return result;
}

/// Small integers: everything but the norms is computed exactly.
template <int m>
Vector<double, m> any_integers(std::mt19937_64& random) {
  Vector<double, m> result;
  for (double& coordinate : result) coordinate = static_cast<double>(random() % 15) - 7;
  return result;
}

template <int m>
void expect_form_of(const SphereForm<double, m>& form, const SphereStack<Rational, m>& stack,
                    const Vector<double, m>& y) {
  ASSERT_GT(form.weight, 0);
  const Rational weight = Rational::exactly(form.weight);
  for (std::size_t axis = 0; axis < m; ++axis)
    EXPECT_EQ(Rational::exactly(form.normal[axis]), Rational(2) * weight * stack.centre()[axis]);
  EXPECT_NEAR(form.norm, 2 * form.weight * std::sqrt(approximate_double(stack.squared_radius())), 1e-14 * form.norm);
  const auto exact_y = exactly<m>(y);
  const auto metric = FrameMetric<m>::cartesian().template on<Rational>();
  EXPECT_EQ(Rational::exactly(form.power(y, pairing(y, y))),
            weight * stack.power(exact_y, metric.squared_norm(exact_y)));
}

/// A point at distance d from the centre of a sphere of radius R.
TEST(CertainGap, is_above_0_only_for_what_is_farther_whatever_the_radius) {
  std::mt19937_64 random(11);
  const auto draw = [&random](unsigned most) { return Rational(Integer(random() % (4U * most)), Integer(4)); };
  int certain = 0;
  int wrong_beyond_the_bound = 0;
  for (int sample = 0; sample < 4000; ++sample) {
    const Rational bound = draw(8) + Rational(1);
    const Rational radius = draw(12);
    const Rational distance = draw(20);
    const Rational t = draw(3);
    const Rational weight = draw(5) + Rational(1);
    const Rational power = weight * (square(distance) - square(radius));
    const Rational signed_power = random() % 2 == 0 ? power : -power;
    if (certain_gap(signed_power, weight, t, bound) <= Rational(0)) continue;
    const bool is_farther = absolute(distance - radius) > t;
    if (radius < bound) {
      EXPECT_TRUE(is_farther);
      ++certain;
    } else if (!is_farther) {
      ++wrong_beyond_the_bound;
    }
  }
  EXPECT_GT(certain, 500);
  EXPECT_GT(wrong_beyond_the_bound, 0) << "of larger spheres it says nothing";
}

template <int m>
void check_forms(std::uint64_t seed) {
  std::mt19937_64 random(seed);
  const auto metric = FrameMetric<m>::cartesian().template on<Rational>();
  int simplices = 0;
  for (int sample = 0; sample < 200; ++sample) {
    std::array<Vector<double, m>, static_cast<std::size_t>(m)> edges;
    for (auto& edge : edges) edge = any_integers<m>(random);
    const auto y = any_integers<m>(random);
    SphereStack<Rational, m> stack(metric);
    SphereForm<double, m> form = point_form<double, m>();
    for (std::size_t k = 1; k <= m; ++k) {
      const auto& edge = edges[k - 1];
      const double squared = pairing(edge, edge);
      std::optional<SphereForm<double, m>> next;
      bool is_degenerate = false;
      if (k == m) {
        const FacetForm<double, m> facet(form, edges);
        const ApexForm<double> apex(facet, edge, squared);
        is_degenerate = apex.slope == 0;
        next = apex.form(facet);
        const auto probe = ApexForm<double>::probe(facet, y, pairing(y, y));
        const double power = apex.signed_power(probe);
        EXPECT_EQ(apex.slope < 0 ? -power : power, next->power(y, pairing(y, y)));
      } else if (k == 1) {
        next = edge_form<double, m>(edge);
        is_degenerate = squared == 0;
      } else {
        next = triangle_form<double, m>(edges[0], pairing(edges[0], edges[0]), edge, squared);
        is_degenerate = next->weight == 0;
      }
      const auto exact_edge = exactly<m>(edge);
      const Verdict non_degenerate = stack.push(exact_edge, metric.squared_norm(exact_edge));
      EXPECT_EQ(is_refuted(non_degenerate), is_degenerate);
      if (is_degenerate) break;
      form = *next;
      expect_form_of<m>(form, stack, y);
      ++simplices;
    }
  }
  EXPECT_GT(simplices, 150);
}

TEST(SphereForm, is_the_sphere_times_a_weight) {
  check_forms<1>(1);
  check_forms<2>(2);
  check_forms<3>(3);
}

/// The gap of a point at a distance d from the centre of a sphere of radius R.
SphereGap<double> gap_of(double distance, double radius, double t, double weight) {
  return {weight * (distance * distance - radius * radius), 2 * weight * radius, weight, t};
}

TEST(SphereGap, is_positive_exactly_beyond_the_distance) {
  const RoundingBound nothing;
  const SphereGap<RoundingBound> exact(nothing, nothing, nothing, nothing);
  const auto farther = [&](double distance, double radius, double t) {
    return is_farther(gap_of(distance, radius, t, 3), exact);
  };
  EXPECT_TRUE(is_proved(farther(10, 5, 4)));
  EXPECT_TRUE(is_undecided(farther(9, 5, 4))) << "a tie outside";
  EXPECT_TRUE(is_undecided(farther(1, 5, 4))) << "a tie inside";
  EXPECT_TRUE(is_refuted(farther(3, 5, 4)));
  EXPECT_TRUE(is_refuted(farther(7, 5, 4)));
  EXPECT_TRUE(is_proved(farther(0, 5, 4)));
  EXPECT_TRUE(is_refuted(farther(0, 1, 5))) << "inside a sphere that is smaller than the distance";
  EXPECT_TRUE(is_proved(farther(7, 1, 5)));
  EXPECT_TRUE(is_proved(farther(3, 0, 2))) << "a sphere that is a point";
}

TEST(SphereGap, within_its_error_decides_nothing) {
  const RoundingBound about = RoundingBound::of(1, 0.5);
  const SphereGap<RoundingBound> bound(about, RoundingBound(), RoundingBound(), RoundingBound());
  EXPECT_TRUE(is_undecided(is_farther(gap_of(std::sqrt(81.4), 5, 4, 1), bound)));
  EXPECT_TRUE(is_undecided(is_farther(gap_of(std::sqrt(80.6), 5, 4, 1), bound)));
  EXPECT_TRUE(is_proved(is_farther(gap_of(std::sqrt(81.6), 5, 4, 1), bound)));
  EXPECT_TRUE(is_refuted(is_farther(gap_of(std::sqrt(80.4), 5, 4, 1), bound)));
  EXPECT_TRUE(is_undecided(is_farther(gap_of(std::sqrt(0.6), 5, 4, 1), bound)));
  EXPECT_TRUE(is_proved(is_farther(gap_of(std::sqrt(0.4), 5, 4, 1), bound)));
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
