#include "tests/checker/zero_set_oracle.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <vector>

#include "kernel/formula/formula_map.hpp"
#include "kernel/number/exact_text.hpp"
#include "tests/checker/support/certificate_text.hpp"

namespace delcert::checker_tests {
namespace {

constexpr double slack = 1e-9;
constexpr double two_pi = 6.283185307179586;

double number(const Json& value) { return approximate_double(parse_exact(value.get<std::string>())); }

struct Place {
  double x = 0, y = 0;
};
Place operator+(Place a, Place b) { return {a.x + b.x, a.y + b.y}; }
Place operator-(Place a, Place b) { return {a.x - b.x, a.y - b.y}; }
Place operator*(double t, Place a) { return {t * a.x, t * a.y}; }
double dot(Place a, Place b) { return a.x * b.x + a.y * b.y; }
double length(Place a) { return std::sqrt(dot(a, a)); }

struct Chart {
  Place centre, tangent, normal;
  double weight = 0, radius = 0, height = 0, home = 0;
  Place vertex;  // p′

  [[nodiscard]] double across(Place p) const { return dot(tangent, p - centre); }
  [[nodiscard]] double above(Place p) const { return dot(normal, p - centre); }
  [[nodiscard]] Place at(double y, double z) const { return centre + y * tangent + z * normal; }
  [[nodiscard]] bool contains(Place p) const { return std::fabs(across(p)) < radius && std::fabs(above(p)) < height; }
  /// Heights of points of the circle over y.
  [[nodiscard]] std::vector<double> zeros(double y) const {
    const Place foot = at(y, 0);
    const double b = dot(foot, normal), discriminant = b * b - dot(foot, foot) + 1;
    if (discriminant < 0) return {};
    return {-b - std::sqrt(discriminant), -b + std::sqrt(discriminant)};
  }
  /// Of one over y in the closed cylinder; none unless there is exactly one.
  [[nodiscard]] std::optional<double> zero(double y) const {
    std::optional<double> result;
    for (const double z : zeros(y)) {
      if (std::fabs(z) > height * (1 - slack)) continue;
      if (result) return std::nullopt;
      result = z;
    }
    return result;
  }
  /// W = NY.
  [[nodiscard]] Place fibre() const { return weight * normal; }
};

/// The certificate, read.
struct Reading {
  std::vector<Chart> charts;
  std::vector<std::array<std::size_t, 2>> edges;
  double slope, epsilon, perturbation, distortion;
  std::array<std::array<double, 2>, 2> box;

  explicit Reading(const Json& j)
      : slope(number(j.at("manifold").at("slope"))),
        epsilon(number(j.at("parameters").at("sampling_radius"))),
        perturbation(number(j.at("parameters").at("perturbation"))),
        distortion(number(j.at("parameters").at("distortion"))) {
    for (std::size_t axis = 0; axis < 2; ++axis) {
      for (std::size_t end = 0; end < 2; ++end) box[axis][end] = number(j.at("manifold").at("box").at(axis).at(end));
    }
    for (std::size_t i = 0; i < j.at("charts").size(); ++i) {
      const Json& row = j.at("charts").at(i);
      Chart chart;
      chart.centre = {number(j.at("net").at(i).at(0)), number(j.at("net").at(i).at(1))};
      // (1 - A)(1 + A)⁻¹ for A = (0 a; -a 0), then a signed permutation of columns.
      const double a = number(row.at(2)), scale = 1 / (1 + a * a);
      const Place columns[] = {{scale * (1 - a * a), 2 * scale * a}, {-2 * scale * a, scale * (1 - a * a)}};
      const auto column = [&](std::size_t k) {
        const double axis = number(row.at(k));
        return (axis < 0 ? -1.0 : 1.0) * columns[std::fabs(axis) == 1 ? 0 : 1];
      };
      chart.tangent = column(0);
      chart.normal = column(1);
      chart.weight = number(row.at(3));
      chart.radius = number(row.at(4));
      chart.height = number(row.at(5));
      chart.home = number(j.at("points").at(i).at(0));
      charts.push_back(chart);
    }
    for (const Json& row : j.at("simplices")) edges.push_back({row.at(0), row.at(1)});
  }
};

class Oracle {
 public:
  explicit Oracle(const Json& j) : j_(j), c_(j) {}

  std::string fault() {
    const auto variables = j_.at("manifold").at("variables").get<std::vector<std::string>>();
    const auto equations = j_.at("manifold").at("equations").get<std::vector<std::string>>();
    if (variables != std::vector<std::string>{"x", "y"} || j_.at("manifold").at("vertices") != "manifold" ||
        FormulaMap(variables, equations).canonical_texts() != std::vector<std::string>{"x^2+y^2-1"})
      return "another zero set";
    if (auto found = of_charts(); !found.empty()) return found;
    for (Chart& chart : c_.charts) chart.vertex = chart.at(chart.home, *chart.zero(chart.home));
    if (auto found = of_cover(); !found.empty()) return found;
    const Json& levels = j_.at("levels");
    const std::vector<std::pair<const char*, std::string (Oracle::*)(const Json&) const>> rules = {
        {"1", &Oracle::of_level_1}, {"2", &Oracle::of_level_2},   {"2s", &Oracle::of_level_2s},
        {"5", &Oracle::of_level_5}, {"5i", &Oracle::of_level_5i}, {"4", &Oracle::of_level_4},
        {"6", &Oracle::of_level_6}};
    for (const auto& [level, rule] : rules) {
      if (!levels.contains(level)) continue;
      if (auto found = (this->*rule)(levels.at(level)); !found.empty()) return std::string(level) + ": " + found;
    }
    return "";
  }

 private:
  std::string of_charts() const {
    constexpr int steps = 24;
    for (const Chart& chart : c_.charts) {
      for (const double y : {-chart.radius, chart.radius}) {
        for (const double z : {-chart.height, chart.height}) {
          const Place corner = chart.at(y, z);
          if (!(corner.x > c_.box[0][0] && corner.x < c_.box[0][1] && corner.y > c_.box[1][0] &&
                corner.y < c_.box[1][1]))
            return "a cylinder outside of the box";
          if (!(std::fabs(1 - chart.weight * 2 * dot(corner, chart.normal)) < 1 + slack)) return "fibres";
        }
      }
      const auto z0 = chart.zero(0);
      if (!z0) return "no point over a centre";
      if (!(std::fabs(*z0) + 9.0 / 16 * c_.slope * chart.radius < chart.height * (1 + slack))) return "a lid";
      for (int step = -steps; step <= steps; ++step) {
        const double s = std::fabs(step) / steps;
        const double half = c_.slope * chart.radius * (2 * s + 7 * s * s) / 16;
        for (const double part : {-1.0, -0.5, 0.0, 0.5, 1.0}) {
          const Place p = chart.at(chart.radius * step / steps, *z0 + part * half);
          const double steepness = std::fabs(dot(p, chart.tangent) / dot(p, chart.normal));
          if (!(steepness <= c_.slope * (1 + 7 * s) / 8 * (1 + slack) + slack)) return "a slope";
        }
        if (!chart.zero(chart.radius * (1 - slack) * step / steps)) return "no graph";
      }
      if (!(std::fabs(chart.home) < chart.radius)) return "a point outside of its chart";
    }
    if (!((1 + c_.distortion) * (1 + c_.distortion) >= 1 + c_.slope * c_.slope - slack)) return "distortion";
    return "";
  }

  std::string of_cover() const {
    constexpr int samples = 1000;
    for (int k = 0; k < samples; ++k) {
      const Place p{std::cos(two_pi * k / samples), std::sin(two_pi * k / samples)};
      if (std::none_of(c_.charts.begin(), c_.charts.end(), [&](const Chart& chart) { return chart.contains(p); }))
        return "a point in no cylinder";
    }
    return "";
  }

  [[nodiscard]] std::vector<std::array<std::size_t, 2>> star(std::size_t i) const {
    std::vector<std::array<std::size_t, 2>> result;
    for (const auto& edge : c_.edges) {
      if (edge[0] == i || edge[1] == i) result.push_back(edge);
    }
    return result;
  }

  std::string of_level_1(const Json& level) const {
    const double delta = number(level.at("protection")), r = number(level.at("circumradius"));
    if (number(level.at("thickness")) > 1 + slack) return "thickness";
    for (std::size_t i = 0; i < c_.charts.size(); ++i) {
      const Chart& chart = c_.charts[i];
      if (std::fabs(chart.home) > c_.perturbation * c_.epsilon + slack) return "perturbation";
      if (!(c_.perturbation * c_.epsilon + 2 * r + delta < chart.radius * (1 + slack))) return "patch";
      const auto edges = star(i);
      if (edges.size() != 2) return "facets";
      for (const auto& edge : edges) {
        for (const std::size_t v : edge) {
          if (!chart.contains(c_.charts[v].vertex)) return "a vertex that is not shown";
        }
        const double a = chart.across(c_.charts[edge[0]].vertex), b = chart.across(c_.charts[edge[1]].vertex);
        if (std::fabs(a - b) / 2 > r * (1 + slack)) return "circumradius";
        for (std::size_t k = 0; k < c_.charts.size(); ++k) {
          if (k == edge[0] || k == edge[1] || !chart.contains(c_.charts[k].vertex)) continue;
          if (std::fabs(chart.across(c_.charts[k].vertex) - (a + b) / 2) < std::fabs(a - b) / 2 + delta - slack)
            return "protection";
        }
      }
    }
    return "";
  }

  std::string of_level_2(const Json& level) const {
    if (level.at("simplices") != c_.edges.size() || level.at("closed") != true) return "counts";
    const int characteristic = static_cast<int>(c_.charts.size()) - static_cast<int>(c_.edges.size());
    if (level.at("euler_characteristic") != characteristic) return "Euler characteristic";
    const std::set<std::array<std::size_t, 2>> different(c_.edges.begin(), c_.edges.end());
    return different.size() == c_.edges.size() ? "" : "an edge twice";
  }

  std::string of_level_2s(const Json& level) const {
    const double reach = number(level.at("reach"));
    for (std::size_t j = 0; j < c_.charts.size(); ++j) {
      const Chart& chart = c_.charts[j];
      if (!(reach < chart.radius)) return "reach";
      std::set<std::array<std::size_t, 2>> edges;
      for (const auto& edge : star(j)) {
        for (const std::size_t i : edge) {
          for (const auto& other : star(i)) edges.insert(other);
        }
      }
      for (const auto& edge : edges) {
        const double a = chart.across(c_.charts[edge[0]].vertex), b = chart.across(c_.charts[edge[1]].vertex);
        if (std::fabs(a + b) / 2 + std::fabs(a - b) / 2 > reach * (1 + slack)) return "a ball beyond the reach";
        for (std::size_t k = 0; k < c_.charts.size(); ++k) {
          if (k == edge[0] || k == edge[1] || !chart.contains(c_.charts[k].vertex)) continue;
          const double at = chart.across(c_.charts[k].vertex);
          if (std::fabs(at) < reach && std::fabs(at - (a + b) / 2) < std::fabs(a - b) / 2 - slack) return "a star";
        }
      }
    }
    return "";
  }

  /// s with |X + Ws| = 1, the less in size: f = |X|² - 1.
  static double shift(Place x, Place w) {
    const double a = dot(w, w), b = dot(x, w), c = dot(x, x) - 1;
    const double root = std::sqrt(std::max(b * b - a * c, 0.0));
    const double q = -(b + std::copysign(root, b));
    return q == 0 ? 0 : c / q;
  }
  /// The point at t on the edge, and what it is moved by.
  [[nodiscard]] std::pair<Place, Place> moved(const std::array<std::size_t, 2>& edge, double t) const {
    const Chart& p = c_.charts[edge[0]];
    const Chart& q = c_.charts[edge[1]];
    const Place x = (1 - t) * p.vertex + t * q.vertex, w = (1 - t) * p.fibre() + t * q.fibre();
    return {x, shift(x, w) * w};
  }

  std::string of_level_5(const Json& level) const {
    const double gamma = number(level.at("contraction")), omega = number(level.at("displacement"));
    constexpr int steps = 16;
    double angle = 0;
    for (const auto& edge : c_.edges) {
      for (int k = 0; k <= steps; ++k) {
        const auto [x, by] = moved(edge, static_cast<double>(k) / steps);
        if (length(by) > omega * (1 + slack) + slack) return "displacement";
        for (const std::size_t i : edge) {
          if (!(std::fabs(c_.charts[i].across(x)) + omega < c_.charts[i].radius * (1 + slack))) return "fibre, disc";
          if (!(std::fabs(c_.charts[i].above(x)) + omega < c_.charts[i].height * (1 + slack))) return "fibre, lid";
        }
        if (k == 0) continue;
        const auto [before, by_before] = moved(edge, static_cast<double>(k - 1) / steps);
        for (const std::size_t i : edge) {
          const Place along = c_.charts[i].tangent;
          if (std::fabs(dot(along, by - by_before)) > gamma * std::fabs(dot(along, x - before)) + slack)
            return "contraction";
        }
      }
      const Place a = c_.charts[edge[0]].vertex, b = c_.charts[edge[1]].vertex;
      angle += std::atan2(std::fabs(a.x * b.y - a.y * b.x), dot(a, b));
    }
    // Every edge once around, and once only.
    if (std::fabs(angle - two_pi) > 1e-6) return "not once around";
    return "";
  }

  std::string of_level_5i(const Json& level) const {
    const Json& five = j_.at("levels").at("5");
    const double gamma = number(five.at("contraction")), omega = number(five.at("displacement"));
    const double margin = number(level.at("margin"));
    for (std::size_t i = 0; i < c_.charts.size(); ++i) {
      const Chart& chart = c_.charts[i];
      double altitude = 10, side = 0;
      for (const auto& edge : star(i)) {
        for (const std::size_t v : edge) {
          if (!(std::fabs(chart.above(c_.charts[v].vertex)) + 3 * omega < chart.height * (1 + slack))) return "lid";
          const auto [x, by] = moved(edge, 0.5);
          side = std::max(side, std::fabs(dot(chart.tangent, c_.charts[v].fibre())) * length(by) /
                                    length(c_.charts[v].fibre()) * (1 - 0.5));
        }
        altitude = std::min(
            altitude, std::fabs(chart.across(c_.charts[edge[0]].vertex) - chart.across(c_.charts[edge[1]].vertex)));
      }
      if (!((1 - gamma) * altitude / 2 - 2 * side >= margin - slack)) return "margin";
    }
    return "";
  }

  std::string of_level_4(const Json& level) const {
    const double density = number(level.at("density"));
    std::vector<double> angles;
    for (const Chart& chart : c_.charts) {
      angles.push_back(std::atan2(chart.vertex.y, chart.vertex.x));
      if (!(std::fabs(chart.home) + density < chart.radius * (1 + slack))) return "patch";
      if (level.at("metric") != "intrinsic" &&
          !(std::fabs(chart.above(chart.vertex)) + density < chart.height * (1 + slack)))
        return "lid";
    }
    std::sort(angles.begin(), angles.end());
    angles.push_back(angles.front() + two_pi);
    for (std::size_t k = 1; k < angles.size(); ++k) {
      if ((angles[k] - angles[k - 1]) / 2 > density * (1 + slack)) return "density";
    }
    // Neighbours on the circle are the edges, for both distances.
    std::vector<std::size_t> order(c_.charts.size());
    for (std::size_t k = 0; k < order.size(); ++k) order[k] = k;
    const auto angle_of = [&](std::size_t i) { return std::atan2(c_.charts[i].vertex.y, c_.charts[i].vertex.x); };
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return angle_of(a) < angle_of(b); });
    std::set<std::set<std::size_t>> expected, found;
    for (std::size_t k = 0; k < order.size(); ++k) expected.insert({order[k], order[(k + 1) % order.size()]});
    for (const auto& edge : c_.edges) found.insert({edge[0], edge[1]});
    return found == expected ? "" : "edges";
  }

  std::string of_level_6(const Json& level) const {
    const double least = number(level.at("bilipschitz").at(0)), most = number(level.at("bilipschitz").at(1));
    const double normal = number(level.at("normal"));
    if (level.at("self_delaunay") != false) return "self-Delaunay";
    constexpr int steps = 16;
    for (const auto& edge : c_.edges) {
      const Place a = c_.charts[edge[0]].vertex, b = c_.charts[edge[1]].vertex;
      const Place along = (1 / length(b - a)) * (b - a);
      for (int k = 0; k <= steps; ++k) {
        const auto [x, by] = moved(edge, static_cast<double>(k) / steps);
        if (std::fabs(dot(along, x + by)) > normal * (1 + slack) + slack) return "normal";
        if (k == 0) continue;
        const auto [before, by_before] = moved(edge, static_cast<double>(k - 1) / steps);
        const double chord = length(x + by - before - by_before);
        const double ratio = 2 * std::asin(std::min(chord / 2, 1.0)) / length(x - before);
        if (ratio < least - slack || ratio > most + slack) return "bilipschitz";
      }
    }
    return "";
  }

  const Json& j_;
  Reading c_;
};

}  // namespace

std::string fault_of_zero_set_circle(const std::string& text) {
  const Json j = Json::parse(text);
  return Oracle(j).fault();
}

}  // namespace delcert::checker_tests
