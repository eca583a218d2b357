#include "kernel/chart/model_space.hpp"

#include <gtest/gtest.h>

#include <random>

#include "kernel/number/rounding_guard.hpp"
#include "tests/kernel/number/arb_reference.hpp"
#include "tests/support/ratio.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

constexpr std::array curvatures{Curvature::negative, Curvature::zero, Curvature::positive};

/// Dyadic conformal coordinates of length below 2: in the ball of ℍᵐ.
template <int m>
Vector<Rational, m> some_coordinates(std::mt19937_64& random) {
  Vector<Rational, m> result;
  for (Rational& x : result) x = ratio(static_cast<long>(random() % 2001) - 1000, 1024);
  return result;
}

template <int m>
Rational form(Curvature curvature, const ModelPoint<Rational, m>& x, const ModelPoint<Rational, m>& y) {
  Rational result = Rational(sign_of(curvature)) * x[0] * y[0];
  for (std::size_t axis = 1; axis <= m; ++axis) result += x[axis] * y[axis];
  return result;
}

template <int m>
void expect_exact_frames() {
  std::mt19937_64 random(8);
  for (const Curvature curvature : curvatures) {
    for (int trial = 0; trial < 20; ++trial) {
      const auto a = some_coordinates<m>(random);
      const auto p = model_point<Rational, m>(curvature, a);
      const Rational k(sign_of(curvature));
      if (curvature != Curvature::zero) {
        EXPECT_EQ((form<m>(curvature, p, p)), k);
      }
      EXPECT_EQ((conformal_coordinates<Rational, m>(p)), a);
      const auto frame = model_frame<Rational, m>(curvature, a);
      const auto back = inverse_model_frame<Rational, m>(curvature, a);
      ModelPoint<Rational, m> origin{};
      origin[0] = Rational(1);
      EXPECT_EQ(applied(frame, origin), p);
      EXPECT_EQ(applied(back, p), origin);
      const auto one = product(frame, back);
      for (std::size_t row = 0; row <= m; ++row) {
        for (std::size_t column = 0; column <= m; ++column)
          EXPECT_EQ(one[row][column], Rational(row == column ? 1 : 0));
      }
      // Isometries: images of the basis have the products of the basis; in the flat case the first row is (1, 0, …).
      for (std::size_t i = 0; i <= m; ++i) {
        for (std::size_t j = 0; j <= m; ++j) {
          ModelPoint<Rational, m> ei{};
          ModelPoint<Rational, m> ej{};
          ei[i] = Rational(1);
          ej[j] = Rational(1);
          if (curvature == Curvature::zero && (i == 0 || j == 0)) continue;
          EXPECT_EQ((form<m>(curvature, applied(frame, ei), applied(frame, ej))), (form<m>(curvature, ei, ej)));
        }
      }
    }
  }
}

TEST(ModelSpace, frames_are_exact_isometries) {
  expect_exact_frames<2>();
  expect_exact_frames<3>();
}

TEST(ModelSpace, the_frame_at_the_origin_is_the_identity) {
  for (const Curvature curvature : curvatures) {
    const auto frame = model_frame<Rational, 2>(curvature, {});
    for (std::size_t row = 0; row < 3; ++row) {
      for (std::size_t column = 0; column < 3; ++column) EXPECT_EQ(frame[row][column], Rational(row == column ? 1 : 0));
    }
  }
}

template <class S>
Rational lower_of(const S& x) {
  if constexpr (std::same_as<S, Interval>) {
    return Rational::exactly(x.lower());
  } else {
    return x.lower();
  }
}

template <class S>
Rational upper_of(const S& x) {
  if constexpr (std::same_as<S, Interval>) {
    return Rational::exactly(x.upper());
  } else {
    return x.upper();
  }
}

template <class S, std::size_t n>
std::array<S, n> enclosed(const std::array<Rational, n>& x) {
  std::array<S, n> result;
  for (std::size_t axis = 0; axis < n; ++axis) result[axis] = scalar_from<S>(x[axis]);
  return result;
}

/// exp and log are inverse to each other, at all sizes, with an error relative to the vector.
template <class S, int m>
void expect_inverse(long bits) {
  std::mt19937_64 random(9);
  for (const Curvature curvature : curvatures) {
    for (const long exponent : {0L, -4L, -12L, -40L}) {
      for (int trial = 0; trial < 10; ++trial) {
        Vector<Rational, m> v = some_coordinates<m>(random);
        for (Rational& x : v) x *= Rational::power_of_two(exponent);
        const auto back = logarithm<S, m>(curvature, exponential<S, m>(curvature, enclosed<S>(v)));
        for (std::size_t axis = 0; axis < m; ++axis) {
          EXPECT_LE(lower_of(back[axis]), v[axis]);
          EXPECT_GE(upper_of(back[axis]), v[axis]);
          EXPECT_LE(upper_of(back[axis]) - lower_of(back[axis]), Rational::power_of_two(exponent - bits));
        }
      }
    }
  }
}

TEST(ModelSpace, the_logarithm_inverts_the_exponential_with_a_small_relative_error) {
  {
    const RoundingGuard guard;
    expect_inverse<Interval, 2>(44);
    expect_inverse<Interval, 3>(44);
  }
  expect_inverse<BigInterval, 3>(110);
}

/// d(exp_o v, o) = |v|, and d is kept by a frame.
template <class S>
void expect_distances(long bits) {
  std::mt19937_64 random(10);
  const auto metric = FrameMetric<2>::cartesian().on<S>();
  ModelPoint<Rational, 2> origin{};
  origin[0] = Rational(1);
  for (const Curvature curvature : curvatures) {
    for (const long exponent : {1L, 0L, -6L, -20L}) {
      Vector<Rational, 2> v{Rational(3), Rational(4)};
      for (Rational& x : v) x *= Rational::power_of_two(exponent - 3);
      const Rational length = Rational(5) * Rational::power_of_two(exponent - 3);
      const auto x = exponential<S, 2>(curvature, enclosed<S>(v));
      const auto frame = model_frame<S, 2>(curvature, enclosed<S>(some_coordinates<2>(random)));
      const auto o = enclosed<S>(origin);
      const std::array<S, 2> distances{
          distance_of_chord(curvature, squared_chord<S, 2>(curvature, metric, x, o)),
          distance_of_chord(curvature, squared_chord<S, 2>(curvature, metric, applied(frame, x), applied(frame, o)))};
      for (const S& distance : distances) {
        EXPECT_LE(lower_of(distance), length);
        EXPECT_GE(upper_of(distance), length);
        EXPECT_LE(upper_of(distance) - lower_of(distance), Rational::power_of_two(-bits));
        // The twin: a length that is not the distance.
        EXPECT_GT(lower_of(distance), length * ratio(999, 1000));
      }
    }
  }
}

TEST(ModelSpace, distances_are_those_of_the_exponential) {
  {
    const RoundingGuard guard;
    expect_distances<Interval>(24);
  }
  expect_distances<BigInterval>(90);
}

TEST(ModelSpace, small_distances_lose_nothing_to_cancellation) {
  // At 2⁻⁴⁰ a computation through arccos ⟨x, y⟩ would return 0.
  const Rational length = Rational::power_of_two(-40);
  const RoundingGuard guard;
  const auto metric = FrameMetric<2>::cartesian().on<Interval>();
  const auto x =
      exponential<Interval, 2>(Curvature::positive, enclosed<Interval>(Vector<Rational, 2>{length, Rational(0)}));
  const auto o = exponential<Interval, 2>(Curvature::positive, {Interval(0), Interval(0)});
  const Interval distance =
      distance_of_chord(Curvature::positive, squared_chord<Interval, 2>(Curvature::positive, metric, x, o));
  EXPECT_LE(Rational::exactly(distance.lower()), length);
  EXPECT_GE(Rational::exactly(distance.upper()), length);
  EXPECT_LE(Rational::exactly(distance.upper()) - Rational::exactly(distance.lower()),
            length * Rational::power_of_two(-20));
}

TEST(ModelSpace, antipodal_points_are_at_distance_pi) {
  const BigInterval distance = distance_of_chord(Curvature::positive, BigInterval(4));
  EXPECT_LE(distance.lower(), half_turn().upper());
  EXPECT_GE(distance.upper(), half_turn().lower());
  EXPECT_LE(distance.upper() - distance.lower(), Rational::power_of_two(-60));
  const RoundingGuard guard;
  EXPECT_GE(distance_of_chord(Curvature::positive, Interval::between(1, 4)).upper(), 0x1.921fb54442d18p1);
}

TEST(ModelSpace, the_logarithm_of_conformal_coordinates_is_that_of_the_point) {
  std::mt19937_64 random(11);
  for (const Curvature curvature : curvatures) {
    const auto a = some_coordinates<3>(random);
    const auto direct = logarithm_of_conformal<BigInterval, 3>(curvature, enclosed<BigInterval>(a));
    const auto through =
        logarithm<BigInterval, 3>(curvature, enclosed<BigInterval>(model_point<Rational, 3>(curvature, a)));
    for (std::size_t axis = 0; axis < 3; ++axis) {
      EXPECT_FALSE(is_proved(less(direct[axis], through[axis])));
      EXPECT_FALSE(is_proved(less(through[axis], direct[axis])));
    }
  }
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
