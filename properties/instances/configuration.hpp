#pragma once

#include "proofs/formula/simplex_object.hpp"

namespace delcert {

/// A (k+1)-simplex of points of a perturbed set with the set's parameters, names as in the instance classes.
struct Configuration {
  SimplexObject::Points points;
  Rational gamma0;
  Rational delta0;
  Rational mu0;
  Rational rho0;
  Rational epsilon;
  Rational perturbed_mu0;
  Rational perturbed_epsilon;
  bool at_boundary = false;

  /// δ = δ₀μ₀′ε′
  [[nodiscard]] Rational protection() const { return delta0 * perturbed_mu0 * perturbed_epsilon; }
  /// (5/2)(1 + δ₀μ₀/2)ε of P3
  [[nodiscard]] Rational edge_bound() const;
  /// α₀ = 2¹³Γ₀/μ₀³ of P1
  [[nodiscard]] Rational hoop_bound() const;
};

/// The least squared distance of two points. Precondition: at least two.
[[nodiscard]] Rational squared_separation(const SimplexObject::Points& points);

/// Whether the vertices are μ₀′ε′ apart and the simplex is a forbidden configuration; decided exactly.
[[nodiscard]] bool is_forbidden_configuration(const Configuration& configuration);
/// Whether the simplex has the properties P1 … P4; decided exactly.
[[nodiscard]] bool has_forbidden_properties(const Configuration& configuration);

/// The same at another size: points and radii multiplied.
[[nodiscard]] Configuration scaled(Configuration configuration, const Rational& factor);

}  // namespace delcert
