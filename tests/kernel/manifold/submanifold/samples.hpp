#pragma once

#include <gtest/gtest.h>

#include "kernel/manifold/submanifold/chart_fitting.hpp"
#include "tests/support/message_of.hpp"
#include "tests/support/ratio.hpp"

namespace delcert::test {

/// The zero set of these equations in the box of these half-widths.
inline ZeroSet zero_set(const std::string& name, std::vector<std::string> variables,
                        const std::vector<std::string>& equations, const std::vector<Rational>& half_widths) {
  SubmanifoldDescription description;
  description.name = name;
  description.dimension = Dimension(variables.size() - equations.size());
  description.variables = std::move(variables);
  description.equations = equations;
  for (const Rational& half : half_widths) description.box.push_back({-half, half});
  return ZeroSet(description);
}

inline ZeroSet unit_sphere_in_space() {
  return zero_set("sphere", {"x", "y", "z"}, {"x^2 + y^2 + z^2 - 1"}, {ratio(3, 2), ratio(3, 2), ratio(3, 2)});
}
/// Of the radii 2 and 1.
inline ZeroSet torus_of_revolution() {
  return zero_set("torus-of-revolution", {"x", "y", "z"}, {"(x^2 + y^2 + z^2 + 3)^2 - 16*(x^2 + y^2)"},
                  {ratio(7, 2), ratio(7, 2), ratio(3, 2)});
}
/// Spheres of the radii 1/2 and 3/10, about (±3/2, 0, 0).
inline ZeroSet two_spheres() {
  return zero_set("two-spheres", {"x", "y", "z"}, {"((x + 3/2)^2 + y^2 + z^2 - 1/4)*((x - 3/2)^2 + y^2 + z^2 - 9/100)"},
                  {Rational(3), ratio(3, 2), ratio(3, 2)});
}
inline ZeroSet clifford_torus() {
  return zero_set("clifford-torus", {"a", "b", "c", "d"}, {"a^2 + b^2 - 1", "c^2 + d^2 - 1"},
                  std::vector<Rational>(4, ratio(3, 2)));
}
inline ZeroSet cone() {
  return zero_set("cone", {"x", "y", "z"}, {"x^2 + y^2 - z^2"}, {Rational(1), Rational(1), Rational(1)});
}

/// The chart of the unit sphere at its north pole with the plane of x and y.
inline TangentChart polar_chart(const Rational& radius, const Rational& height) {
  ChartData data;
  data.centre = {Rational(0), Rational(0), Rational(1)};
  data.columns = {1, 2, 3};
  data.skew = {Rational(0), Rational(0), Rational(0)};
  data.preconditioner = {ratio(1, 2)};
  data.radius = radius;
  data.height = height;
  return TangentChart(data, 2);
}

}  // namespace delcert::test
