#include "kernel/theorems/blended_simplex.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "kernel/number/rounding_guard.hpp"
#include "tests/kernel/theorems/glued_run.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

using Point = std::array<double, 2>;

double middle(const Interval& x) { return (x.lower() + x.upper()) / 2; }

/// The blend of a triangle between the two charts of the sphere, in doubles.
struct Blend {
  std::array<Point, 3> here;   // the vertices in the first chart
  std::array<Point, 3> there;  // in the second one
  std::array<bool, 3> is_first;
  std::array<Point, 2> matrix;  // of the chart in which is measured

  [[nodiscard]] static Point combined(const std::array<double, 3>& t, const std::array<Point, 3>& x) {
    return {t[0] * x[0][0] + t[1] * x[1][0] + t[2] * x[2][0], t[0] * x[0][1] + t[1] * x[1][1] + t[2] * x[2][1]};
  }
  /// What the point is moved by from the straight triangle.
  [[nodiscard]] Point drift(const std::array<double, 3>& t) const {
    const Point x = combined(t, here);
    const Point y = combined(t, there);
    const double squared = x[0] * x[0] + x[1] * x[1];
    double share = 0;
    for (std::size_t v = 0; v < 3; ++v) share += is_first[v] ? t[v] : 0;
    return {share * (x[0] / squared - y[0]), share * (x[1] / squared - y[1])};
  }
  [[nodiscard]] double length(const Point& x) const {
    return std::hypot(matrix[0][0] * x[0] + matrix[0][1] * x[1], matrix[1][0] * x[0] + matrix[1][1] * x[1]);
  }
};

TEST(BlendedSimplex, bounds_hold_at_points_of_seams_and_are_not_far_off) {
  const auto& [atlas, run] = fine_sphere();
  const GluedPlaces<2> places(atlas, run.points);
  std::vector<std::array<double, 3>> weights;
  for (int a = 0; a <= 6; ++a) {
    for (int b = 0; a + b <= 6; ++b) weights.push_back({a / 6.0, b / 6.0, (6 - a - b) / 6.0});
  }
  std::size_t seams = 0;
  double greatest = 0;
  double tightest = 0;
  for (const auto& simplex : run.complex.simplices()) {
    const BlendedSimplex found = [&] {
      const RoundingGuard guard;
      return BlendedSimplexCheck<2>(atlas, places).measure(simplex);
    }();
    if (!found.is_seam) {
      EXPECT_EQ(found.displacement, 0);
      EXPECT_EQ(found.contraction, 0);
      continue;
    }
    ++seams;
    ASSERT_FALSE(found.cause.has_value()) << description_of(*found.cause);
    EXPECT_LT(found.contraction, 1);
    greatest = std::max(greatest, found.contraction);
    Blend blend;
    std::uint32_t chart = 0;
    for (std::size_t v = 3; v-- > 0;) {
      for (std::size_t axis = 0; axis < 2; ++axis) {
        blend.here[v][axis] = middle((*places.place(0, simplex[v]))[axis]);
        blend.there[v][axis] = middle((*places.place(1, simplex[v]))[axis]);
      }
      blend.is_first[v] = places.home(simplex[v]) == 0;
      if (!blend.is_first[v]) chart = simplex[v];
    }
    for (std::size_t row = 0; row < 2; ++row) {
      for (std::size_t k = 0; k < 2; ++k) blend.matrix[row][k] = middle(atlas.enclosed(Label(chart)).matrix[row][k]);
    }
    double farthest = 0;
    for (const auto& s : weights) {
      farthest = std::max(farthest, blend.length(blend.drift(s)));
      for (const auto& t : weights) {
        if (s == t) continue;
        const Point x = Blend::combined(s, blend.there);
        const Point y = Blend::combined(t, blend.there);
        const Point drift = difference(blend.drift(s), blend.drift(t));
        ASSERT_LE(blend.length(drift), found.contraction * blend.length(difference(x, y)) * (1 + 1e-9) + 1e-15);
      }
    }
    EXPECT_LE(farthest, found.displacement);
    tightest = std::max(tightest, farthest / found.displacement);
  }
  EXPECT_GT(seams, 50U);
  EXPECT_GT(greatest, 0.01);
  EXPECT_GT(tightest, 0.3);
}

TEST(BlendedSimplex, does_not_take_what_is_too_large_or_not_shown) {
  const auto& [atlas, run] = fine_sphere();
  const GluedPlaces<2> places(atlas, run.points);
  const RoundingGuard guard;
  BlendedSimplexCheck<2> check(atlas, places);
  // From about one pole to about the other.
  const auto pole_of = [&](std::size_t home) {
    std::uint32_t label = 0;
    while (places.home(label) != home || places.place(1 - home, label)) ++label;
    return label;
  };
  LabelSimplex<2> poles{pole_of(0), pole_of(1), pole_of(0) == 0 ? 1U : 0U};
  std::sort(poles.begin(), poles.end());
  EXPECT_EQ(check.measure(poles).cause, BlendCause::place);
  EXPECT_EQ(check.homes_of(poles), (std::vector<std::size_t>{0, 1}));
  EXPECT_EQ(places.home(check.representative(poles, 1)), 1U);
  // Three labels that both charts show, about a third of the equator from each other.
  LabelSimplex<2> wide{};
  std::size_t found = 0;
  for (const double angle : {0.3, 2.4, 4.5}) {
    double nearest = 9;
    for (std::uint32_t label = 0; label < places.labels(); ++label) {
      const auto& x = places.place(0, label);
      if (!x || !places.place(1, label) || (places.home(label) == 0) != (found == 0)) continue;
      const double distance = std::hypot(middle((*x)[0]) - std::cos(angle), middle((*x)[1]) - std::sin(angle));
      if (distance < nearest) {
        nearest = distance;
        wide[found] = label;
      }
    }
    ++found;
  }
  std::sort(wide.begin(), wide.end());
  EXPECT_EQ(check.measure(wide).cause, BlendCause::transition);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
