#pragma once

#include <algorithm>
#include <bit>

#include "proofs/checker/certificate.hpp"
#include "proofs/checker/faces.hpp"
#include "proofs/checker/simplex.hpp"

namespace delcert::checker {

/// The constants of 3.configuration. Gamma_0 and delta_0 are known by their squares.
struct ConfigurationBounds {
  explicit ConfigurationBounds(const Certificate& c)
      : alpha_squared(Rational(1 << 26) * c.flake_squared.exact / power(c.mu.exact, 6)),
        four_epsilon_squared(Rational(4) * square(c.epsilon.exact)),
        edge_unit(Rational(25) * square(c.epsilon.exact) / Rational(4)),
        mu_delta_squared(square(c.mu.exact) * power(c.flake_squared.exact, c.m + 1)) {
    for (int j = 1; j <= c.m; ++j) thickness_squared.emplace_back(power(c.flake_squared.exact, j));
  }
  Quantity alpha_squared;                   // alpha_0^2
  Quantity four_epsilon_squared;            // (2 epsilon)^2
  Quantity edge_unit;                       // (5/2 epsilon)^2
  Quantity mu_delta_squared;                // (mu_0 delta_0)^2
  std::vector<Quantity> thickness_squared;  // Gamma_0^(2j), from j = 1
};

/// P3 for one edge of squared length e: e / edge_unit < (1 + t/2)^2 with t = mu_0 delta_0, that is
/// e / edge_unit - 1 - t^2/4 < sqrt(t^2).
template <class N>
Verdict is_short(const ConfigurationBounds& bounds, const N& e) {
  const N& t_squared = bounds.mu_delta_squared.as<N>();
  return less_than_root(e / bounds.edge_unit.as<N>() - N(1) - t_squared / N(4), t_squared);
}

/// P1 for the vertex at x from the first vertex of the opposite facet. The point of the circumsphere nearest to it is
/// in the direction of its projection, which is at distance d = sqrt(D^2 - h^2) from the centre, where D is the
/// distance from the centre and h the height: h^2 + (d - R)^2 <= alpha^2 R^2, that is D^2 + R^2 - alpha^2 R^2 <= sqrt(4
/// d^2 R^2).
template <class N>
Verdict near_circumsphere(const Metric& metric, const ConfigurationBounds& bounds, const Simplex<N>& facet,
                          const Vector<N>& x) {
  const N& squared = facet.radius_squared;
  const N distance = squared + metric.squared_length(x) - N(2) * metric.product(x, facet.centre);
  const N projected = distance - facet.squared_height(metric, x);
  return at_most_root(distance + squared - bounds.alpha_squared.as<N>() * squared, N(4) * projected * squared);
}

/// Whether the k + 2 vertices have all of P1 to P4. A degenerate facet is not good (its thickness is 0, Gamma_0 > 0).
template <class N>
Verdict is_forbidden(const Certificate& c, const ConfigurationBounds& bounds, const Vertices& vertices) {
  Verdict result = Verdict::proved;
  for (const Vertices& face : faces_of(vertices)) {
    if (face.size() == 1 || face.size() == vertices.size() || result == Verdict::refuted) continue;
    const std::vector<Vector<N>> corners = c.points.positions<N>(face);
    const Simplex<N> simplex(c.metric, corners);
    if (simplex.non_degenerate != Verdict::proved) return conjunction(result, simplex.non_degenerate);
    result = conjunction(result, simplex.thicker_than(bounds.thickness_squared[face.size() - 2].as<N>()));
    if (face.size() == 2) result = conjunction(result, is_short(bounds, simplex.longest_squared));
    if (face.size() + 1 < vertices.size()) continue;
    const auto opposite = std::find_if(vertices.begin(), vertices.end(), [&](const Vertex& v) {
      return std::none_of(face.begin(), face.end(), [&](const Vertex& w) { return v.label == w.label; });
    });
    const Vector<N> x = c.points.position<N>(*opposite) - corners[0];
    result = conjunction(result, less(simplex.radius_squared, bounds.four_epsilon_squared.as<N>()));
    result = conjunction(result, near_circumsphere(c.metric, bounds, simplex, x));
  }
  return result;
}

}  // namespace delcert::checker
