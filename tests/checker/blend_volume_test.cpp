#include "proofs/checker/atlases/blend_volume.hpp"

#include <gtest/gtest.h>

#include <array>
#include <random>

#include "proofs/checker/certificate/cursor.hpp"
#include "proofs/checker/report/budget.hpp"

namespace delcert::checker {
namespace {

using Point = std::array<double, 2>;

/// Two charts of a sphere.
constexpr std::string_view sphere =
    R"json(,"charts":[{"name":"a","variables":["x","y"],"domain":[["-2","2"],["-2","2"]],"core":[["-1","1"],["-1","1"]]},)json"
    R"json({"name":"b","variables":["u","v"],"domain":[["-2","2"],["-2","2"]],"core":[["-1","1"],["-1","1"]]}],)json"
    R"json("transitions":[{"from":0,"to":1,"map":["x/(x^2+y^2)","y/(x^2+y^2)"],)json"
    R"json("inverse":["u/(u^2+v^2)","v/(u^2+v^2)"],"where":[]}],"patch_radius":"1/4")json";

Point inverted(const Point& x) {
  const double square = x[0] * x[0] + x[1] * x[1];
  return {x[0] / square, x[1] / square};
}

/// A triangle and its blend in doubles.
struct Triangle {
  std::array<Point, 3> here;
  std::array<bool, 3> first;

  /// The blend, at barycentric coordinates.
  [[nodiscard]] Point at(const std::array<double, 3>& t) const {
    Point from{}, straight{};
    double share = 0;
    for (std::size_t v = 0; v < 3; ++v) {
      const Point there = inverted(here[v]);
      for (std::size_t k = 0; k < 2; ++k) {
        from[k] += t[v] * here[v][k];
        straight[k] += t[v] * there[k];
      }
      share += first[v] ? t[v] : 0;
    }
    const Point to = inverted(from);
    return {straight[0] + share * (to[0] - straight[0]), straight[1] + share * (to[1] - straight[1])};
  }
  /// What it makes of areas there, by differences.
  [[nodiscard]] double area_at(const std::array<double, 3>& t) const {
    constexpr double step = 1e-5;
    std::array<Point, 2> small{}, large{};
    const Point origin = inverted(here[0]);
    for (std::size_t v = 1; v < 3; ++v) {
      std::array<double, 3> ahead = t, behind = t;
      ahead[v] += step;
      ahead[0] -= step;
      behind[v] -= step;
      behind[0] += step;
      const Point to = at(ahead), back = at(behind), corner = inverted(here[v]);
      small[v - 1] = {(to[0] - back[0]) / (2 * step), (to[1] - back[1]) / (2 * step)};
      large[v - 1] = {corner[0] - origin[0], corner[1] - origin[1]};
    }
    const auto determinant = [](const std::array<Point, 2>& a) { return a[0][0] * a[1][1] - a[0][1] * a[1][0]; };
    return determinant(small) / determinant(large);
  }
  [[nodiscard]] double least_area() const {
    double least = 1e300;
    constexpr int parts = 24;
    for (int a = 0; a <= parts; ++a) {
      for (int b = 0; a + b <= parts; ++b) {
        least = std::min(least, area_at({1.0 * a / parts, 1.0 * b / parts, 1.0 * (parts - a - b) / parts}));
      }
    }
    return least;
  }
  [[nodiscard]] SimplexOfTwoHomes enclosed() const {
    SimplexOfTwoHomes result;
    for (std::size_t v = 0; v < 3; ++v) {
      const Point there = inverted(here[v]);
      Cell x(2, 1), y(2, 1);
      for (std::size_t k = 0; k < 2; ++k) {
        x[k] = Interval::between(here[v][k], here[v][k]);
        y[k] = Interval::between(there[k] - 1e-14, there[k] + 1e-14);
      }
      result.here.push_back(x);
      result.there.push_back(y);
      result.first.push_back(first[v]);
    }
    return result;
  }
};

/// Triangles across the unit circle, some of them so large that the least is between the vertices, and turned ones.
TEST(BlendVolume, is_not_above_what_it_is_at_points_and_not_far_below) {
  Cursor cursor(sphere);
  const Gluing gluing(2, cursor);
  const std::vector<Passage> passages = passages_of(gluing, [](std::size_t) { FAIL(); });
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> offset(-0.45, 0.45);
  int inside = 0, folded = 0;
  for (int sample = 0; sample < 300; ++sample) {
    Budget::open(std::uint64_t{1} << 44);
    Triangle triangle;
    for (Point& x : triangle.here) x = {1 + offset(random), offset(random)};
    const std::array<Point, 3>& x = triangle.here;
    const double area = (x[1][0] - x[0][0]) * (x[2][1] - x[0][1]) - (x[1][1] - x[0][1]) * (x[2][0] - x[0][0]);
    if (std::abs(area) < 0.04) continue;
    const auto kind = random() % 6 + 1;  // of three homes neither none nor all are the first
    for (std::size_t v = 0; v < 3; ++v) triangle.first[v] = (kind >> v & 1U) != 0;
    const SimplexOfTwoHomes enclosed = triangle.enclosed();
    PassageValues passage(passages[0]);
    const double least = triangle.least_area();
    double at_vertices = 1e300;
    for (std::size_t v = 0; v < 3; ++v) {
      std::array<double, 3> t{};
      t[v] = 1;
      at_vertices = std::min(at_vertices, triangle.area_at(t));
    }
    inside += at_vertices - least > 0.02 ? 1 : 0;
    folded += least < -0.02 ? 1 : 0;
    const auto holds = [&](double number) {
      return is_blend_volume_at_least(enclosed, passage, Interval::between(number, number));
    };
    EXPECT_FALSE(holds(least + 1e-6)) << sample;
    // Not of triangles that are nearly flat in the other chart.
    if (least > -1) {
      EXPECT_TRUE(holds(least - 0.05)) << sample << " " << least;
    }
  }
  EXPECT_GT(inside, 20);
  EXPECT_GT(folded, 5);
}

}  // namespace
}  // namespace delcert::checker
