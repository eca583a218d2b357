#pragma once

#include <vector>

#include "kernel/simplex/symmetric_matrix.hpp"
#include "proofs/formula/simplex_object.hpp"

namespace delcert {

namespace types {
inline const Type configuration_map{"configuration-map", false};
}  // namespace types

/// A homeomorphism of all of ℝᵐ with a certificate of its distortion:
///   φ(x) = Q((I + E)x + a|⟨w, x⟩ − b|),
/// Q the reflection in the hyperplane orthogonal to `mirror` (the identity for 0), E symmetric with ‖E‖ ≤ `stretch`,
/// and |a||w| ≤ `fold`. Then | |φ(x) − φ(y)| − |x − y| | ≤ (stretch + fold)|x − y| for all x, y, because the two terms
/// after Ix have these Lipschitz constants; and φ is a bijection if their sum is below 1.
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

  /// Throws InputError, saying why, unless the sizes fit and the certificate holds; decided exactly.
  explicit ConfigurationMap(Data data);

  /// stretch + fold, below 1.
  [[nodiscard]] Rational distortion() const { return data_.stretch + data_.fold; }
  [[nodiscard]] std::size_t dimension() const { return data_.mirror.size(); }
  [[nodiscard]] SimplexObject::Points image(const SimplexObject::Points& points) const;
  [[nodiscard]] const Data& data() const { return data_; }

  [[nodiscard]] nlohmann::ordered_json json() const override;
  [[nodiscard]] static ObjectPointer read(const nlohmann::ordered_json& json);

 private:
  Data data_;
};

}  // namespace delcert
