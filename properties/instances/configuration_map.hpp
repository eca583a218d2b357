#pragma once

#include <optional>
#include <vector>

#include "kernel/simplex/symmetric_matrix.hpp"
#include "proofs/formula/simplex_object.hpp"

namespace delcert {

namespace types {
inline const Type configuration_map{"configuration-map", false};
}  // namespace types

/// A map of one of two forms, with a certificate of its distortion ξ: | |φ(x) − φ(y)| − |x − y| | ≤ ξ|x − y|.
///
/// Of finitely many points: decided for each pair. Or a homeomorphism of all of ℝᵐ:
///   φ(x) = Q((I + E)x + a|⟨w, x⟩ − b|),
/// Q the reflection in the hyperplane orthogonal to `mirror` (the identity for 0), E symmetric with ‖E‖ ≤ `stretch`,
/// and |a||w| ≤ `fold`. Then ξ is stretch + fold, because the two terms after Ix have these Lipschitz constants; and φ
/// is a bijection if their sum is below 1.
class ConfigurationMap : public Object {
 public:
  struct Data {
    std::vector<Rational> mirror;
    std::vector<std::vector<Rational>> stretching;  ///< the rows of E, each up to the diagonal
    Rational stretch;
    std::vector<Rational> fold_direction;  ///< a
    std::vector<Rational> fold_normal;     ///< w
    Rational fold_offset;                  ///< b
    Rational fold;
  };

  struct Finite {
    SimplexObject::Points points;
    SimplexObject::Points images;
    Rational distortion;
  };

  /// Throws InputError, saying why, unless the sizes fit and the certificate holds; decided exactly.
  explicit ConfigurationMap(Data data);
  /// The same. Two points may have the same image only if they are the same.
  explicit ConfigurationMap(Finite finite);

  /// Certified; below 1.
  [[nodiscard]] Rational distortion() const { return finite_ ? finite_->distortion : data_.stretch + data_.fold; }
  [[nodiscard]] std::size_t dimension() const { return finite_ ? finite_->points[0].size() : data_.mirror.size(); }
  /// Throws InputError for points of another dimension, and where the map is not defined.
  [[nodiscard]] SimplexObject::Points image(const SimplexObject::Points& points) const;
  /// Whether it is defined on all of these points.
  [[nodiscard]] bool is_defined_on(const SimplexObject::Points& points) const;
  [[nodiscard]] bool is_finite() const { return finite_.has_value(); }
  /// Precondition: is_finite().
  [[nodiscard]] const Finite& finite() const { return *finite_; }
  /// Precondition: not is_finite().
  [[nodiscard]] const Data& data() const { return data_; }

  [[nodiscard]] nlohmann::ordered_json json() const override;
  [[nodiscard]] static ObjectPointer read(const nlohmann::ordered_json& json);

 private:
  Data data_;
  std::optional<Finite> finite_;
};

}  // namespace delcert
