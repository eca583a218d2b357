#include "tests/checker/circle_oracle.hpp"

#include <algorithm>
#include <map>
#include <numeric>
#include <set>
#include <vector>

#include "kernel/number/exact_text.hpp"
#include "tests/checker/support/certificate_text.hpp"

namespace delcert::checker_tests {
namespace {

Rational number(const Json& value) { return parse_exact(value.get<std::string>()); }

/// The points of a circle of circumference 1, in their order around it.
struct Around {
  explicit Around(const Json& points) : order(points.size()) {
    for (const Json& point : points) {
      Rational x = number(point.at(0));
      if (x < Rational(-1000) || Rational(1000) < x) throw std::runtime_error("a coordinate far away");
      while (x < Rational(0)) x += Rational(1);
      while (!(x < Rational(1))) x -= Rational(1);
      place.push_back(x);
    }
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return place[a] < place[b]; });
  }
  std::size_t size() const { return order.size(); }
  /// From the point at this place of the order to the one so many steps on, on the line.
  Rational step(std::size_t at, std::size_t steps) const {
    const std::size_t end = at + steps;
    return place[order[end % size()]] + Rational(static_cast<int>(end / size())) - place[order[at]];
  }
  std::vector<Rational> place;
  std::vector<std::size_t> order;
};

std::string fault_of_input(const Json& j, const Rational& g, const Rational& epsilon) {
  const Json& parameters = j.at("parameters");
  const Rational mu = number(parameters.at("separation")), rho = number(parameters.at("perturbation"));
  if (j.at("levels").at("0").at("hypotheses_2").get<bool>()) return "Hypotheses 2 hold for no such circle";
  const Around net(j.at("net"));
  if (g < Rational(576) * square(epsilon)) return "the circle is too short";
  for (std::size_t at = 0; at < net.size(); ++at) {
    const Rational gap = square(net.step(at, 1)) * g;
    if (gap < square(mu * epsilon)) return "points closer than the separation";
    if (!(gap < Rational(4) * square(epsilon))) return "a gap as wide as twice the sampling radius";
  }
  for (std::size_t i = 0; i < net.size(); ++i) {
    const Rational moved = number(j.at("points").at(i).at(0)) - number(j.at("net").at(i).at(0));
    if (square(rho * epsilon) < square(moved) * g) return "a point moved too far";
  }
  return rho * Rational(4) > mu ? "a perturbation greater than a quarter of the separation" : "";
}

/// The vectors of the elements, in their order, with that of the identity.
std::vector<Rational> vectors_of(const Json& j) {
  std::vector<Rational> result{Rational(0)};
  for (const Json& element : j.at("elements")) result.push_back(Rational(element.at(0).get<int>()));
  return result;
}

/// The edges are those between neighbours, each once and at the lifts that are neighbours on the line, and the loop
/// goes around the circle once.
std::string fault_of_edges(const Json& j, const std::vector<std::map<std::size_t, Rational>>& neighbours) {
  const std::vector<Rational> vectors = vectors_of(j);
  const Json &points = j.at("points"), &edges = j.at("simplices");
  const auto coordinate = [&](std::size_t label) { return number(points.at(label).at(0)); };
  std::set<std::pair<std::size_t, std::size_t>> listed;
  for (const Json& edge : edges) {
    const auto a = edge.at(0).get<std::size_t>(), b = edge.at(1).get<std::size_t>();
    const Rational across = coordinate(b) + vectors.at(edge.at(2).get<std::size_t>()) - coordinate(a);
    const auto found = neighbours.at(a).find(b);
    if (found == neighbours[a].end() || !listed.emplace(a, b).second) return "another star";
    if (found->second != across) return "an edge to another lift";
  }
  if (listed.size() != neighbours.size()) return "an edge is missing";
  if (j.at("loops").size() != 1) return "no loop, or another one";
  const Json& loop = j.at("loops").at(0);
  std::size_t label = 0;
  Rational around(0);
  for (std::size_t at = 0; at < loop.size(); at += 3) {
    const Json& edge = edges.at(loop.at(at).get<std::size_t>());
    const auto from = loop.at(at + 1).get<std::size_t>(), to = loop.at(at + 2).get<std::size_t>();
    if (from + to != 1 || edge.at(from).get<std::size_t>() != label) return "a loop along no edges";
    label = edge.at(to).get<std::size_t>();
    const Rational vector = vectors.at(edge.at(2).get<std::size_t>());
    around += from == 0 ? vector : -vector;
  }
  return label == 0 && around == Rational(1) ? "" : "a loop that does not go around once";
}

std::string fault_of_stars(const Json& j, const Rational& g) {
  const Json& margins = j.at("levels").at("1");
  const Rational protection = number(margins.at("protection")), radius = number(margins.at("circumradius"));
  const Around points(j.at("points"));
  const std::size_t n = points.size();
  if (n < 3 || Rational(1) < number(margins.at("thickness"))) return "thicker than an edge";
  // From each point to the one before it and the one after it, on the line.
  std::vector<std::map<std::size_t, Rational>> neighbours(n);
  for (std::size_t at = 0; at < n; ++at) {
    const std::size_t a = points.order[at], b = points.order[(at + 1) % n];
    const Rational edge = points.step(at, 1);
    neighbours[a].emplace(b, edge);
    neighbours[b].emplace(a, -edge);
    if (!(Rational(0) < edge) || Rational(4) * square(radius) < square(edge) * g) return "an edge too long";
    // The points beside the edge are farther from its middle than half of it and the protection.
    for (const Rational& beside : {points.step((at + 1) % n, 1), points.step((at + n - 1) % n, 1)}) {
      if (!(square(protection) < square(beside) * g)) return "an edge less protected";
    }
  }
  const std::string fault = fault_of_edges(j, neighbours);
  if (!fault.empty()) return fault;
  const Json& counted = j.at("levels").at("2");
  if (counted.at("simplices") != n || counted.at("euler_characteristic") != 0 || counted.at("closed") != true)
    return "another count";
  return counted.contains("homology") && counted.at("homology") != Json::array({"Z", "Z"}) ? "another homology" : "";
}

/// Three points of which every two have R < 2 epsilon and are near to the third's: P1 to P3; edges are good always.
std::string fault_of_configurations(const Json& j, const Rational& g, const Rational& epsilon) {
  const Json& parameters = j.at("parameters");
  const Rational mu = number(parameters.at("separation")), squared = number(parameters.at("flake_parameter_squared"));
  if (Rational(4) * square(square(mu)) < Rational(5625) * squared) return "a flake parameter too large";
  const Rational longest = Rational(5) / Rational(2) * (Rational(1) + squared * mu / Rational(2)) * epsilon;
  const Rational alpha_squared = Rational(1 << 26) * squared / square(mu * mu * mu);
  const Around points(j.at("points"));
  for (std::size_t at = 0; at < points.size(); ++at) {
    for (std::size_t b = 1; b < points.size() && square(points.step(at, b)) * g < square(longest); ++b) {
      for (std::size_t a = 1; a < b; ++a) {
        const Rational x = points.step(at, a), y = points.step(at, b) - x, whole = x + y;
        const auto near = [&](const Rational& distance, const Rational& edge) {
          return !(alpha_squared * square(edge) < Rational(4) * square(distance));
        };
        const auto is_small = [&](const Rational& edge) { return square(edge) * g < Rational(16) * square(epsilon); };
        const Rational& least = x < y ? x : y;
        if (near(x, y) && near(y, x) && near(least, whole) && is_small(x) && is_small(y) && is_small(whole))
          return "a forbidden configuration";
      }
    }
  }
  return "";
}

}  // namespace

std::string fault_of_circle(const std::string& text) {
  const Json j = Json::parse(text);
  if (j.at("manifold").at("family") != "flat-torus" || j.at("manifold").at("dimension") != 1) return "no circle";
  const Rational g = number(j.at("manifold").at("gram").at(0).at(0));
  const Rational epsilon = number(j.at("parameters").at("sampling_radius"));
  if (!(Rational(0) < g) || !(Rational(0) < epsilon)) return "no length";
  const Json& levels = j.at("levels");
  std::string fault;
  if (levels.contains("0")) fault = fault_of_input(j, g, epsilon);
  if (fault.empty() && (levels.contains("1") || levels.contains("2"))) fault = fault_of_stars(j, g);
  if (fault.empty() && levels.contains("2s") &&
      !(Rational(4) * number(levels.at("1").at("circumradius")) +
            Rational(2) * number(j.at("parameters").at("perturbation")) * epsilon <
        Rational(9) * epsilon))
    fault = "balls too large for other charts";
  if (fault.empty() && levels.contains("3")) fault = fault_of_configurations(j, g, epsilon);
  if (fault.empty() && j.at("parameters").at("mode") == "none" && j.at("points") != j.at("net"))
    fault = "points moved in the mode none";
  return fault;
}

}  // namespace delcert::checker_tests
