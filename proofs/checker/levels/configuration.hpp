#pragma once

#include "proofs/checker/certificate/certificate.hpp"
#include "proofs/checker/geometry/simplex.hpp"

namespace delcert::checker {

/// The constants of 3.configuration for labels of the unit 1. Gamma_0 and delta_0 are known by their squares.
struct ConfigurationBounds {
  explicit ConfigurationBounds(const Certificate& c)
      : alpha_squared(Rational(1 << 26) * c.flake_squared.exact / power(c.mu.exact, 6)),
        four_epsilon_squared(Rational(4) * square(c.radius_factor().exact * c.epsilon.exact)),
        edge_unit(Rational(25) * square(c.radius_factor().exact * c.epsilon.exact) / Rational(4)),
        mu_delta_squared(square(c.mu.exact) * power(c.flake_squared.exact, c.m + 1)) {
    for (int j = 1; j <= c.m; ++j) thickness_squared.emplace_back(power(c.flake_squared.exact, j));
  }
  Quantity alpha_squared;                   // alpha_0^2
  Quantity four_epsilon_squared;            // (2 (1 + epsilon_0) epsilon)^2
  Quantity edge_unit;                       // (5/2 (1 + epsilon_0) epsilon)^2
  Quantity mu_delta_squared;                // (mu_0 delta_0)^2
  std::vector<Quantity> thickness_squared;  // Gamma_0^(2j), from j = 1
};

/// P3 for one edge of squared length e, edge_unit that of the configuration: e / edge_unit < (1 + t/2)^2 with t = mu_0
/// delta_0, that is e / edge_unit - 1 - t^2/4 < sqrt(t^2).
template <class N>
Verdict is_short(const ConfigurationBounds& bounds, const N& edge_unit, const N& e) {
  const N& t_squared = bounds.mu_delta_squared.as<N>();
  return less_than_root(e / edge_unit - N(1) - t_squared / N(4), t_squared);
}

/// P1 for the vertex at x from the first vertex of the opposite facet. The point of the circumsphere nearest to it is
/// in the direction of its projection, at distance d = sqrt(D^2 - h^2) from the centre, where D is its own distance
/// from the centre and h its height: h^2 + (d - R)^2 <= alpha^2 R^2, that is D^2 + R^2 - alpha^2 R^2 <= sqrt(4 d^2
/// R^2).
template <class N>
Verdict is_near_circumsphere(const Metric& metric, const ConfigurationBounds& bounds, const Simplex<N>& facet,
                             const Vector<N>& x) {
  const N& squared = facet.radius_squared;
  const N distance = facet.power(x) + squared;
  const N height = facet.dimension() == static_cast<std::size_t>(metric.dimension())
                       ? N(0)
                       : metric.squared_length(facet.perpendicular(x));
  return at_most_root(distance + squared - bounds.alpha_squared.as<N>() * squared,
                      N(4) * (distance - height) * squared);
}

/// Whether the k + 2 vertices have all of P1 to P4. A degenerate facet is not good (its thickness is 0, Gamma_0 > 0).
template <class N>
Verdict is_forbidden(const Certificate& c, const ConfigurationBounds& bounds, const Vertices& vertices) {
  Verdict result = Verdict::proved;
  std::vector<Label> labels;
  for (const Vertex& v : vertices) labels.push_back(v.label);
  const Quantity unit = c.at_least(labels.data(), labels.data() + labels.size(), Quantity(Rational(1)));
  const N squared_unit = square(unit.as<N>());
  const N edge_unit = bounds.edge_unit.as<N>() * squared_unit;
  const N four_epsilon_squared = bounds.four_epsilon_squared.as<N>() * squared_unit;
  const unsigned all = (1u << vertices.size()) - 1;
  for (unsigned subset = 1; subset < all && result != Verdict::refuted; ++subset) {
    Vertices face, rest;
    for (std::size_t k = 0; k < vertices.size(); ++k) ((subset >> k & 1) != 0 ? face : rest).push_back(vertices[k]);
    if (face.size() == 1) continue;
    const std::vector<Vector<N>> corners = c.points.positions<N>(face);
    const Simplex<N> simplex(c.metric, corners);
    if (simplex.complete != Verdict::proved) return conjunction(result, simplex.complete);
    result = conjunction(result, is_thick(c.metric, corners, bounds.thickness_squared[face.size() - 2].as<N>()));
    if (face.size() == 2)
      result = conjunction(result, is_short(bounds, edge_unit, c.points.between<N>(face[0], face[1])));
    if (rest.size() > 1) continue;
    const Vector<N> x = c.points.position<N>(rest[0]) - corners[0];
    result = conjunction(result, less(simplex.radius_squared, four_epsilon_squared));
    result = conjunction(result, is_near_circumsphere(c.metric, bounds, simplex, x));
  }
  return result;
}

}  // namespace delcert::checker
