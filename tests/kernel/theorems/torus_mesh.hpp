#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "kernel/number/rounding_guard.hpp"
#include "kernel/number/scalar.hpp"
#include "kernel/theorems/graph_simplex.hpp"

namespace delcert::test {

/// Rational points of the unit circle, 4·quarter of them, in order.
inline std::vector<std::array<Rational, 2>> circle_points(int quarter) {
  std::vector<std::array<Rational, 2>> result;
  for (int turn = 0; turn < 4; ++turn) {
    for (int k = 0; k < quarter; ++k) {
      const Rational t = Rational(k) / Rational(quarter);
      const Rational scale = Rational(1) / (Rational(1) + t * t);
      std::array<Rational, 2> point{(Rational(1) - t * t) * scale, Rational(2) * t * scale};
      for (int quarter_turn = 0; quarter_turn < turn; ++quarter_turn) point = {-point[1], point[0]};
      result.push_back(point);
    }
  }
  return result;
}

inline SubmanifoldDescription description_of_torus() {
  SubmanifoldDescription result;
  result.name = "torus";
  result.dimension = Dimension(2);
  result.variables = {"x", "y", "z"};
  result.equations = {"(x^2 + y^2 + z^2 + 3)^2 - 16*(x^2 + y^2)"};
  result.box = {{Rational(-4), Rational(4)}, {Rational(-4), Rational(4)}, {Rational(-2), Rational(2)}};
  return result;
}

inline SubmanifoldDescription unit_circle() {
  SubmanifoldDescription result;
  result.name = "circle";
  result.dimension = Dimension(1);
  result.variables = {"x", "y"};
  result.equations = {"x^2 + y^2 - 1"};
  result.box = {{Rational(-2), Rational(2)}, {Rational(-2), Rational(2)}};
  return result;
}

/// Points of a zero set, exactly, with a chart about each, and simplices.
template <int m>
struct Mesh {
  ZeroSet zero_set;
  std::vector<std::vector<Rational>> points;
  std::vector<TangentChart> charts;
  std::vector<LabelSimplex<m>> simplices;

  explicit Mesh(const SubmanifoldDescription& description) : zero_set(description) {}

  void add_charts(const Rational& radius, const Rational& height) {
    FormulaEvaluation<double> f(zero_set.map());
    for (const auto& point : points) {
      std::vector<Rational> centre;
      for (const Rational& x : point) centre.push_back(rounded_down(x, -30));
      charts.push_back(tangent_chart(zero_set, f, centre));
      charts.back().set_size(radius, height);
    }
  }
  [[nodiscard]] GraphVertices vertices() const {
    GraphVertices result{zero_set, charts, {}, {}};
    const RoundingGuard guard;
    for (const auto& point : points) {
      for (const Rational& x : point) result.positions.push_back(scalar_from<Interval>(x));
    }
    return result;
  }
};

/// The torus of revolution by a grid, `sheets` times around its axis.
inline Mesh<2> torus_mesh(int along, int around, int sheets = 1) {
  Mesh<2> result(description_of_torus());
  const auto large = circle_points(along);
  const auto small = circle_points(around);
  const std::size_t rows = large.size() * static_cast<std::size_t>(sheets);
  const std::size_t columns = small.size();
  for (std::size_t row = 0; row < rows; ++row) {
    const auto& [cosine, sine] = large[row % large.size()];
    for (const auto& [out, up] : small)
      result.points.push_back({(Rational(2) + out) * cosine, (Rational(2) + out) * sine, up});
  }
  const auto label = [&](std::size_t row, std::size_t column) {
    return static_cast<std::uint32_t>(row % rows * columns + column % columns);
  };
  const auto add = [&](LabelSimplex<2> simplex) {
    std::sort(simplex.begin(), simplex.end());
    result.simplices.push_back(simplex);
  };
  for (std::size_t row = 0; row < rows; ++row) {
    for (std::size_t column = 0; column < columns; ++column) {
      add({label(row, column), label(row + 1, column), label(row + 1, column + 1)});
      add({label(row, column), label(row, column + 1), label(row + 1, column + 1)});
    }
  }
  std::sort(result.simplices.begin(), result.simplices.end());
  result.add_charts(Rational(1), Rational(1) / Rational(2));
  return result;
}

/// A polygon in the unit circle that winds around `sheets` times.
inline Mesh<1> circle_mesh(int quarter, int sheets = 1) {
  Mesh<1> result(unit_circle());
  const auto points = circle_points(quarter);
  const std::size_t count = points.size() * static_cast<std::size_t>(sheets);
  for (std::size_t k = 0; k < count; ++k) {
    const auto& point = points[k % points.size()];
    result.points.push_back({point[0], point[1]});
    const auto here = static_cast<std::uint32_t>(k);
    const auto next = static_cast<std::uint32_t>((k + 1) % count);
    result.simplices.push_back({std::min(here, next), std::max(here, next)});
  }
  std::sort(result.simplices.begin(), result.simplices.end());
  result.add_charts(Rational(3) / Rational(4), Rational(3) / Rational(4));
  return result;
}

}  // namespace delcert::test
