#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "proofs/formula/simplex_object.hpp"
#include "properties/instances/exact_point.hpp"

namespace delcert {

namespace types {
inline const Type map{"map", false};
}  // namespace types

/// x ↦ Ax + b on ℝᵐ; A by its rows.
struct LinearMap {
  std::vector<ExactPoint> rows;
  ExactPoint translation;
};

/// x ↦ q + ρ²(x − q)/|x − q|², on the closed ball B(z, radius), which q lies outside of.
struct InversionMap {
  ExactPoint pole;
  Rational squared_power;  ///< ρ²
  ExactPoint centre;       ///< z
  Rational radius;
  Rational distance;  ///< |q − z|
};

/// x ↦ x + Σ a/(1 + (l·x + b)²) on ℝᵐ.
struct SmoothMap {
  struct Bump {
    ExactPoint shift;     ///< a
    ExactPoint covector;  ///< l
    Rational offset;      ///< b
  };
  std::vector<Bump> bumps;
};

/// A transition function of a built-in manifold whose lattice has rational Cartesian coordinates: a translation.
struct TransitionMap {
  std::string manifold;
  std::vector<long> lift;  ///< in the lattice's basis
  ExactPoint translation;
};

/// A bare map of finitely many points; the last ones may be mapped without lying in U.
struct FiniteMap {
  std::vector<ExactPoint> points;
  std::vector<ExactPoint> images;
  std::size_t domain_count = 0;  ///< the first so many points are U
};

/// A map φ: U → V with a distortion that can be certified for all of U: |‖x − y‖ − ‖φ(x) − φ(y)‖| ≤ ξ‖x − y‖.
class MapObject : public Object {
 public:
  using Form = std::variant<LinearMap, InversionMap, SmoothMap, TransitionMap, FiniteMap>;
  explicit MapObject(Form form) : form_(std::move(form)) {}

  [[nodiscard]] const Form& form() const { return form_; }
  /// φ(x); nothing where φ is not defined, and for a point of another dimension.
  [[nodiscard]] std::optional<ExactPoint> image(const ExactPoint& x) const;
  /// Whether x ∈ U.
  [[nodiscard]] bool is_in_domain(const ExactPoint& x) const;
  /// Whether the distortion on U is certainly at most ξ: exactly what it is for linear, inverse, transition and finite
  /// maps; for smooth ones by a Lipschitz bound of the displacement.
  [[nodiscard]] bool has_distortion(const Rational& xi) const;

  /// "linear", "inversion", "smooth", "transition" or "finite".
  [[nodiscard]] std::string form_name() const;
  [[nodiscard]] nlohmann::ordered_json json() const override;
  [[nodiscard]] static ObjectPointer read(const nlohmann::ordered_json& json);

 private:
  Form form_;
};

/// An upper bound of the Lipschitz constant of the displacement: 13/20 Σ |a||l|, for |(1/(1 + u²))′| ≤ 3√3/8 < 13/20.
[[nodiscard]] Rational lipschitz_bound(const SmoothMap& map);

/// A basis of the lattice of a built-in manifold in Cartesian coordinates, by rows, the Cholesky factor of its Gram
/// matrix; nothing where that is not rational. A ball has one chart: no rows. Throws InputError for an unknown name.
[[nodiscard]] std::optional<std::vector<ExactPoint>> rational_lattice(const std::string& manifold);

/// |a − b|².
[[nodiscard]] Rational squared_distance_between(const ExactPoint& a, const ExactPoint& b);

}  // namespace delcert
