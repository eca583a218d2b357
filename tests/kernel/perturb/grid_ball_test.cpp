#include "kernel/perturb/grid_ball.hpp"

#include "tests/kernel/manifold/exhaustive.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

/// Drawing by the definition, in rationals.
template <int m>
Vector<Rational, m> slowly_drawn(CounterRandom& random, const FrameMetric<m>& metric, const Vector<Rational, m>& centre,
                                 const Rational& radius, long exponent) {
  const Rational step = Rational::power_of_two(exponent);
  while (true) {
    Vector<Rational, m> x;
    for (std::size_t axis = 0; axis < m; ++axis) {
      const Rational half = square_root_upper(square(radius) * metric.inverse_diagonal(axis), 32);
      const Integer first = floor_of((centre[axis] - half) / step);
      const Integer count = ceiling_of((centre[axis] + half) / step) - first + 1;
      Integer chosen = count;
      while (chosen >= count) chosen = random.next_integer(static_cast<unsigned>(msb(count)) + 1);
      x[axis] = Rational(Integer(first + chosen)) * step;
    }
    if (metric.template on<Rational>().squared_norm(difference(x, centre)) <= square(radius)) return x;
  }
}

template <int m>
void check(const FlatSpace<m>& space, long exponent, int draws) {
  const Rational radius = ratio(1, 40);
  const auto centres = random_points<m>(10, 3);
  const FilterGuard guard;
  const auto enclosed = space.metric.template on<Filter>();
  for (const auto& centre : centres) {
    GridBall<m> ball(space.metric, enclosed, centre, radius, exponent);
    for (int draw = 0; draw < draws; ++draw) {
      CounterRandom random(1, RandomPurpose::perturbation, 7, static_cast<std::uint32_t>(draw));
      CounterRandom same(1, RandomPurpose::perturbation, 7, static_cast<std::uint32_t>(draw));
      ball.draw(random);
      const auto x = ball.exact();
      EXPECT_EQ(x, slowly_drawn<m>(same, space.metric, centre, radius, exponent));
      EXPECT_EQ(random.next_word(), same.next_word());
      for (std::size_t axis = 0; axis < m; ++axis) {
        EXPECT_LE(Rational::exactly(ball.enclosure()[axis].lower()), x[axis]);
        EXPECT_GE(Rational::exactly(ball.enclosure()[axis].upper()), x[axis]);
        EXPECT_LE(ball.enclosure()[axis].upper() - ball.enclosure()[axis].lower(), 0x1p-50);
      }
    }
  }
}

TEST(GridBall, draws_what_the_definition_draws) {
  // Few steps and many; and so few that many of them are on the border.
  for (const long exponent : {-46L, -100L, -6L}) {
    check<1>(cubic_torus<1>(), exponent, 10);
    check<2>(hexagonal_torus(), exponent, 20);
    check<2>(square_torus_in_a_long_basis(), exponent, 5);
    check<3>(skewed_torus(), exponent, 10);
  }
}

TEST(GridBall, that_is_moved_draws_what_a_new_one_draws) {
  const FilterGuard guard;
  const auto space = hexagonal_torus();
  const auto enclosed = space.metric.on<Filter>();
  const auto centres = random_points<2>(6, 4);
  GridBall<2> moving(space.metric, enclosed, centres[0], ratio(1, 30), -46);
  for (std::uint32_t at = 0; at < 24; ++at) {
    // Another centre, another radius, both, and neither.
    const auto& centre = centres[at / 2 % 6];
    const Rational radius = ratio(1, at % 8 < 3 ? 30 : 17);
    moving.move_to(centre, radius);
    GridBall<2> fresh(space.metric, enclosed, centre, radius, -46);
    CounterRandom random(1, RandomPurpose::perturbation, at, 0);
    CounterRandom same(1, RandomPurpose::perturbation, at, 0);
    moving.draw(random);
    fresh.draw(same);
    EXPECT_EQ(moving.exact(), fresh.exact());
    EXPECT_LE(squared_distance<2>(space, moving.exact(), centre), square(radius));
  }
}

TEST(GridBall, holds_points_exactly_on_its_border) {
  // Steps of 1, radius 5: (±5, 0), (±3, ±4) … of 81 points.
  const FrameMetric<2> metric = FrameMetric<2>::cartesian();
  const FilterGuard guard;
  const auto enclosed = metric.on<Filter>();
  GridBall<2> ball(metric, enclosed, {Rational(0), Rational(0)}, Rational(5), 0);
  std::vector<Vector<Rational, 2>> seen;
  for (std::uint32_t draw = 0; draw < 2000; ++draw) {
    CounterRandom random(1, RandomPurpose::perturbation, draw, 0);
    ball.draw(random);
    seen.push_back(ball.exact());
  }
  std::sort(seen.begin(), seen.end());
  seen.erase(std::unique(seen.begin(), seen.end()), seen.end());
  EXPECT_EQ(seen.size(), 81U);
  EXPECT_EQ(std::count_if(seen.begin(), seen.end(),
                          [](const auto& x) { return square(x[0]) + square(x[1]) == Rational(25); }),
            12);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
